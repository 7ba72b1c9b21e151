#include "water/foam/foam_history.h"

#include "water/sea/sea.h"

#include <algorithm>
#include <cmath>

namespace seaglass {
FoamFading fadingOf(const FoamDesc& foam, float of) {
    // What has no share would fade to nothing, in no time that floats tell from never.
    const double share = std::max(static_cast<double>(of), 1e-4);
    const double steps = foamStepsPerSecond * static_cast<double>(foam.decayTime);
    const double end = std::exp(-foamLifetime * share);
    FoamFading fading;
    fading.fade = static_cast<float>(std::exp(-share / steps));
    fading.floor = static_cast<float>(end / (1 - end));
    // Half floats may round each step up: by 6 % of what it takes off at the slowest fading.
    fading.steps = static_cast<int64_t>(std::ceil(1.07 * foamLifetime * steps)) + 1;
    return fading;
}

FoamFadings fadingsOf(const FoamDesc& foam, const Breaking& breaking) {
    FoamFadings fadings;
    for (uint32_t c = 0; c < breaking.count; ++c) fadings[c] = fadingOf(foam, breaking.share[c]);
    return fadings;
}

FoamSteps stepsUntil(const FoamKnown& known, int64_t step, const FoamFading& fading) {
    const int64_t last = step + 1;
    const bool forward = known.newest && last >= *known.newest;
    const bool near = forward && last - *known.newest <= fading.steps;
    FoamSteps steps;
    steps.anew = !near;
    steps.before = near ? *known.newest : last - fading.steps - 1;
    steps.last = last;
    const int64_t all = last - steps.before;
    steps.caughtUp = all > mostFoamSteps;
    steps.count = forward && known.caughtUp ? std::min(all, mostFoamSteps) : all;
    return steps;
}

FoamTime foamTimeOf(double time, double loopPeriod) {
    // Later than this a double no longer tells steps apart.
    const double kept = std::abs(time) < 0x1p48 ? time : std::fmod(time, loopPeriod);
    const double steps = kept * foamStepsPerSecond;
    const double whole = std::floor(steps);
    return {static_cast<int64_t>(whole), static_cast<float>(steps - whole)};
}

FoamHistory::FoamHistory(const Sea& sea, const FoamDesc& foam)
    : breaking_(breakingOf(sea, foam)), fading_(fadingsOf(foam, breaking_)), bands_(breaking_.count) {
    if (breaking_.count == 0) return;
    const size_t texels = size_t{sea.desc.samples} * sea.desc.samples;
    for (Band& band : bands_) {
        band.now.assign(texels, 0.0f);
        band.next.assign(texels, 0.0f);
    }
    for (auto& map : maps_) map.assign(4 * texels, 0.0f);
}

void FoamHistory::advance(const WavesBackend& backend, void* state, int64_t step) {
    const FoamSteps steps = stepsUntil(known_, step, fading_[0]);
    if (steps.anew) clear();
    for (int64_t i = 1; i <= steps.count; ++i) stepTo(backend, state, steps.at(i), steps.fadings(i));
    known_ = {steps.last, steps.caughtUp};
}

void FoamHistory::clear() {
    for (Band& band : bands_) {
        std::ranges::fill(band.now, 0.0f);
        std::ranges::fill(band.next, 0.0f);
    }
}

void FoamHistory::stepTo(const WavesBackend& backend, void* state, int64_t step, int64_t fadings) {
    for (uint32_t c = 0; c < breaking_.count; ++c) {
        backend.evaluate(state, c, foamStepTime(step), {maps_[0].data(), maps_[1].data(), maps_[2].data()});
        Band& band = bands_[c];
        std::swap(band.now, band.next);
        const float threshold = breaking_.threshold[c], perCompression = 1 / breaking_.softness[c];
        const float floor = fading_[c].floor, fade = fading_[c].over(fadings);
        for (size_t i = 0; i < band.now.size(); ++i) {
            const float compression =
                breaking_.compression(maps_[1][4 * i + 2], maps_[1][4 * i + 3], maps_[0][4 * i + 3]);
            const float breaks = std::min((compression - threshold) * perCompression, 1.0f);
            const float faded = (band.now[i] + floor) * fade - floor;
            band.next[i] = std::max(std::max(faded, breaks), 0.0f);
        }
    }
}

} // namespace seaglass
