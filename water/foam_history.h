// The foam that breaking waves leave behind, on the undisplaced grid of each cascade that breaks, so that it
// drifts with the water drawn and never swims over it.
//
// Foam F lies in 0..1. At each step it is what was there, faded, or what breaks now, whichever is more.
// Fading is F <- (F + floor) fade - floor: exponential but for the end, which comes after `lifetime` decay
// times. A history that begins a lifetime before is therefore the same as one without a beginning.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "water/whitecaps.h"

namespace seaglass {

constexpr double foamStepsPerSecond = 4; ///< a power of two: times of steps are exact
constexpr double foamLifetime = 3;       ///< in decay times

struct FoamFading {
    float fade = 0; ///< of F + floor, a step
    float floor = 0;
    int64_t steps = 0; ///< after which any foam has gone
};

FoamFading fadingOf(const FoamDesc& foam);

/// Of the sea when it makes a step's foam [s]: exact.
constexpr double foamStepTime(int64_t step) {
    return static_cast<double>(step) / foamStepsPerSecond;
}

/// What is to be computed for a step and the one after it to be known. From a step shortly before only what
/// lies between; on the first call, backwards or after a gap a whole lifetime, from nothing.
struct FoamSteps {
    bool anew = false;
    int64_t first = 0;
    int64_t last = 0; ///< before `first` when nothing is to be done
};

/// `newest` is the latest step that is known.
FoamSteps stepsUntil(std::optional<int64_t> newest, int64_t step, const FoamFading& fading);

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
    void stepTo(const WavesBackend& backend, void* state, int64_t step);

    Breaking breaking_;
    FoamFading fading_;
    std::vector<Band> bands_;
    std::vector<float> maps_[3];    ///< scratch
    std::optional<int64_t> newest_; ///< the step that `next` holds
};

} // namespace seaglass
