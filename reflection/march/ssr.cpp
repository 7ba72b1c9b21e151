#include "reflection/march/ssr.h"

#include "reflection/core/technique.h"

namespace seaglass {

Status SsrKernels::create(Context& context, const ReflectionDesc& desc) {
    if (const Status s = context.share(cells); s != Status::ok) return s;
    if (const Status s = context.share(seenTiles); s != Status::ok) return s;
    if (const Status s = shareUnseenTiles(context, unseen); s != Status::ok) return s;
    return shareMarch(context, desc.marchCells, false, march);
}

VkDeviceSize SsrScratch::bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    return heldByCells(device, extent) + heldByTiles(device, scaledDown(extent, desc));
}

Status SsrScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    if (const Status s = createCells(device, extent, "SSR cells", cells); s != Status::ok) return s;
    return createTiles(device, scaledDown(extent, desc), "SSR tiles", tiles);
}

namespace {

Status record(const ReflectPass& pass, SsrKernels& kernels, SsrScratch& scratch,
              const OwnedReflection& images) {
    const gpu::Device& device = pass.context.device;
    gpu::recordBuffersCleared(device, pass.commands, {scratch.tiles.handle()});
    if (const Status s = recordCells(pass, *kernels.cells, scratch.cells, scratch.tiles); s != Status::ok)
        return s;
    if (const Status s = recordSeenTiles(pass, *kernels.seenTiles, scratch.tiles); s != Status::ok) return s;
    if (const Status s = recordUnseenTiles(pass, kernels.unseen.get(), scratch.tiles, images);
        s != Status::ok)
        return s;
    images.recordInfoSampled(device, pass.commands);
    const gpu::PassScope scope(pass.context.device, pass.commands, "ssr_march");
    return recordMarch(pass, *kernels.march, scratch.tiles, pass.desc.marchCells ? &scratch.cells : nullptr,
                       images);
}

} // namespace

Technique ssrTechnique() {
    Technique technique =
        techniqueFrom<SsrKernels, SsrScratch, record>([](const gpu::Device& device, const ReflectionDesc&) {
            return cellsDispatches + 1 + marchDispatches + unseenTilesDispatches(device);
        });
    technique.followsNormals = true;
    technique.tiles = [](const void* scratch) -> const gpu::Buffer& {
        return static_cast<const SsrScratch*>(scratch)->tiles;
    };
    return technique;
}

} // namespace seaglass
