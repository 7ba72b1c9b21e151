#include "water/interface/foam_layers.h"

#include <algorithm>
#include <cmath>

#include "water/sea/phase.h"

namespace seaglass {
namespace {

// The surface drifts at so much of the wind at 10 m, Stokes drift included (Wu 1975).
constexpr double driftOfWind = 0.035;

FoamLayer layerOf(const SeaDesc& sea, double stretch, double time, double repeat) {
    const double length = std::sqrt(1 - 1 / stretch), direction = sea.windDirection;
    const double along[] = {std::cos(direction), std::sin(direction)};
    // Whole repeats in a loop, so that it loops exactly. In the layer all is shorter along the wind.
    const uint32_t now = loopPhase(time, sea.loopPeriod);
    const auto drift = [&](double part) {
        const double wanted = driftOfWind * double{sea.windSpeed} / stretch * part;
        const auto turns = static_cast<int32_t>(std::lround(wanted * sea.loopPeriod / repeat));
        return static_cast<double>(static_cast<uint32_t>(turns) * now) * 0x1p-32 * repeat;
    };
    return {length * along[0], length * along[1], drift(along[0]), drift(along[1])};
}

/// In which a grid drifts by whole samples along both axes: a whole part of a loop [s].
double driftPeriod(double loopPeriod) {
    constexpr double wanted = 1024; // longer would follow the wind better than anyone sees
    return loopPeriod / std::max(std::round(loopPeriod / wanted), 1.0);
}

} // namespace

FoamDrift foamDriftOf(const SeaDesc& sea, const Cascade& cascade, double time) {
    const double period = driftPeriod(sea.loopPeriod), sample = cascade.patch / cascade.samples;
    const uint32_t now = loopPhase(time, period * cascade.samples);
    const auto drift = [&](double part) {
        const double wanted = driftOfWind * double{sea.windSpeed} * part;
        const auto samples = static_cast<int32_t>(std::lround(wanted * period / sample));
        return static_cast<double>(static_cast<uint32_t>(samples) * now) * 0x1p-32;
    };
    return {drift(std::cos(double{sea.windDirection})), drift(std::sin(double{sea.windDirection}))};
}

FoamLayer foamLaceOf(const SeaDesc& sea, double time, double repeat) {
    return layerOf(sea, 1 + std::clamp((double{sea.windSpeed} - 8) / 12, 0.0, 1.0), time, repeat);
}

FoamLayer foamWindrowsOf(const SeaDesc& sea, double time, double repeat) {
    return layerOf(sea, 1 + std::clamp((double{sea.windSpeed} - 10) / 1.5, 0.0, 4.0), time, repeat);
}

} // namespace seaglass
