// SSPR first, and a ray only where it knows nothing.
#include "reflection/core/technique.h"
#include "reflection/march/cells.h"
#include "reflection/march/march.h"
#include "reflection/march/open_tiles.h"
#include "reflection/sspr/sspr.h"
#include "reflection/sspr/unseen_tiles.h"

namespace seaglass {

namespace {

struct HybridKernels : SsprKernels {
    std::shared_ptr<CellsKernel> cells; ///< null without ReflectionDesc::marchCells
    std::shared_ptr<OpenTilesKernel> openTiles;
    std::shared_ptr<MarchKernel> march;

    Status create(Context& context, const ReflectionDesc& desc) {
        if (const Status s = SsprKernels::create(context, desc); s != Status::ok) return s;
        if (desc.marchCells)
            if (const Status s = context.share(cells); s != Status::ok) return s;
        if (const Status s = context.share(openTiles); s != Status::ok) return s;
        return shareMarch(context, desc.marchCells, true, march);
    }
};

struct HybridScratch : SsprScratch {
    gpu::Buffer cells; ///< empty without ReflectionDesc::marchCells
    gpu::Buffer open;

    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
        if (const Status s = SsprScratch::create(device, extent, desc); s != Status::ok) return s;
        if (desc.marchCells)
            if (const Status s = createCells(device, extent, "hybrid's cells", cells); s != Status::ok)
                return s;
        return createTiles(device, scaledDown(extent, desc), "hybrid's open tiles", open);
    }
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
        return SsprScratch::bytes(device, extent, desc) +
               (desc.marchCells ? heldByCells(device, extent) : 0) +
               heldByTiles(device, scaledDown(extent, desc));
    }
};

Status record(const ReflectPass& pass, HybridKernels& kernels, HybridScratch& scratch,
              const OwnedReflection& images) {
    if (const Status s = recordSspr(pass, kernels, scratch, images); s != Status::ok) return s;
    const gpu::Device& device = pass.context.device;
    {
        const gpu::PassScope scope(device, pass.commands, "hybrid_open_tiles");
        if (const Status s = recordOpenTiles(pass, *kernels.openTiles, scratch.tiles, images, scratch.open);
            s != Status::ok)
            return s;
    }
    // Its flags go where nobody reads them any more.
    if (pass.desc.marchCells)
        if (const Status s = recordCells(pass, *kernels.cells, scratch.cells, scratch.open); s != Status::ok)
            return s;
    const gpu::PassScope scope(device, pass.commands, "hybrid_march");
    return recordMarch(pass, *kernels.march, scratch.open, pass.desc.marchCells ? &scratch.cells : nullptr,
                       images);
}

} // namespace

Technique hybridTechnique() {
    Technique technique = techniqueFrom<HybridKernels, HybridScratch, record>(
        [](const gpu::Device& device, const ReflectionDesc& desc) {
            return ssprDispatches + (desc.marchCells ? cellsDispatches : 0) + 1 + marchDispatches +
                   unseenTilesDispatches(device);
        });
    technique.followsRays = true;
    technique.tiles = [](const void* scratch) -> const gpu::Buffer& {
        return static_cast<const HybridScratch*>(scratch)->tiles;
    };
    return technique;
}

} // namespace seaglass
