// The waves of a scene as Seaglass is told of them.
#pragma once

#include "scene/scene.h"
#include "seaglass/sea.h"

namespace demos {

/// Null when the program was built without one.
const seaglass::WavesBackend* wavesBackend();

/// False with `error` set when there is no backend or no such spectrum.
bool seaOf(const WavesDesc& waves, seaglass::SeaDesc& sea, Error& error);

} // namespace demos
