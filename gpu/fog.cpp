#include "seaglass/fog.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gpu/held_in.h"
#include "gpu/interface/fields/fog.h"

namespace seaglass {

namespace {

constexpr double endless = 1e9;         // [m]
constexpr double farOff = 1e30;         // [m]; no height is farther
constexpr double leastThickness = 1e-6; // [m]; from where a linear fog begins to where it hides all

/// With each field in its range, so that the formulas give numbers of what draw() would refuse.
FogDesc heldInRanges(FogDesc desc) {
    for (const Field& field : fogFields)
        for (uint32_t i = 0; i < field.count; ++i)
            field.set(&desc, i, heldIn(field.low, field.high, field.get(&desc, i)));
    return desc;
}

double thicknessOf(const FogDesc& linear) {
    return std::max(double{linear.end} - double{linear.start}, leastThickness);
}

/// Mean of exp(-x) from `a` to `b`; kept from infinity far below the fog's base.
double meanOfExp(double a, double b) {
    const double apart = std::abs(b - a);
    const double share = apart > 0 ? -std::expm1(-apart) / apart : 1;
    return std::exp(-std::max(std::min(a, b), -50.0)) * share;
}

double transmittance(const FogDesc& desc, double from, double rise, double way) {
    const double density = double{desc.density};
    switch (desc.shape) {
    case FogShape::linear:
        return std::clamp((double{desc.end} - way) / thicknessOf(desc), 0.0, 1.0);
    case FogShape::exponentialSquared:
        return std::exp(-density * way * density * way);
    case FogShape::height: {
        const double above = double{desc.falloff} * (from - desc.baseHeight);
        return std::exp(-density * way * meanOfExp(above, above + double{desc.falloff} * rise));
    }
    default:
        return std::exp(-density * way);
    }
}

} // namespace

// What the shape does not read is 0, whatever the description holds there.
FogBlock fogBlock(const FogDesc& given, double eyeHeight) {
    const FogDesc desc = heldInRanges(given);
    const bool linear = desc.shape == FogShape::linear, height = desc.shape == FogShape::height;
    const double above =
        height ? double{desc.falloff} * (heldWithin(farOff, eyeHeight) - desc.baseHeight) : 0;
    return {{desc.color[0], desc.color[1], desc.color[2], desc.fromSky},
            {linear ? 0 : desc.density, height ? desc.falloff : 0, static_cast<float>(above), desc.most},
            {linear ? desc.end : 0, linear ? static_cast<float>(1 / thicknessOf(desc)) : 0,
             static_cast<float>(desc.shape), desc.overSky ? 1.0f : 0.0f}};
}

double fogTransmittance(const FogDesc& given, double from, double rise, double way) {
    const FogDesc desc = heldInRanges(given);
    way = heldIn(0.0, std::numeric_limits<double>::max(), way);
    const double share = std::min(endless / std::max(way, 1e-9), 1.0);
    const double rises = heldWithin(way, rise) * share;
    const double passes = transmittance(desc, heldWithin(farOff, from), rises, way * share);
    return 1 - double{desc.most} * (1 - passes);
}

} // namespace seaglass
