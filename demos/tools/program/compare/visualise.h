// Pictures of things that are not light, for looking at.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/host.h"

namespace demos {

struct Visualised {
    std::vector<uint8_t> rgb;
    std::string scale; ///< what grey stands for; empty when it needs no words
};

/// Colour and reflection are tone-mapped; classes and overlays as they are; normals 0.5 + 0.5 n; height grey
/// around mid grey; foam grey; depth logarithmic grey, the nearest white, the farthest and the sky black.
/// Sources: red across the picture, green down it, black where there is none.
Visualised visualise(const Picture& picture, Aov aov, double exposureEv);

} // namespace demos
