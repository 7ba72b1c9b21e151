#include "reflection/hybrid.h"

namespace seaglass {

Status HybridKernels::create(Context& context) {
    if (const Status s = openTiles.create(context); s != Status::ok) return s;
    return march.create(context);
}

Status HybridScratch::create(const gpu::Device& device, VkExtent2D imageExtent) {
    return open.create(device, tileBufferBytes(imageExtent),
                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                           VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                       "hybrid's open tiles");
}

Status recordHybrid(const ReflectPass& pass, const SsprKernels& sspr, const HybridKernels& hybrid,
                    const SsprScratch& ssprScratch, const HybridScratch& scratch,
                    const OwnedReflection& images) {
    if (const Status s = recordSspr(pass, sspr, ssprScratch, images); s != Status::ok) return s;
    if (const Status s = recordOpenTiles(pass, hybrid.openTiles, ssprScratch.tiles, images, scratch.open);
        s != Status::ok)
        return s;
    return recordOpenMarch(pass, hybrid.march, scratch.open, images);
}

} // namespace seaglass
