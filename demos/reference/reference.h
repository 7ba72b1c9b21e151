// The ray-traced reference: the scene that the host renders, with its water traced instead of approximated.
#pragma once

#include <functional>

#include "host/host.h"
#include "reference/truth.h"

namespace demos::reference {

struct Pictures {
    Picture color; ///< linear, as the host's
    /// Class, the mirrored point's pixel (x, y), its distance from the water [m]: see Truth. Empty unless
    /// asked for.
    Picture truth;
    Picture mirrored; ///< linear, what the water mirrors before Fresnel; black elsewhere. Empty as truth is
};

/// Is told rows done and rows in all, by one thread at a time; false leaves the rest undone.
using ProgressFunction = std::function<bool(uint32_t, uint32_t)>;

Pictures renderReference(const Frame& frame, bool withTruth, const ProgressFunction& progress = {});

} // namespace demos::reference
