// A scene's fog as Seaglass has it.
#pragma once

#include "scene/scene.h"
#include "seaglass/fog.h"

namespace demos {

/// False with `error` set where the fog is none that the library takes.
bool fogOf(const FogDesc& desc, seaglass::FogDesc& out, Error& error);

} // namespace demos
