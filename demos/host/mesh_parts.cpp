#include "host/mesh_parts.h"

#include <algorithm>
#include <span>

namespace demos {
namespace {

constexpr size_t maxPartTriangles = 2048;

using Triangle = std::array<uint32_t, 3>;

/// Halves the triangles along their longest side.
void addParts(std::span<Triangle> triangles, uint32_t material, Mesh& mesh) {
    if (triangles.empty()) return;
    MeshPart part;
    part.low = part.high = mesh.vertices[triangles.front()[0]].position;
    for (const Triangle& triangle : triangles)
        for (const uint32_t index : triangle) {
            part.low = glm::min(part.low, mesh.vertices[index].position);
            part.high = glm::max(part.high, mesh.vertices[index].position);
        }
    if (triangles.size() > maxPartTriangles) {
        const glm::vec3 size = part.high - part.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
        // Ties go by index, so that the order is the same with every library.
        std::nth_element(
            triangles.begin(), middle, triangles.end(), [&](const Triangle& a, const Triangle& b) {
                const float pa = mesh.vertices[a[0]].position[axis], pb = mesh.vertices[b[0]].position[axis];
                return pa != pb ? pa < pb : a < b;
            });
        addParts({triangles.begin(), middle}, material, mesh);
        addParts({middle, triangles.end()}, material, mesh);
        return;
    }
    std::sort(triangles.begin(), triangles.end());
    part.firstIndex = static_cast<uint32_t>(mesh.indices.size());
    part.indexCount = static_cast<uint32_t>(triangles.size() * 3);
    part.material = material;
    for (const Triangle& triangle : triangles)
        mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    mesh.parts.push_back(part);
}

} // namespace

void divideIntoParts(const std::vector<std::vector<uint32_t>>& corners, Mesh& mesh) {
    for (size_t material = 0; material < corners.size(); ++material) {
        std::vector<Triangle> triangles;
        const std::vector<uint32_t>& list = corners[material];
        for (size_t i = 0; i + 2 < list.size(); i += 3)
            triangles.push_back({list[i], list[i + 1], list[i + 2]});
        addParts(triangles, static_cast<uint32_t>(material), mesh);
    }
    if (mesh.vertices.empty()) return;
    mesh.low = mesh.high = mesh.vertices.front().position;
    for (const MeshVertex& vertex : mesh.vertices) {
        mesh.low = glm::min(mesh.low, vertex.position);
        mesh.high = glm::max(mesh.high, vertex.position);
    }
}

} // namespace demos
