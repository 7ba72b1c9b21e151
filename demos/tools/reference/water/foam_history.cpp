#include "reference/water/foam_history.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "water/interface/foam_layers.h"
#include "water/interface/waves_backend.h"
#include "water/interface/whitecaps.h"

namespace demos::reference {

namespace {

// As water/foam/foam_fading.h has them.
constexpr double stepsPerSecond = 4, oddsToFoam = 0.38, foamLifetime = 6, plumeToFoam = 3, plumeLifetime = 3;
constexpr float mostOdds = 9, oddsScale = 10.0f / 9.0f;

struct Fading {
    float fade, floor;
};

Fading fadingOf(double of, double decaySteps, double lifetime, double most) {
    const double share = std::max(of, 1e-4); // as nothing, it would fade in no time
    const double end = std::exp(-lifetime * share);
    return {static_cast<float>(std::exp(-share / decaySteps)), static_cast<float>(most * end / (1 - end))};
}

/// One cascade, and how it breaks.
class Breakers {
  public:
    Breakers(const seaglass::Sea& sea, const seaglass::Breaking& breaking, uint32_t cascade)
        : sea_(sea), breaking_(breaking), index_(cascade), samples_(seaglass::cascade(sea, cascade).samples) {
        for (auto& map : maps_) map.resize(4 * size_t{samples_} * samples_);
    }

    void evaluate(const seaglass::WavesBackend& backend, void* state, double timeS) {
        backend.evaluate(state, index_, timeS, {maps_[0].data(), maps_[1].data(), maps_[2].data()});
        drift_ = seaglass::foamDriftOf(seaglass::description(sea_), seaglass::cascade(sea_, index_), timeS);
    }
    /// What breaks at each place of the drifting grid, or so many seconds' run of a crest ahead of it: raises
    /// `foam` to it.
    void breakOn(std::vector<float>& foam, double aheadS) const {
        const double perMetre = samples_ / seaglass::cascade(sea_, index_).patch;
        const double u = samples_ * drift_.u + aheadS * perMetre * double{breaking_.runs[index_][0]};
        const double v = samples_ * drift_.v + aheadS * perMetre * double{breaking_.runs[index_][1]};
        const double u0 = std::floor(u), v0 = std::floor(v);
        const auto left = static_cast<int64_t>(u0), top = static_cast<int64_t>(v0);
        const auto pastU = static_cast<float>(u - u0), pastV = static_cast<float>(v - v0);
        const int64_t n = samples_;
        for (int64_t j = 0; j < n; ++j)
            for (int64_t i = 0; i < n; ++i) {
                const float high = std::lerp(at(left + i, top + j), at(left + i + 1, top + j), pastU);
                const float low = std::lerp(at(left + i, top + j + 1), at(left + i + 1, top + j + 1), pastU);
                const float breaks =
                    (std::lerp(high, low, pastV) - breaking_.threshold[index_]) / breaking_.softness[index_];
                float& there = foam[static_cast<size_t>(j * n + i)];
                there = std::max(there, std::min(breaks, 1.0f));
            }
    }

  private:
    float at(int64_t i, int64_t j) const {
        const int64_t n = samples_, column = ((i % n) + n) % n, row = ((j % n) + n) % n;
        const auto t = 4 * static_cast<size_t>(row * n + column);
        return breaking_.compression(maps_[1][t + 2], maps_[1][t + 3], maps_[0][t + 3]);
    }

    const seaglass::Sea& sea_;
    const seaglass::Breaking& breaking_;
    uint32_t index_, samples_;
    std::array<std::vector<float>, 3> maps_;
    seaglass::FoamDrift drift_;
};

void fadeOdds(std::vector<float>& foam, Fading by) {
    for (float& white : foam) {
        const float odds = std::max((white / (oddsScale - white) + by.floor) * by.fade - by.floor, 0.0f);
        white = oddsScale * odds / (1 + odds);
    }
}

void fade(std::vector<float>& plume, Fading by) {
    for (float& bubbles : plume) bubbles = std::max((bubbles + by.floor) * by.fade - by.floor, 0.0f);
}

/// Of values of two steps.
void between(const std::vector<float>& before, std::vector<float>& after, double past) {
    for (size_t i = 0; i < after.size(); ++i)
        after[i] = std::lerp(before[i], after[i], static_cast<float>(past));
}

FoamLeft leftIn(Breakers& breakers, const seaglass::FoamDesc& desc, double share, size_t texels,
                const seaglass::WavesBackend& backend, void* state, double timeS) {
    FoamLeft left{std::vector<float>(texels), std::vector<float>(texels)};
    const double decay = double{desc.decayTime}, decaySteps = stepsPerSecond * oddsToFoam * decay;
    const Fading foamFades = fadingOf(share, decaySteps, foamLifetime, double{mostOdds});
    const double now = timeS * stepsPerSecond, whole = std::floor(now);
    std::vector<float> before;
    for (int back = static_cast<int>(std::ceil(1.07 * foamLifetime * decaySteps)) + 1; back >= 0; --back) {
        breakers.evaluate(backend, state, (whole + 1 - back) / stepsPerSecond);
        before = left.foam;
        fadeOdds(left.foam, foamFades);
        breakers.breakOn(left.foam, 0);
    }
    between(before, left.foam, now - whole);

    const Fading plumeFades = fadingOf(share, plumeToFoam * decay, plumeLifetime, 1);
    const double second = std::floor((whole + 1) / stepsPerSecond);
    for (int back = static_cast<int>(std::ceil(1.07 * plumeLifetime * plumeToFoam * decay)) + 1; back >= 0;
         --back) {
        breakers.evaluate(backend, state, second - back);
        before = left.plume;
        fade(left.plume, plumeFades);
        for (const double aheadS : {0.125, 0.375, 0.625, 0.875}) breakers.breakOn(left.plume, aheadS);
    }
    between(before, left.plume, timeS + 1 / stepsPerSecond - second);
    return left;
}

} // namespace

std::vector<FoamLeft> foamLeft(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                               const seaglass::WavesBackend& backend, void* state, double timeS) {
    const seaglass::Breaking breaking = seaglass::breakingOf(sea, foam);
    std::vector<FoamLeft> left;
    for (uint32_t c = 0; c < breaking.count; ++c) {
        const size_t samples = seaglass::cascade(sea, c).samples;
        Breakers breakers(sea, breaking, c);
        left.push_back(
            leftIn(breakers, foam, double{breaking.share[c]}, samples * samples, backend, state, timeS));
    }
    return left;
}

} // namespace demos::reference
