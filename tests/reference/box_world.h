// Worlds of boxes that shine by themselves under a sky of one colour: what a ray meets there has a closed
// form.
#pragma once

#include "reference/reference.h"
#include "tests/gpu/rig/traced_scene.h"

namespace tests {

/// Lat-long, the same everywhere.
demos::SkyImage evenSky(const glm::vec3& radiance);

/// Closed boxes of one material: black, rough and shining.
demos::Mesh shiningBoxes(const std::vector<Box>& boxes, const glm::vec3& radiance);

/// A sky of this radiance, no sun, nothing else.
bool lightWorld(const glm::vec3& sky, demos::reference::World& out);
void addMesh(const std::string& name, demos::Mesh mesh, demos::reference::World& out);

/// From (0, 2, 6) a little downwards.
demos::reference::FrameDesc smallFrame();

} // namespace tests
