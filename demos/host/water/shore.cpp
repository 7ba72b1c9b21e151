#include "host/water/shore.h"

#include <algorithm>
#include <cmath>

#include "host/files/mesh_file.h"

namespace demos {

namespace {

struct Grid {
    glm::vec2 first;
    float spacing;
    uint32_t columns, rows;
    std::vector<float>& heights;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Raises the samples under a triangle to it.
void raise(Grid& grid, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto onGrid = [&](const glm::vec3& p) {
        return (glm::dvec2(p.x, p.z) - glm::dvec2(grid.first)) / double{grid.spacing};
    };
    const glm::dvec2 p = onGrid(a), q = onGrid(b), r = onGrid(c);
    const double area = cross(q - p, r - p);
    if (std::abs(area) < 1e-9) return;
    const glm::dvec2 low = glm::ceil(glm::min(glm::min(p, q), r) - 1e-6);
    const glm::dvec2 high = glm::floor(glm::max(glm::max(p, q), r) + 1e-6);
    for (double y = std::max(low.y, 0.0); y <= std::min(high.y, grid.rows - 1.0); ++y)
        for (double x = std::max(low.x, 0.0); x <= std::min(high.x, grid.columns - 1.0); ++x) {
            const glm::dvec2 at(x, y);
            const double u = cross(r - q, at - q) / area, v = cross(p - r, at - r) / area, w = 1 - u - v;
            constexpr double slack = -1e-6; // of samples on an edge
            if (u < slack || v < slack || w < slack) continue;
            float& height = grid.heights[static_cast<size_t>(y) * grid.columns + static_cast<size_t>(x)];
            height =
                std::max(height, static_cast<float>(u * double{a.y} + v * double{b.y} + w * double{c.y}));
        }
}

/// Into the plane's axes, about the mesh's origin.
void turn(Mesh& mesh, const Plane& plane) {
    mesh.low = glm::vec3(INFINITY);
    mesh.high = glm::vec3(-INFINITY);
    for (MeshVertex& vertex : mesh.vertices) {
        glm::vec3& p = vertex.position;
        const Vec3 turned = alongPlane({plane[0], plane[1], plane[2], 0}, {p.x, p.y, p.z});
        p = {turned[0], turned[1], turned[2]};
        mesh.low = glm::min(mesh.low, p);
        mesh.high = glm::max(mesh.high, p);
    }
}

} // namespace

bool shoreOf(const ShoreDesc& shore, const Plane& plane, SceneShore& out, Error& error) {
    std::optional<Mesh> mesh = readMesh(shore.file, error);
    if (!mesh) {
        error.text = shore.where + ": " + error.text;
        return false;
    }
    if (plane[1] < 1) turn(*mesh, plane);
    const Vec3 origin = alongPlane(plane, shore.positionM);
    const double spacing = shore.spacingM;
    const auto samples = [&](float low, float high) {
        return std::floor(double{high - low} / spacing + 1e-6) + 1;
    };
    const double columns = samples(mesh->low.x, mesh->high.x), rows = samples(mesh->low.z, mesh->high.z);
    if (columns < 2 || rows < 2 || columns > 1024 || rows > 1024) {
        error.text = shore.where + ": the bed has " + std::to_string(std::lround(columns)) + " by " +
                     std::to_string(std::lround(rows)) + " samples, expected 2 to 1024: change spacing_m";
        return false;
    }
    out.bed.assign(static_cast<size_t>(columns * rows), mesh->low.y);
    Grid grid{{mesh->low.x, mesh->low.z},
              static_cast<float>(spacing),
              static_cast<uint32_t>(columns),
              static_cast<uint32_t>(rows),
              out.bed};
    for (size_t i = 0; i + 2 < mesh->indices.size(); i += 3)
        raise(grid, mesh->vertices[mesh->indices[i]].position, mesh->vertices[mesh->indices[i + 1]].position,
              mesh->vertices[mesh->indices[i + 2]].position);
    for (float& height : out.bed) height += static_cast<float>(origin[1]);
    out.desc.bed = out.bed.data();
    out.desc.samples[0] = grid.columns;
    out.desc.samples[1] = grid.rows;
    out.desc.spacing = grid.spacing;
    out.desc.origin[0] = double{mesh->low.x} + origin[0];
    out.desc.origin[1] = double{mesh->low.z} + origin[2];
    return true;
}

} // namespace demos
