#include "host/water/placement.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "host/camera.h"

namespace demos {

bool placement(const MeshDesc& desc, glm::dmat4& out, Error& error) {
    const glm::dvec3 position = toGlm(desc.positionM);
    if (!finite(position) || !std::isfinite(desc.yawDeg) || !(desc.scale > 0) || !std::isfinite(desc.scale)) {
        error.text = desc.file.string() + ": position and yaw must be finite and the scale above 0";
        return false;
    }
    out = glm::translate(glm::dmat4(1), position);
    out = glm::rotate(out, glm::radians(-desc.yawDeg), glm::dvec3(0, 1, 0));
    out = glm::scale(out, glm::dvec3(desc.scale));
    return true;
}

} // namespace demos
