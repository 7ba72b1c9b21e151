#include "water/mesh/placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

namespace seaglass {

namespace {

/// As pixelWidth() of shaders/water/body/body.glsl has it, amid the picture [rad]; of parallel lines
/// of sight [m].
double pixelStep(const ViewGeometry& geometry) {
    const glm::dmat4 rows = glm::transpose(geometry.pixelFromRelative);
    const glm::dvec2 middle = glm::dvec2(geometry.regionSize) / 2.0;
    const glm::dvec3 ahead(rows[3]), right = glm::dvec3(rows[0]) - middle.x * ahead,
                                     down = glm::dvec3(rows[1]) - middle.y * ahead;
    return 1 / std::sqrt(glm::length(glm::cross(right, down)));
}

/// Whether a volume may reach into a patch, as waves move it.
struct MayBeCut {
    const MeshView& view;
    const std::vector<ExclusionPlanes>& volumes;
    MeshLattice lattice;
    double level;    ///< of the calm plane [m]
    uint32_t across; ///< cells of a patch

    bool operator()(const OutlinedPatch& patch) const { return (*this)(patch.patch); }
    bool operator()(const MeshPatch& patch) const {
        if (volumes.empty()) return false;
        if (patch.range < 0) return true; // drawn out to the horizon
        const double edge = double{patch.cell} * across;
        const double moved = view.displacement + 1e-3 * edge; // and what floats round
        const glm::dvec2 corner = lattice.cornerOf(patch);
        const glm::dvec2 farthest = glm::max(glm::abs(corner), glm::abs(corner + edge));
        const double sunk = view.globe.dropAt(glm::dot(farthest, farthest));
        const glm::dvec2 low = view.eye + corner - moved, high = view.eye + corner + edge + moved;
        return mayExcludeIn(volumes, {low.x, level - moved - sunk, low.y}, {high.x, level + moved, high.y});
    }
};

/// Puts those that may be cut last, but where patches have an order; returns how many come before.
template<typename Patch>
uint32_t uncutFirst(std::vector<Patch>& patches, const MayBeCut& mayBeCut) {
    if (mayBeCut.view.farthestFirst) return 0;
    const auto cut = std::stable_partition(patches.begin(), patches.end(),
                                           [&](const Patch& patch) { return !mayBeCut(patch); });
    return static_cast<uint32_t>(cut - patches.begin());
}

void placeCells(uint32_t across, PlacedMesh& out) {
    out.firstIndex = firstPatchIndex(across);
    out.indexCount = across * across * 6;
}

} // namespace

Status PatchIndices::create(Context& context) {
    const std::vector<uint16_t> indices = patchIndices();
    const VkDeviceSize bytes = indices.size() * sizeof(uint16_t);
    if (const Status s = buffer.createMapped(context.device, bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                             "patch index buffer");
        s != Status::ok)
        return s;
    std::memcpy(buffer.mapped(), indices.data(), bytes);
    return Status::ok;
}

Status Placing::create(Context& context, const BodyDesc& desc, const Sea* sea, double calm) {
    level = calm;
    mesh = desc.mesh;
    if (sea) {
        displacement = largestDisplacement(*sea);
        detail = WaveDetail(*sea);
    }
    if (desc.extent.shape == ExtentShape::unbounded)
        globe = Globe::of(desc.extent.planetRadius);
    else
        outline = outlineOf(desc.extent);
    if (desc.extent.shape == ExtentShape::mesh)
        return hostMesh.emplace().create(context.device, desc.extent, *outline);
    return context.shareWhileUsed(indices);
}

SurfaceShape Placing::shape() const {
    if (hostMesh) return SurfaceShape::hostMesh;
    return outline ? SurfaceShape::outlined : SurfaceShape::plane;
}

MeshView Placing::meshView(const ViewGeometry& geometry) const {
    MeshView view;
    view.eye = {geometry.eye.x, geometry.eye.z};
    view.eyeHeight = geometry.eye.y - level;
    view.displacement = displacement;
    view.globe = globe;
    view.waves = &detail;
    view.pixel = pixelStep(geometry);
    view.parallel = parallelLines(geometry, view.eyeHeight, view.displacement);
    if (view.parallel) view.pixel /= view.parallel->distance;
    // Patches are tested around the eye's foot on the calm plane.
    glm::dmat4 relativeFromFoot(1);
    relativeFromFoot[3].y = -view.eyeHeight;
    view.frustum = frustumPlanes(geometry.clipFromRelative * relativeFromFoot, geometry.reversedDepth);
    return view;
}

bool Placing::maySee(const ViewGeometry& geometry) {
    const MeshView view = meshView(geometry);
    if (outline) return inSight(view, outline->boxFrom(view.eye));
    selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, patches);
    return !patches.empty();
}

MeshLattice Placing::lattice(const MeshView& view) const {
    return meshLattice(view, double{mesh.cellSize}, mesh.cellsPerLevel);
}

double Placing::cellNearEye(const ViewGeometry& geometry) const {
    const double asked{mesh.cellSize};
    return hostMesh || geometry.parallel ? asked : seaglass::cellNearEye(displacement, asked);
}

Status Placing::place(Context& context, const MeshView& view, const std::vector<ExclusionPlanes>& volumes,
                      PlacedMesh& out) {
    out.instanceCount = out.uncut = 0;
    if (hostMesh) {
        placeHostMesh(view, out);
        return Status::ok;
    }
    out.indices = indices->buffer.handle();
    return outline ? placeOutlined(context, view, volumes, out) : placePatches(context, view, volumes, out);
}

Status Placing::placePatches(Context& context, const MeshView& view,
                             const std::vector<ExclusionPlanes>& volumes, PlacedMesh& out) {
    const uint32_t across = selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, patches);
    placeCells(across, out);
    out.instanceCount = static_cast<uint32_t>(patches.size());
    out.uncut = uncutFirst(patches, {view, volumes, lattice(view), level, across});
    return patches.empty() ? Status::ok : context.frame().uploadInRow(out.patches, patches);
}

Status Placing::placeOutlined(Context& context, const MeshView& view,
                              const std::vector<ExclusionPlanes>& volumes, PlacedMesh& out) {
    const uint32_t across = selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, *outline,
                                          pinnedWithin(displacement), outlined);
    placeCells(across, out);
    out.instanceCount = static_cast<uint32_t>(outlined.patches.size());
    if (outlined.patches.empty()) return Status::ok;
    out.uncut = uncutFirst(outlined.patches, {view, volumes, lattice(view), level, across});
    if (const Status s = context.frame().uploadInRow(out.patches, outlined.patches); s != Status::ok)
        return s;
    const std::array box = {outline->boxFrom(view.eye).packed()};
    return context.frame().uploadInRow(out.extent, box, outlined.edges);
}

void Placing::placeHostMesh(const MeshView& view, PlacedMesh& out) const {
    if (!inSight(view, outline->boxFrom(view.eye))) return;
    out.patches = gpu::storageBuffer(hostMesh->vertices.handle());
    out.indices = hostMesh->indices.handle();
    out.indexType = VK_INDEX_TYPE_UINT32;
    out.indexCount = hostMesh->indexCount;
    out.instanceCount = 1;
}

} // namespace seaglass
