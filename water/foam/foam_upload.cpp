#include "water/foam/foam_upload.h"

#include "water/interface/waves_backend.h"

#include <glm/packing.hpp>

namespace seaglass {

namespace {

VkDeviceSize stagingBytes(uint32_t samples, uint32_t cascades) {
    return VkDeviceSize{samples} * samples * cascades * 4 * sizeof(uint16_t);
}

constexpr VkBufferUsageFlags stagingUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

} // namespace

VkDeviceSize UploadedFoam::bytes(const Context& context, uint32_t samples, uint32_t cascades) {
    return gpu::heldBytes(context.device, stagingBytes(samples, cascades), stagingUsage) * context.frameCount;
}

Status UploadedFoam::create(Context& context, const Sea& sea, const FoamDesc& foam) {
    history_.emplace(sea, foam);
    for (uint32_t slot = 0; slot < context.frameCount; ++slot)
        if (const Status s = staging_[slot].createMapped(
                context.device, stagingBytes(cascade(sea, 0).samples, history_->breaking().count),
                stagingUsage, "foam history staging buffer");
            s != Status::ok)
            return s;
    return Status::ok;
}

void UploadedFoam::write(void* staging) const {
    auto* texel = static_cast<uint32_t*>(staging);
    for (uint32_t c = 0; c < history_->breaking().count; ++c) {
        const FoamHistory::Band& band = history_->band(c);
        for (size_t i = 0; i < band.foam.size(); ++i) {
            *texel++ = glm::packHalf2x16({1 - band.foam[i], 1 - band.foamNext[i]});
            *texel++ = glm::packHalf2x16({band.plume[i], band.plumeNext[i]});
        }
    }
}

Status UploadedFoam::record(Context& context, VkCommandBuffer commands, const UploadedWaves& waves,
                            const FoamImage& foam, int64_t step) {
    history_->advance(waves.backend(), waves.state(), step);
    const gpu::Buffer& staging = staging_[context.slot];
    write(staging.mapped());

    const gpu::PassScope pass(context.device, commands, "foam_upload");
    const gpu::ImageDesc& desc = foam.image.desc();
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(foam.image.handle(), gpu::discardedAfterSampling, gpu::copyWritten, 0, 1);
    gpu::recordBarriers(context.device, commands, &before, 1);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, desc.layers};
    region.imageExtent = {desc.extent.width, desc.extent.height, 1};
    context.device.vk().CmdCopyBufferToImage(commands, staging.handle(), foam.image.handle(),
                                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    return foam.recordMips(context, commands, gpu::copyWritten);
}

} // namespace seaglass
