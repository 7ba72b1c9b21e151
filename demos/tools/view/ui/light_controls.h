// What the panel lets change of a scene's light and air.
#pragma once

#include "scene/scene.h"

namespace demos {

/// True once a change is complete.
bool layOutLight(Scene& scene);

} // namespace demos
