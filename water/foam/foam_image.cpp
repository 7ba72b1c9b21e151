#include "water/foam/foam_image.h"

#include "water/waves/wave_maps.h"

namespace seaglass {

constexpr VkFormat foamFormat = VK_FORMAT_R16G16B16A16_SFLOAT; // two steps clear of foam, two of plumes

VkDeviceSize FoamImage::bytes(const gpu::Device& device, uint32_t samples, uint32_t cascades,
                              VkImageUsageFlags filledBy) {
    return gpu::heldBytes(device, cascadeMapDesc(device, foamFormat, samples, cascades, filledBy));
}

Status FoamImage::create(Context& context, uint32_t samples, uint32_t cascades, VkImageUsageFlags filledBy) {
    const gpu::ImageDesc desc = cascadeMapDesc(context.device, foamFormat, samples, cascades, filledBy);
    if (const Status s = image.create(context.device, desc, "foam history"); s != Status::ok) return s;
    return mips.create(context, desc.format);
}

Status FoamImage::recordMips(Context& context, VkCommandBuffer commands, const gpu::Use& written) const {
    const gpu::OwnedImage* const images[] = {&image};
    return mips.record(context, commands, images, written);
}

} // namespace seaglass
