// A scene in the CPU's memory: everything that a picture from any camera at any time is made of.
#pragma once

#include <map>
#include <optional>

#include "reference/light.h"
#include "reference/water_surface.h"

namespace demos::reference {

struct World {
    std::map<std::filesystem::path, Model> models; ///< each file once
    std::vector<Instance> instances;
    Light light;
    std::optional<WaterDesc> water;
    SeaPointer sea; ///< null when flat
};

/// Reads the sky and the meshes and draws the sea's modes.
bool loadWorld(const Scene& scene, World& out, Error& error);
/// Sets the water alone.
bool setWater(const std::optional<WaterDesc>& desc, World& out, Error& error);

} // namespace demos::reference
