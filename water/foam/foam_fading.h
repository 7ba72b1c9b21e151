// How foam, and the bubbles below it, fade from one step to the next.
//
// Foam F lies in 0..1, and its odds O = F / (10/9 - F) fade: O <- (O + floor) fade - floor. So little foam
// goes as an exponential, while foam that is thick stays white for longer: whitecaps that broke strongly,
// which are the large ones, outlast small ones (Callaghan et al. 2012). A plume P of bubbles fades by itself
// likewise, without odds. All ends after a lifetime, so that a history that begins one before is the same as
// one without a beginning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "shaders/shared/foam/foam_fading.h"
#include "water/interface/whitecaps.h"

namespace seaglass {

constexpr double foamStepsPerSecond = 4; ///< a power of two: times of steps are exact
constexpr int64_t foamStepsPerPlume = 4; ///< a plume is stepped each second

/// Of the sea when it makes a step's foam [s]: exact.
constexpr double foamStepTime(int64_t step) {
    return static_cast<double>(step) / foamStepsPerSecond;
}

/// A step of plumes looks ahead for the crests that have just run over a place: so long after, `tap` from 0
/// on [s].
constexpr int plumeTaps = 4;
constexpr double plumeTap(int tap) {
    return (tap + 0.5) / plumeTaps * foamStepsPerPlume / foamStepsPerSecond;
}

struct Fading {
    float fade = 0; ///< a step
    float floor = 0;
    int64_t steps = 0; ///< after which nothing is left
    /// Of several steps at once.
    float over(int64_t count) const { return count == 1 ? fade : std::pow(fade, static_cast<float>(count)); }
};

struct FoamFading {
    Fading foam, plume;
};

/// In which the odds of foam fade to 1/e, so that its whitecaps do in `decayTime` in the mean [s].
double oddsDecayTime(const FoamDesc& foam);

/// Of a cascade that does a `share` of the breaking: the product of all fades as one would alone.
FoamFading fadingOf(const FoamDesc& foam, float share = 1);

/// Of each cascade that breaks; all take as many steps.
using FoamFadings = std::array<FoamFading, maxCascades>;
FoamFadings fadingsOf(const FoamDesc& foam, const Breaking& breaking);

/// What is left of foam, 0..1, by a step's fade and floor.
inline float fadedFoam(float foam, float fade, float floor) {
    const float odds = std::max((foam / (foamOddsScale - foam) + floor) * fade - floor, 0.0f);
    return foamOddsScale * odds / (1 + odds);
}

inline float fadedPlume(float plume, float fade, float floor) {
    return std::max((plume + floor) * fade - floor, 0.0f);
}

} // namespace seaglass
