// What is looked at of one technique.
#pragma once

#include "host/host.h"

namespace demos::measure {

/// All of one size: linear as the host gives them.
struct Shots {
    Picture color;      ///< Aov::color
    Picture reflection; ///< Aov::reflection
    Picture sources;    ///< Aov::reflectionSource
    Picture scene;      ///< Aov::scene: what techniques look up on the screen, and the same for all of them
};

/// `frame.aov` does not matter. `out.scene` is drawn where it is empty.
bool takeShots(Host& host, const FrameDesc& frame, Shots& out, Error& error);

} // namespace demos::measure
