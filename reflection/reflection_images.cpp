#include "reflection/reflection_images.h"

#include "reflection/blur.h"

namespace seaglass {

Status OwnedReflection::create(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels) {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    desc.mipLevels = blurMipLevels(extent, blurLevels);
    if (const Status s = color.create(device, desc, "reflection colour"); s != Status::ok) return s;
    desc.format = VK_FORMAT_R16_SFLOAT;
    desc.mipLevels = 1;
    return info.create(device, desc, "reflection info");
}

ReflectionImages OwnedReflection::handles() const {
    return {color.handle(), color.view(), info.handle(), info.view(), color.desc().extent};
}

} // namespace seaglass
