// The ray-traced reference: the scene that the host renders, with its water traced instead of approximated.
#pragma once

#include "host/host.h"
#include "reference/rows.h"
#include "reference/truth.h"

namespace demos::reference {

struct Pictures {
    Picture color; ///< linear, as the host's
    /// Class, the mirrored point's pixel (x, y), its distance from the water [m]: see Truth. Empty unless
    /// asked for.
    Picture truth;
    Picture mirrored; ///< linear, what the water mirrors before Fresnel; black elsewhere. Empty as truth is
};

Pictures renderReference(const Frame& frame, bool withTruth, const ProgressFunction& progress = {});

} // namespace demos::reference
