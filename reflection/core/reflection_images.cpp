#include "reflection/core/reflection_images.h"

#include "reflection/after/blur.h"
#include "reflection/interface/body_reflector.h"

namespace seaglass {

namespace {

gpu::ImageDesc infoDesc(VkExtent2D extent) {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R16_SFLOAT;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return desc;
}

gpu::ImageDesc colorDesc(VkExtent2D extent, uint32_t blurLevels, bool drawnInto) {
    gpu::ImageDesc desc = infoDesc(extent);
    desc.format = reflectionColorFormat;
    desc.mipLevels = blurMipLevels(extent, blurLevels);
    if (drawnInto) desc.usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return desc;
}

} // namespace

VkExtent2D scaledDown(VkExtent2D extent, const ReflectionDesc& sized) {
    return scaledDown(extent, sized.downscale);
}

ReflectionDesc sizedFor(const ReflectionDesc& desc, VkExtent2D extent) {
    ReflectionDesc sized = desc;
    if (desc.height == 0) return sized;
    // By ratio: from one power of two to the next where the height is passed by the root of 2.
    sized.downscale = 1;
    const uint64_t twice = 2 * uint64_t{desc.height} * desc.height, rows = extent.height;
    while (sized.downscale < 8 && rows * rows > twice * sized.downscale * sized.downscale)
        sized.downscale *= 2;
    return sized;
}

uint32_t downscaleFor(const ReflectionDesc& desc, const VkExtent2D* view) {
    return view ? sizedFor(desc, *view).downscale : desc.downscale;
}

Status OwnedReflection::create(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels,
                               bool drawnInto) {
    const gpu::ImageDesc desc = colorDesc(extent, blurLevels, drawnInto);
    if (const Status s = color.create(device, desc, "reflection colour"); s != Status::ok) return s;
    return info.create(device, infoDesc(extent), "reflection info");
}

VkDeviceSize OwnedReflection::bytes(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels,
                                    bool drawnInto) {
    return gpu::heldBytes(device, colorDesc(extent, blurLevels, drawnInto)) +
           gpu::heldBytes(device, infoDesc(extent));
}

void OwnedReflection::recordDiscarded(const gpu::Device& device, VkCommandBuffer commands,
                                      const gpu::Use& use) const {
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(color.handle(), gpu::discardedAfterSampling, use, 0, 1),
        gpu::imageBarrier(info.handle(), gpu::discardedAfterSampling, use)};
    gpu::recordBarriers(device, commands, before, 2);
}

void OwnedReflection::recordToBeChanged(const gpu::Device& device, VkCommandBuffer commands) const {
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(color.handle(), gpu::storageWritten, gpu::storageChanged, 0, 1),
        gpu::imageBarrier(info.handle(), gpu::sampledByShaders, gpu::storageChanged)};
    gpu::recordBarriers(device, commands, before, 2);
}

void OwnedReflection::recordInfoSampled(const gpu::Device& device, VkCommandBuffer commands) const {
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(info.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
}

ReflectionImages OwnedReflection::handles() const {
    return {color.handle(), color.view(), info.handle(), info.view(), color.desc().extent};
}

} // namespace seaglass
