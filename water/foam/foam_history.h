// The foam that breaking waves leave behind, on the undisplaced grid of each cascade that breaks, so that it
// drifts with the water drawn and never swims over it.
//
// Foam F lies in 0..1. At each step it is what was there, faded, or what breaks now, whichever is more.
// Fading is F <- (F + floor) fade - floor: exponential but for the end, which comes after `lifetime` decay
// times. A history that begins a lifetime before is therefore the same as one without a beginning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "water/interface/whitecaps.h"

namespace seaglass {

constexpr double foamStepsPerSecond = 4; ///< a power of two: times of steps are exact
constexpr double foamLifetime = 3;       ///< in decay times

struct FoamFading {
    float fade = 0; ///< of F + floor, a step
    float floor = 0;
    int64_t steps = 0; ///< after which any foam has gone
    /// Of several steps at once.
    float over(int64_t count) const { return count == 1 ? fade : std::pow(fade, static_cast<float>(count)); }
};

/// Of a cascade that does a `share` of the breaking: the product of all fades to 1/e in a decay time.
FoamFading fadingOf(const FoamDesc& foam, float share = 1);

/// Of each cascade that breaks; all take as many steps.
using FoamFadings = std::array<FoamFading, maxCascades>;
FoamFadings fadingsOf(const FoamDesc& foam, const Breaking& breaking);

/// Of the sea when it makes a step's foam [s]: exact.
constexpr double foamStepTime(int64_t step) {
    return static_cast<double>(step) / foamStepsPerSecond;
}

/// That a call computes which finds more to catch up than that, right after another that did. Else a device
/// whose frames take longer than what they catch up has ever more to do.
constexpr int64_t mostFoamSteps = 8;

/// How far a history is.
struct FoamKnown {
    std::optional<int64_t> newest; ///< the latest step that is known
    bool caughtUp = false;         ///< the call before had more than mostFoamSteps to compute
};

/// What is to be computed for a step and the one after it to be known. From a step shortly before only what
/// lies between; on the first call, backwards or after a gap a whole lifetime, from nothing. A call that
/// comes late after one that had to catch up takes mostFoamSteps at even distances instead of them all.
struct FoamSteps {
    bool anew = false;
    bool caughtUp = false; ///< for FoamKnown
    int64_t before = 0;    ///< the step that the first is computed from, or that lies a step before all
    int64_t last = 0;
    int64_t count = 0; ///< to be computed, `last` among them

    /// Of 0 to `count`: `before`, then what is computed.
    int64_t at(int64_t i) const {
        if (i == count) return last;
        const int64_t parts = std::max<int64_t>(count - 1, 1);
        return before + (i * (last - before - 1) + parts - 1) / parts;
    }
    /// Of what is computed: how many steps' fading lies before it.
    int64_t fadings(int64_t i) const { return at(i) - at(i - 1); }
};

FoamSteps stepsUntil(const FoamKnown& known, int64_t step, const FoamFading& fading);

/// Where `time` lies between steps.
struct FoamTime {
    int64_t step = 0; ///< the last one not after it
    float past = 0;   ///< share of the way to the next, 0..1
};

FoamTime foamTimeOf(double time, double loopPeriod);

class FoamHistory {
  public:
    /// `sea` is to outlive the history. May throw bad_alloc.
    FoamHistory(const Sea& sea, const FoamDesc& foam);

    /// Brings the foam to `step` and the one after it. `state` is the backend's for the sea.
    void advance(const WavesBackend& backend, void* state, int64_t step);

    const Breaking& breaking() const { return breaking_; }
    /// samples^2 of a cascade that breaks, rows along v.
    const std::vector<float>& at(uint32_t cascade) const { return bands_[cascade].now; }
    const std::vector<float>& after(uint32_t cascade) const { return bands_[cascade].next; }

  private:
    struct Band {
        std::vector<float> now;
        std::vector<float> next;
    };
    void clear();
    void stepTo(const WavesBackend& backend, void* state, int64_t step, int64_t fadings);

    Breaking breaking_;
    FoamFadings fading_;
    std::vector<Band> bands_;
    std::vector<float> maps_[3]; ///< scratch
    FoamKnown known_;            ///< its newest step is what `next` holds
};

} // namespace seaglass
