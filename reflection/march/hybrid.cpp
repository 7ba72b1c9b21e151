#include "reflection/march/hybrid.h"

namespace seaglass {

Status HybridKernels::create(Context& context, const ReflectionDesc& desc) {
    if (desc.marchCells)
        if (const Status s = context.share(cells); s != Status::ok) return s;
    if (const Status s = context.share(openTiles); s != Status::ok) return s;
    return shareMarch(context, desc.marchCells, true, march);
}

VkDeviceSize HybridScratch::bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    return (desc.marchCells ? heldByCells(device, extent) : 0) +
           heldByTiles(device, scaledDown(extent, desc.downscale));
}

Status HybridScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    if (desc.marchCells)
        if (const Status s = createCells(device, extent, "hybrid's cells", cells); s != Status::ok) return s;
    return createTiles(device, scaledDown(extent, desc.downscale), "hybrid's open tiles", open);
}

uint32_t hybridDispatches(const ReflectionDesc& desc) {
    return ssprDispatches + (desc.marchCells ? cellsDispatches : 0) + 1 + marchDispatches;
}

Status recordHybrid(const ReflectPass& pass, const SsprKernels& sspr, const HybridKernels& hybrid,
                    const SsprScratch& ssprScratch, const HybridScratch& scratch,
                    const OwnedReflection& images) {
    if (const Status s = recordSspr(pass, sspr, ssprScratch, images); s != Status::ok) return s;
    if (const Status s = recordOpenTiles(pass, *hybrid.openTiles, ssprScratch.tiles, images, scratch.open);
        s != Status::ok)
        return s;
    if (!pass.desc.marchCells) return recordMarch(pass, *hybrid.march, scratch.open, nullptr, images);
    // Its flags go where nobody reads them any more.
    if (const Status s = recordCells(pass, *hybrid.cells, scratch.cells, scratch.open); s != Status::ok)
        return s;
    return recordMarch(pass, *hybrid.march, scratch.open, &scratch.cells, images);
}

} // namespace seaglass
