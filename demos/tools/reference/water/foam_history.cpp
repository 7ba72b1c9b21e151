#include "reference/water/foam_history.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "water/interface/whitecaps.h"

namespace demos::reference {

namespace {

constexpr double stepsPerSecond = 4, lifetimeInDecays = 3;

/// Of one cascade.
struct Band {
    std::vector<float> before, after; ///< a step's foam, and the next one's
    std::array<std::vector<float>, 3> maps;
};

/// What is there fades, and what breaks is white.
void step(Band& band, float threshold, float softness, float fade, float floor) {
    std::swap(band.before, band.after);
    for (size_t i = 0; i < band.before.size(); ++i) {
        const float shear = band.maps[0][4 * i + 3];
        const float area = (1 + band.maps[1][4 * i + 2]) * (1 + band.maps[1][4 * i + 3]) - shear * shear;
        const float breaks = (threshold - area) / softness;
        const float fades = (band.before[i] + floor) * fade - floor;
        band.after[i] = std::clamp(breaks, std::max(fades, 0.0f), 1.0f);
    }
}

} // namespace

std::vector<std::vector<float>> foamLeft(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                                         const seaglass::WavesBackend& backend, void* state, double timeS) {
    const seaglass::Breaking breaking = seaglass::breakingOf(sea, foam);
    const double decay = stepsPerSecond * double{foam.decayTime}, end = std::exp(-lifetimeInDecays);
    const auto fade = static_cast<float>(std::exp(-1 / decay)), floor = static_cast<float>(end / (1 - end));
    const double now = timeS * stepsPerSecond, whole = std::floor(now);
    const auto lifetime = static_cast<int>(std::ceil(1.05 * lifetimeInDecays * decay)) + 1;
    std::vector<std::vector<float>> left;
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const size_t texels = size_t{seaglass::cascade(sea, c).samples} * seaglass::cascade(sea, c).samples;
        Band band{std::vector<float>(texels), std::vector<float>(texels), {}};
        for (auto& map : band.maps) map.resize(4 * texels);
        for (int back = lifetime; back >= 0; --back) {
            backend.evaluate(state, c, (whole + 1 - back) / stepsPerSecond,
                             {band.maps[0].data(), band.maps[1].data(), band.maps[2].data()});
            step(band, breaking.threshold[c], breaking.softness[c], fade, floor);
        }
        const auto past = static_cast<float>(now - whole);
        for (size_t i = 0; i < texels; ++i) band.after[i] = std::lerp(band.before[i], band.after[i], past);
        left.push_back(std::move(band.after));
    }
    return left;
}

} // namespace demos::reference
