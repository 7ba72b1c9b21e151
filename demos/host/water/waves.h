// The waves of a scene as Seaglass is told of them.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "seaglass/water.h"
#include "seaglass/water_type.h"

namespace demos {

/// Of the CPU. Null when the program was built without one.
const seaglass::WavesBackend* wavesBackend();

/// Where the scene wants its waves computed. False with `error` set when the program cannot.
bool wavesOnOf(const WavesDesc& waves, seaglass::WavesOn& on, Error& error);

/// A description and what it refers to. Moves, but does not copy.
struct SceneSea {
    SceneSea() = default;
    SceneSea(SceneSea&&) = default;
    SceneSea& operator=(SceneSea&&) = default;

    seaglass::SeaDesc desc;
    std::vector<seaglass::SpectrumSample> table;
};

/// False with `error` set when there is no such model, or no table in the file that is named.
bool seaOf(const WavesDesc& waves, SceneSea& sea, Error& error);

/// Of the type that is named, or of the tint, else as they are given.
seaglass::WaterCoefficients coefficientsOf(const RefractionDesc& refraction);

} // namespace demos
