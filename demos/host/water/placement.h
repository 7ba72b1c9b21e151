// Where the meshes of a scene are at a moment.
#pragma once

#include "host/water/waterplane.h"
#include "scene/surroundings.h"

namespace demos {

class WaterAt;

/// What of a mesh says where it is.
struct Placed {
    MeshDesc desc;
    std::optional<Waterplane> waterplane; ///< of what floats
};

/// False with `error` set where it is to float and does not reach calm water, which lies at `levelM`, or
/// where it keeps dry what cannot be.
bool placedOf(const MeshDesc& desc, const Mesh& mesh, double levelM, Placed& out, Error& error);

/// Where it stands at a time, or, where it floats, is in calm water. Its yaw turns as glTF's rotations do,
/// against the clock as seen from above: +X towards -Z.
bool placement(const MeshDesc& desc, double timeS, glm::dmat4& worldFromMesh, Error& error);

/// Where it is at a time, when the water is so.
bool placement(const Placed& placed, double timeS, const WaterAt& water, glm::dmat4& worldFromMesh,
               Error& error);

} // namespace demos
