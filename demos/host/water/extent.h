// What a scene's water covers, as Seaglass is told of it.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// A description and what it refers to. Moves, but does not copy.
struct SceneExtent {
    SceneExtent() = default;
    SceneExtent(SceneExtent&&) = default;
    SceneExtent& operator=(SceneExtent&&) = default;

    seaglass::ExtentDesc desc;
    std::vector<double> points;
    std::vector<uint32_t> indices;
};

/// False with `error` set when the file that is named cannot be read.
bool extentOf(const ExtentDesc& extent, SceneExtent& out, Error& error);

} // namespace demos
