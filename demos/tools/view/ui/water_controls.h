// What the panel lets change of a scene's water.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace demos {

/// Each is true once a change is complete.
bool layOutWater(WaterDesc& water);
bool layOutQuality(WaterDesc& water);
/// Whether the scene is mirrored, and how.
bool layOutMirror(std::optional<seaglass::ReflectionDesc>& reflection);
bool layOutReflection(seaglass::ReflectionDesc& reflection);

} // namespace demos
