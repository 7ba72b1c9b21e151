// The waves of a scene as Seaglass is told of them.
#pragma once

#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// Of the CPU. Null when the program was built without one.
const seaglass::WavesBackend* wavesBackend();

/// Where the scene wants its waves computed. False with `error` set when the program cannot.
bool wavesOnOf(const WavesDesc& waves, seaglass::WavesOn& on, Error& error);

/// False with `error` set when there is no such spectrum.
bool seaOf(const WavesDesc& waves, seaglass::SeaDesc& sea, Error& error);

} // namespace demos
