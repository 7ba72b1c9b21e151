// Triangles that lie near each other as parts, small enough to be culled with profit.
#pragma once

#include "host/files/mesh_file.h"

namespace demos {

/// Fills a mesh's indices, parts and bounds. `corners` are three a triangle, by material.
void divideIntoParts(const std::vector<std::vector<uint32_t>>& corners, Mesh& mesh);

} // namespace demos
