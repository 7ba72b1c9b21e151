#include "water/foam/foam_fading.h"

namespace seaglass {
namespace {

// Of foam's decay time, that of its odds: fitted to Monahan and Zietlow's 3.85 s (docs/physics.md).
constexpr double oddsToFoam = 0.38;
constexpr double foamLifetime = 6; ///< in its decay times
// Bubbles stay below for longer than foam above: our own measure, for "tens of seconds".
constexpr double plumeToFoam = 3;
constexpr double plumeLifetime = 3; ///< in its decay times

/// To 1/e in so many steps, times the share; from `most`.
Fading fadingTo(double share, double steps, double lifetime, double most) {
    const double end = std::exp(-lifetime * share);
    Fading fading;
    fading.fade = static_cast<float>(std::exp(-share / steps));
    fading.floor = static_cast<float>(most * end / (1 - end));
    // Half floats may round each step up: by 6 % of what it takes off at the slowest fading.
    fading.steps = static_cast<int64_t>(std::ceil(1.07 * lifetime * steps)) + 1;
    return fading;
}

} // namespace

double oddsDecayTime(const FoamDesc& foam) {
    return oddsToFoam * double{foam.decayTime};
}

FoamFading fadingOf(const FoamDesc& foam, float of) {
    // What has no share would fade to nothing, in no time that floats tell from never.
    const double share = std::max(static_cast<double>(of), 1e-4);
    const double plumeSteps =
        foamStepsPerSecond / static_cast<double>(foamStepsPerPlume) * plumeToFoam * double{foam.decayTime};
    return {fadingTo(share, foamStepsPerSecond * oddsDecayTime(foam), foamLifetime, double{foamMostOdds}),
            fadingTo(share, plumeSteps, plumeLifetime, 1)};
}

FoamFadings fadingsOf(const FoamDesc& foam, const Breaking& breaking) {
    FoamFadings fadings;
    for (uint32_t c = 0; c < breaking.count; ++c) fadings[c] = fadingOf(foam, breaking.share[c]);
    return fadings;
}

} // namespace seaglass
