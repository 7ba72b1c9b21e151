#include "water/foam/foam_image.h"

#include <bit>

namespace seaglass {

namespace {

gpu::ImageDesc imageDesc(const gpu::Device& device, uint32_t samples, uint32_t cascades,
                         VkImageUsageFlags filledBy) {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R16G16_SFLOAT;
    desc.extent = {samples, samples};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | gpu::MipChain::usage(device) |
                 filledBy;
    desc.mipLevels = static_cast<uint32_t>(std::bit_width(samples));
    desc.layers = cascades;
    desc.arrayView = true;
    return desc;
}

} // namespace

VkDeviceSize FoamImage::bytes(const gpu::Device& device, uint32_t samples, uint32_t cascades,
                              VkImageUsageFlags filledBy) {
    return gpu::heldBytes(device, imageDesc(device, samples, cascades, filledBy));
}

Status FoamImage::create(Context& context, uint32_t samples, uint32_t cascades, VkImageUsageFlags filledBy) {
    const gpu::ImageDesc desc = imageDesc(context.device, samples, cascades, filledBy);
    if (const Status s = image.create(context.device, desc, "foam history"); s != Status::ok) return s;
    return mips.create(context, desc.format);
}

Status FoamImage::recordMips(Context& context, VkCommandBuffer commands, const gpu::Use& written) const {
    const gpu::OwnedImage* const images[] = {&image};
    return mips.record(context, commands, images, written);
}

} // namespace seaglass
