// The foam that breaking waves have left at one time, and the bubbles below it, stepped from long enough
// before.
#pragma once

#include <vector>

#include "seaglass/sea.h"

namespace demos::reference {

/// samples^2 each in rows along v, of a grid that has drifted with the water.
struct FoamLeft {
    std::vector<float> foam, plume;
};

/// Of each cascade that breaks. `state`: the backend's for the sea.
std::vector<FoamLeft> foamLeft(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                               const seaglass::WavesBackend& backend, void* state, double timeS);

} // namespace demos::reference
