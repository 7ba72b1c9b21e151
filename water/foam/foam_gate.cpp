#include "water/interface/foam_gate.h"

#include <algorithm>
#include <cmath>

#include "water/interface/wrapped_cell.h"
#include "water/sea/phase.h"
#include "water/sea/sea.h"

namespace seaglass {
namespace {

constexpr double secondsATurn = 40;
// Of the noise: `least` of the foam is seen below the first, all above the second.
constexpr float opens = 0.5f, isOpen = 0.75f, least = 0.3f;

constexpr double fewestCells = 6, mostCells = 1024;
constexpr double wavesAGroup = 3;

/// Across the largest tile, of which the wind's waves alone would make 16 of their lengths.
int cellsOf(const Sea& sea) {
    double lengths = 0;
    for (uint32_t i = 0; i < sea.systems.count && sea.count > 0; ++i) {
        const Spectrum& spectrum = sea.systems.system[i].spectrum;
        if (spectrum.form == Spectrum::Form::swell) continue;
        lengths = std::max(lengths, sea.cascades[0].patch / peakWavelength(spectrum, sea.systems.depth));
    }
    return static_cast<int>(std::clamp(std::round(lengths / wavesAGroup), fewestCells, mostCells));
}

float smooth(float x) {
    return x * x * (3 - 2 * x);
}

} // namespace

FoamGate::FoamGate(const Sea& sea, double time)
    : even_(!(sea.desc.warp > 0)), cells_(cellsOf(sea)),
      turns_(static_cast<uint32_t>(std::max(std::round(sea.desc.loopPeriod / secondsATurn), 1.0))),
      now_(loopPhase(time, sea.desc.loopPeriod)) {}

int32_t FoamGate::firstCell(double tiles) const {
    return wrappedCell(cells_ * std::floor(tiles));
}

float FoamGate::corner(uint32_t cellU, uint32_t cellV) const {
    uint32_t bits = cellU * 0x9e3779b9u ^ cellV * 0x85ebca6bu;
    bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du;
    bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
    bits ^= bits >> 15;
    const uint32_t phase = bits + (turns_ + ((bits & 255u) * turns_ >> 9)) * now_;
    return std::abs(static_cast<float>(static_cast<int32_t>(phase))) * 0x1p-31f;
}

float FoamGate::at(double tilesU, double tilesV) const {
    if (even_) return 1;
    const double u = cells_ * (tilesU - std::floor(tilesU));
    const double v = cells_ * (tilesV - std::floor(tilesV));
    const double left = std::floor(u), top = std::floor(v);
    const uint32_t i = static_cast<uint32_t>(firstCell(tilesU)) + static_cast<uint32_t>(left);
    const uint32_t j = static_cast<uint32_t>(firstCell(tilesV)) + static_cast<uint32_t>(top);
    const float x = smooth(static_cast<float>(u - left)), y = smooth(static_cast<float>(v - top));
    const float noise = std::lerp(std::lerp(corner(i, j), corner(i + 1, j), x),
                                  std::lerp(corner(i, j + 1), corner(i + 1, j + 1), x), y);
    return std::lerp(least, 1.0f, smooth(std::clamp((noise - opens) / (isOpen - opens), 0.0f, 1.0f)));
}

} // namespace seaglass
