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

struct Fading {
    float fade, floor;
};

Fading fadingOf(double of, double decaySteps) {
    const double share = std::max(of, 1e-4); // as nothing, it would fade in no time
    const double end = std::exp(-lifetimeInDecays * share);
    return {static_cast<float>(std::exp(-share / decaySteps)), static_cast<float>(end / (1 - end))};
}

/// What is there fades, and what breaks is white.
void step(Band& band, const seaglass::Breaking& breaking, size_t cascade, Fading fading) {
    std::swap(band.before, band.after);
    for (size_t i = 0; i < band.before.size(); ++i) {
        const float compression =
            breaking.compression(band.maps[1][4 * i + 2], band.maps[1][4 * i + 3], band.maps[0][4 * i + 3]);
        const float breaks = (compression - breaking.threshold[cascade]) / breaking.softness[cascade];
        const float fades = (band.before[i] + fading.floor) * fading.fade - fading.floor;
        band.after[i] = std::clamp(breaks, std::max(fades, 0.0f), 1.0f);
    }
}

} // namespace

std::vector<std::vector<float>> foamLeft(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                                         const seaglass::WavesBackend& backend, void* state, double timeS) {
    const seaglass::Breaking breaking = seaglass::breakingOf(sea, foam);
    const double decay = stepsPerSecond * double{foam.decayTime};
    const double now = timeS * stepsPerSecond, whole = std::floor(now);
    const auto lifetime = static_cast<int>(std::ceil(1.07 * lifetimeInDecays * decay)) + 1;
    std::vector<std::vector<float>> left;
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const size_t texels = size_t{seaglass::cascade(sea, c).samples} * seaglass::cascade(sea, c).samples;
        const Fading fading = fadingOf(double{breaking.share[c]}, decay);
        Band band{std::vector<float>(texels), std::vector<float>(texels), {}};
        for (auto& map : band.maps) map.resize(4 * texels);
        for (int back = lifetime; back >= 0; --back) {
            backend.evaluate(state, c, (whole + 1 - back) / stepsPerSecond,
                             {band.maps[0].data(), band.maps[1].data(), band.maps[2].data()});
            step(band, breaking, c, fading);
        }
        const auto past = static_cast<float>(now - whole);
        for (size_t i = 0; i < texels; ++i) band.after[i] = std::lerp(band.before[i], band.after[i], past);
        left.push_back(std::move(band.after));
    }
    return left;
}

} // namespace demos::reference
