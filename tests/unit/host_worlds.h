// Hosts whose worlds are none of Seaglass's, and their cameras as their makers build them: by their own axes.
#pragma once

#include <vector>

#include "seaglass/world.h"
#include "tests/unit/cameras.h"

namespace tests {

struct HostWorld {
    seaglass::World world;
    glm::dvec3 up, right, ahead; ///< of the host's own axes, where Seaglass's are +Y, +X and -Z
};

/// All that the table of world.h has, and one in centimetres.
inline std::vector<HostWorld> everyWorld() {
    using seaglass::WorldUp;
    return {
        {{WorldUp::y, false, 1, false}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
        {{WorldUp::y, true, 1, true}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{WorldUp::minusY, false, 1, true}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{WorldUp::minusY, true, 1, false}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
        {{WorldUp::z, false, 1, false}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {{WorldUp::z, true, 1, true}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
        {{WorldUp::z, true, 100, true}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    };
}

inline glm::dvec3 toHost(const HostWorld& host, const glm::dvec3& p) {
    return host.world.unitsPerMetre * (p.x * host.right + p.y * host.up - p.z * host.ahead);
}

/// Of a camera that stands in the host's world: right, up or down, and ahead or back, as rows.
inline glm::dmat4 hostView(const HostWorld& host, const Camera& camera) {
    const glm::dvec3 eye = toHost(host, camera.eye);
    const glm::dvec3 ahead = glm::normalize(toHost(host, camera.target) - eye);
    const bool yDown = host.world.up == seaglass::WorldUp::minusY;
    const bool flips = host.world.leftHanded;
    const glm::dvec3 right = (flips ? -1.0 : 1.0) * glm::normalize(glm::cross(ahead, host.up));
    const glm::dvec3 up = (flips ? -1.0 : 1.0) * glm::cross(right, ahead);
    const glm::dvec3 rows[3] = {right, yDown ? -up : up, host.world.sightAlongZ ? ahead : -ahead};
    glm::dmat4 view(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) view[column][row] = rows[row][column];
        view[3][row] = -glm::dot(rows[row], eye);
    }
    return view;
}

/// Of the same lens in the host's units and its view's axes; clip space is Vulkan's, y down.
inline glm::dmat4 hostProjection(const HostWorld& host, Camera camera) {
    camera.near *= host.world.unitsPerMetre;
    camera.far *= host.world.unitsPerMetre;
    camera.parallelHeight *= host.world.unitsPerMetre;
    glm::dmat4 projection = projectionMatrix(camera);
    if (host.world.up == seaglass::WorldUp::minusY) projection[1] *= -1;
    if (host.world.sightAlongZ) projection[2] *= -1;
    return projection;
}

} // namespace tests
