#include "host/water/extent.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "host/files/mesh_file.h"

namespace demos {

namespace {

/// Vertices that differ in more than their place are one here: else a border would run between them.
bool readTriangles(const ExtentDesc& extent, std::vector<Vec2>& points, std::vector<uint32_t>& indices,
                   Error& error) {
    const std::optional<Mesh> mesh = readMesh(extent.file, error);
    if (!mesh) {
        error.text = extent.where + ": " + error.text;
        return false;
    }
    std::map<std::pair<float, float>, uint32_t> known;
    for (const uint32_t index : mesh->indices) {
        const glm::vec3& at = mesh->vertices[index].position;
        const auto [entry, fresh] = known.try_emplace({at.x, at.z}, static_cast<uint32_t>(points.size()));
        if (fresh) points.push_back({double{at.x}, double{at.z}});
        indices.push_back(entry->second);
    }
    return true;
}

} // namespace

bool extentOf(const ExtentDesc& extent, SceneExtent& out, Error& error) {
    using seaglass::ExtentShape;
    out.desc.shape = extent.shape == "mesh"      ? ExtentShape::mesh
                     : extent.shape == "polygon" ? ExtentShape::polygon
                                                 : ExtentShape::rectangle;
    // A turn about +Y takes +X towards -Z.
    out.desc.yaw = -extent.yawDeg * std::numbers::pi / 180;
    for (size_t i = 0; i < 2; ++i) {
        out.desc.center[i] = extent.centerM[i];
        out.desc.size[i] = extent.sizeM[i];
    }
    std::vector<Vec2> points = extent.pointsM;
    if (out.desc.shape == ExtentShape::mesh && !readTriangles(extent, points, out.indices, error))
        return false;
    const double c = std::cos(out.desc.yaw), s = std::sin(out.desc.yaw);
    for (const auto& [x, z] : points) {
        out.points.push_back(extent.centerM[0] + c * x - s * z);
        out.points.push_back(extent.centerM[1] + s * x + c * z);
    }
    out.desc.points = out.points.data();
    out.desc.pointCount = static_cast<uint32_t>(points.size());
    out.desc.indices = out.indices.data();
    out.desc.indexCount = static_cast<uint32_t>(out.indices.size());
    return true;
}

} // namespace demos
