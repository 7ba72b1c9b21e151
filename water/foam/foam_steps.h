// Which steps bring a history of foam to a time, whatever frames were drawn before.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "water/foam/foam_fading.h"

namespace seaglass {

/// That a call computes which finds more to catch up than that, right after another that did. Else a device
/// whose frames take longer than what they catch up has ever more to do.
constexpr int64_t mostFoamSteps = 8;

/// How far a history is.
struct FoamKnown {
    std::optional<int64_t> newest; ///< the latest step that is known
    bool caughtUp = false;         ///< the call before had more than mostFoamSteps to compute
};

/// One evaluation of the sea, and what it changes.
struct FoamStep {
    int64_t step = 0;
    int64_t fadings = 0;                      ///< how many steps' fading of foam lies before it
    int64_t plumeFadings = 0;                 ///< likewise of plumes; 0: they stay as they are
    bool foamAnew = false, plumeAnew = false; ///< there was none before
};

/// What is to be computed for a step and the one after it to be known. From a step shortly before only what
/// lies between; on the first call, backwards or after a gap a whole lifetime, from nothing: of plumes alone
/// while foam of that time is long gone. A call that comes late after one that had to catch up takes
/// mostFoamSteps at even distances instead of them all, and no plumes before them.
struct FoamSteps {
    bool anew = false;
    bool caughtUp = false; ///< for FoamKnown
    int64_t before = 0;    ///< the step that the first is computed from, or that lies a step before all
    int64_t last = 0;
    int64_t count = 0;       ///< to be computed after `before`, `last` among them
    int64_t plumesAlone = 0; ///< to be computed of plumes until `before`

    int64_t all() const { return plumesAlone + count; }
    FoamStep at(int64_t i) const; ///< 0 to all() - 1
};

FoamSteps stepsUntil(const FoamKnown& known, int64_t step, const FoamFading& fading);

/// Where `time` lies between steps.
struct FoamTime {
    int64_t step = 0;    ///< the last one not after it
    float past = 0;      ///< share of the way to the next, 0..1
    float pastPlume = 0; ///< likewise of plumes; what is drawn of these is 3/4 s old
};

FoamTime foamTimeOf(double time, double loopPeriod);

} // namespace seaglass
