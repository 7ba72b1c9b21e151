#include "water/foam/foam_steps.h"

#include <cmath>

namespace seaglass {
namespace {

/// The last step of plumes that is none after a step of foam.
int64_t plumeStepAt(int64_t step) {
    const int64_t whole = step / foamStepsPerPlume;
    return step % foamStepsPerPlume < 0 ? whole - 1 : whole;
}

} // namespace

FoamStep FoamSteps::at(int64_t i) const {
    if (i < plumesAlone) {
        const int64_t plume = plumeStepAt(before) - plumesAlone + 1 + i;
        return {plume * foamStepsPerPlume, 1, 1, true, i == 0};
    }
    const auto stepOf = [&](int64_t n) {
        if (n == count) return last;
        const int64_t parts = std::max<int64_t>(count - 1, 1);
        return before + (n * (last - before - 1) + parts - 1) / parts;
    };
    const int64_t n = i - plumesAlone + 1, here = stepOf(n), earlier = stepOf(n - 1);
    return {here, here - earlier, plumeStepAt(here) - plumeStepAt(earlier), anew && n == 1, anew && i == 0};
}

FoamSteps stepsUntil(const FoamKnown& known, int64_t step, const FoamFading& fading) {
    const int64_t last = step + 1;
    const bool forward = known.newest && last >= *known.newest;
    const bool near = forward && last - *known.newest <= fading.foam.steps;
    FoamSteps steps;
    steps.anew = !near;
    steps.before = near ? *known.newest : last - fading.foam.steps - 1;
    steps.last = last;
    const int64_t all = last - steps.before;
    steps.caughtUp = all > mostFoamSteps;
    steps.count = forward && known.caughtUp ? std::min(all, mostFoamSteps) : all;
    // The image holds two steps of plumes, either of which has a whole lifetime before it.
    if (steps.anew && !(forward && known.caughtUp))
        steps.plumesAlone =
            std::max<int64_t>(fading.plume.steps + 1 - (plumeStepAt(last) - plumeStepAt(steps.before)), 0);
    return steps;
}

FoamTime foamTimeOf(double time, double loopPeriod) {
    // Later than this a double no longer tells steps apart.
    const double kept = std::abs(time) < 0x1p48 ? time : std::fmod(time, loopPeriod);
    const double steps = kept * foamStepsPerSecond;
    const double whole = std::floor(steps);
    const auto step = static_cast<int64_t>(whole);
    const double past = steps - whole;
    // The image holds the step after `step`: since so many steps it has the plumes that it has.
    const int64_t since = step + 1 - foamStepsPerPlume * plumeStepAt(step + 1);
    return {step, static_cast<float>(past),
            static_cast<float>((static_cast<double>(since) + past) / foamStepsPerPlume)};
}

} // namespace seaglass
