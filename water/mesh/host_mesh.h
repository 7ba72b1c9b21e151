// A surface of the host's own triangles: its vertices as the shader reads them.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "gpu/context.h"
#include "water/mesh/extent.h"

namespace seaglass {

/// shaders/water/surface/surface.glsl's HostVertex.
struct HostVertex {
    float calm[2];      ///< (u, v) from the mesh's origin [m]
    float cell = 0;     ///< mean length of the edges that meet here: shorter waves do not fit [m]
    float fromEdge = 0; ///< way along the edges to the mesh's border [m]
};

std::vector<HostVertex> hostVertices(const ExtentDesc& desc, const glm::dvec2& origin);

struct HostMesh {
    gpu::Buffer vertices, indices;
    uint32_t indexCount = 0;
    glm::dvec2 origin{0}; ///< (u, v)

    Status create(const gpu::Device& device, const ExtentDesc& desc, const Outline& outline);
    static VkDeviceSize bytes(const gpu::Device& device, const ExtentDesc& desc);
};

} // namespace seaglass
