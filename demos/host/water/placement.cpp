#include "host/water/placement.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "host/camera.h"
#include "host/water/afloat.h"
#include "host/water/exclusion_volumes.h"
#include "scene/motion/motion.h"

namespace demos {

bool placedOf(const MeshDesc& desc, const Mesh& mesh, double levelM, Placed& out, Error& error) {
    out.desc = desc;
    std::vector<seaglass::ExclusionVolume> volumes;
    if (!exclusionVolumesOf(desc.exclusionVolumes, "mesh.exclusion_volumes", volumes, error)) {
        error.text = desc.file.string() + ": " + error.text;
        return false;
    }
    if (!desc.floats) return true;
    out.waterplane = waterplaneAt(mesh, (levelM - desc.positionM[1]) / desc.scale);
    const bool wide = out.waterplane && out.waterplane->half.x > 0 && out.waterplane->half.y > 0;
    if (!wide)
        error.text = desc.file.string() +
                     ": is to float and takes up no water, expected a mesh that reaches " +
                     "from below the water's level to above it";
    return wide;
}

bool placement(const MeshDesc& moving, double timeS, glm::dmat4& out, Error& error) {
    const MeshDesc desc = meshAt(moving, timeS);
    const glm::dvec3 position = toGlm(desc.positionM);
    if (!finite(position) || !std::isfinite(desc.yawDeg) || !(desc.scale > 0) || !std::isfinite(desc.scale)) {
        error.text = desc.file.string() + ": position and yaw must be finite and the scale above 0";
        return false;
    }
    out = glm::translate(glm::dmat4(1), position);
    out = glm::rotate(out, glm::radians(desc.yawDeg), glm::dvec3(0, 1, 0));
    out = glm::scale(out, glm::dvec3(desc.scale));
    return true;
}

bool placement(const Placed& placed, double timeS, const WaterAt& water, glm::dmat4& out, Error& error) {
    if (!placement(placed.desc, timeS, out, error)) return false;
    if (placed.waterplane) out = afloat(out, *placed.waterplane, water);
    return true;
}

} // namespace demos
