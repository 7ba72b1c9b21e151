// A scene in the CPU's memory: everything that a picture from any camera at any time is made of.
#pragma once

#include <map>
#include <optional>

#include "host/water/floor_plane.h"
#include "reference/light/light.h"
#include "reference/water/excluded_volumes.h"
#include "reference/water/globe.h"
#include "reference/water/level_axes.h"
#include "reference/water/outline.h"
#include "reference/water_surface.h"
#include "scene/scene.h"

namespace demos::reference {

struct Floor {
    FloorDesc desc;
    FloorPlane plane;
    Texture texture;
};

struct World {
    std::map<std::filesystem::path, Model> models; ///< each file once
    std::vector<Instance> instances;
    std::vector<std::string> leftOut; ///< Mesh::leftOut, behind the file's name
    Light light;
    std::optional<seaglass::FogDesc> fog;
    std::optional<WaterDesc> water;
    LevelAxes frame;                ///< of the water: all is traced in its axes, in which it is level
    double levelM = 0;              ///< of the water in them
    Globe globe;                    ///< that the water lies on
    SeaPointer sea;                 ///< null when flat
    std::optional<Outline> outline; ///< of the water; none where it is unbounded
    std::vector<ExcludedVolume> excludedVolumes;
    std::optional<Floor> floor;
};

/// Reads the sky and the meshes and draws the sea's modes.
bool loadWorld(const Scene& scene, World& out, Error& error);
/// Sets the floor alone.
bool setFloor(const std::optional<FloorDesc>& desc, World& out, Error& error);
/// Sets the water alone.
bool setWater(const std::optional<WaterDesc>& desc, World& out, Error& error);

} // namespace demos::reference
