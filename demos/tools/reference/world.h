// A scene in the CPU's memory: everything that a picture from any camera at any time is made of.
#pragma once

#include <map>
#include <optional>

#include "host/water/floor_plane.h"
#include "reference/light/light.h"
#include "reference/water_surface.h"
#include "scene/scene.h"

// Not public: there is to be one notion of what an outline encloses, and of a tilted body's axes.
#include "water/body/body_frame.h"
#include "water/body/exclusion_volumes.h"
#include "water/mesh/extent.h"

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
    seaglass::BodyFrame frame; ///< of the water: all is traced in its axes, in which it is level
    double levelM = 0;         ///< of the water in them
    seaglass::Globe globe;     ///< that the water lies on
    SeaPointer sea;            ///< null when flat
    std::optional<seaglass::Outline> outline; ///< of the water; none where it is unbounded
    std::vector<seaglass::ExclusionPlanes> exclusionVolumes;
    std::optional<Floor> floor;
};

/// Reads the sky and the meshes and draws the sea's modes.
bool loadWorld(const Scene& scene, World& out, Error& error);
/// Sets the floor alone.
bool setFloor(const std::optional<FloorDesc>& desc, World& out, Error& error);
/// Sets the water alone.
bool setWater(const std::optional<WaterDesc>& desc, World& out, Error& error);

} // namespace demos::reference
