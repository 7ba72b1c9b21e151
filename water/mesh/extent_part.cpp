// What a body covers of its plane, as a part of it.
#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/body/part.h"
#include "water/interface/checks.h"
#include "water/interface/fields/water.h"
#include "water/mesh/host_mesh.h"
#include "water/mesh/mesh.h"

namespace seaglass {

namespace {

static_assert(meshFieldRows[1].low == fewestInRange);

/// Its state is the body's Placing.
struct ExtentPart {
    static FieldError validate(const BodyDesc& desc) {
        if (const FieldError bad = badField(desc.extent)) return bad;
        return badAsked(meshFields, &desc.mesh);
    }
    static bool wanted(const BodyDesc&, const Sea*) { return true; }
    static Status addCost(const AskedBody& asked, Estimate& sum) {
        sum.bytes += HostMesh::bytes(asked.context.device, asked.desc.extent);
        return Status::ok;
    }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const Placing& placing = body.placing;
        const glm::dvec2 eye(view.geometry.eye.x, view.geometry.eye.z);
        block.finestCell = static_cast<float>(placing.cellNearEye(view.geometry));
        block.globeCurvature = static_cast<float>(placing.globe.curvature);
        block.covered = {-1e9f, -1e9f, 1e9f, 1e9f};
        if (placing.hostMesh) {
            block.meshOrigin = placing.hostMesh->origin - eye;
        } else {
            const MeshLattice lattice = placing.lattice(placing.meshView(view.geometry));
            block.meshOrigin = lattice.origin;
            block.meshCell = static_cast<float>(lattice.cell);
        }
        if (!placing.outline) return;
        block.covered = placing.outline->boxFrom(eye).packed();
        if (body.sea) block.perEdgeWidth = static_cast<float>(1 / pinnedWithin(placing.displacement));
    }

    void vary(const Body& body, const SurfaceDraw&, SurfaceVariant& variant) const {
        variant.shape = static_cast<uint32_t>(body.placing.shape());
        variant.onGlobe = !body.placing.globe.flat();
    }
};

} // namespace

Part extentPart() {
    return partFrom<ExtentPart>();
}

} // namespace seaglass
