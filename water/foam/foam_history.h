// The foam that breaking waves leave behind, and the plume of bubbles under it, on the undisplaced grid of
// each cascade that breaks. The grid drifts with the water, so that foam stays with it.
//
// At each step there is what was there, faded, or what breaks now, whichever is more. Plumes are stepped less
// often, by what a crest has broken on its way since the last step, as if it had run unchanged.
#pragma once

#include <vector>

#include "water/foam/foam_steps.h"

namespace seaglass {

class FoamHistory {
  public:
    /// `sea` is to outlive the history. May throw bad_alloc.
    FoamHistory(const Sea& sea, const FoamDesc& foam);

    /// Brings the foam to `step` and the one after it. `state` is the backend's for the sea.
    void advance(const WavesBackend& backend, void* state, int64_t step);

    const Breaking& breaking() const { return breaking_; }
    /// Of a cascade that breaks, samples^2 each, rows along v, of the grid that has drifted.
    struct Band {
        std::vector<float> foam, foamNext;   ///< of a step and the one after it
        std::vector<float> plume, plumeNext; ///< of two steps of plumes, the last that is known among them
    };
    const Band& band(uint32_t cascade) const { return bands_[cascade]; }

  private:
    void stepTo(const WavesBackend& backend, void* state, const FoamStep& step);
    void stepFoam(uint32_t cascade, double time, const FoamStep& step);
    void stepPlume(uint32_t cascade, double time, const FoamStep& step);

    const Sea* sea_;
    Breaking breaking_;
    FoamFadings fading_;
    std::vector<Band> bands_;
    std::vector<float> maps_[3], compression_; ///< scratch
    FoamKnown known_;                          ///< its newest step is what `foamNext` holds
};

} // namespace seaglass
