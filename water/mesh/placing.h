// Where a body's surface lies, and what of it is drawn in a view: patches of the plane, those within an
// outline, or triangles of the host's own.
#pragma once

#include <memory>
#include <optional>

#include "gpu/context.h"
#include "gpu/view/view.h"
#include "seaglass/water.h"
#include "water/body/exclusion_volumes.h"
#include "water/mesh/extent.h"
#include "water/mesh/globe.h"
#include "water/mesh/host_mesh.h"
#include "water/mesh/mesh.h"

namespace seaglass {

/// How the vertices of a surface are placed.
enum class SurfaceShape : uint32_t {
    plane,    ///< patches out to the horizon
    outlined, ///< patches, of which pixels within an outline are kept
    hostMesh, ///< the host's own
};

/// What one draw takes.
struct PlacedMesh {
    gpu::Resource patches; ///< one an instance; of a mesh of the host's own, its vertices
    gpu::Resource extent;  ///< the block of shaders/water/mesh/extent.glsl
    VkBuffer indices = VK_NULL_HANDLE;
    VkIndexType indexType = VK_INDEX_TYPE_UINT16;
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    uint32_t instanceCount = 0;
    uint32_t uncut = 0; ///< of these, the first that no exclusion volume reaches into
};

/// The index buffer that every patch of every body is drawn with.
struct PatchIndices {
    gpu::Buffer buffer;
    Status create(Context& context);
};

/// In the body's axes.
struct Placing {
    double level = 0;        ///< of the calm plane [m]
    double displacement = 0; ///< the most that waves move a point in any axis [m]
    MeshDesc mesh;
    Globe globe;
    WaveDetail detail;
    std::optional<Outline> outline;   ///< none where the body is unbounded
    std::optional<HostMesh> hostMesh; ///< the extent is a mesh
    std::shared_ptr<PatchIndices> indices;
    std::vector<MeshPatch> patches; ///< scratch, kept for its capacity
    OutlinedPatches outlined;       ///< likewise

    /// `sea`: null where it is flat.
    Status create(Context& context, const BodyDesc& desc, const Sea* sea, double calm);
    SurfaceShape shape() const;
    MeshView meshView(const ViewGeometry& geometry) const;
    /// False: the view sees nothing of the body.
    bool maySee(const ViewGeometry& geometry);
    /// That patches lie on.
    MeshLattice lattice(const MeshView& view) const;
    /// Edge of the cells that a view's near plane cuts [m].
    double cellNearEye(const ViewGeometry& geometry) const;
    /// Whether a point lies over what the body covers.
    bool covers(const glm::dvec3& point) const { return !outline || outline->contains({point.x, point.z}); }
    /// What is to be drawn: no instance when the view sees nothing of the body.
    Status place(Context& context, const MeshView& view, const std::vector<ExclusionPlanes>& volumes,
                 PlacedMesh& out);

  private:
    Status placePatches(Context& context, const MeshView& view, const std::vector<ExclusionPlanes>& volumes,
                        PlacedMesh& out);
    Status placeOutlined(Context& context, const MeshView& view, const std::vector<ExclusionPlanes>& volumes,
                         PlacedMesh& out);
    void placeHostMesh(const MeshView& view, PlacedMesh& out) const;
};

} // namespace seaglass
