// The foam that breaking waves have left at one time, stepped from long enough before.
#pragma once

#include <vector>

#include "seaglass/foam.h"

namespace demos::reference {

/// Of each cascade that breaks, samples^2 in rows along v. `state`: the backend's for the sea.
std::vector<std::vector<float>> foamLeft(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                                         const seaglass::WavesBackend& backend, void* state, double timeS);

} // namespace demos::reference
