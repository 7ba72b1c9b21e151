#include "water/waves/fixed_image.h"

#include <algorithm>
#include <vector>

namespace seaglass {

namespace {

constexpr VkBufferUsageFlags stagingUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

gpu::ImageDesc uploadable(gpu::ImageDesc desc) {
    desc.usage |= VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return desc;
}

} // namespace

VkDeviceSize FixedImage::bytes(const gpu::Device& device, const gpu::ImageDesc& desc) {
    return gpu::heldBytes(device, uploadable(desc)) +
           gpu::heldBytes(device, gpu::imageBytes(desc), stagingUsage);
}

Status FixedImage::create(Context& context, const gpu::ImageDesc& desc, const char* what) {
    if (const Status s = image_.create(context.device, uploadable(desc), what); s != Status::ok) return s;
    return staging_.createMapped(context.device, gpu::imageBytes(desc), stagingUsage, what);
}

void FixedImage::recordUpload(const gpu::Device& device, VkCommandBuffer commands) {
    if (uploaded_) return;
    uploaded_ = true;
    constexpr gpu::Use nothing{};
    const VkImageMemoryBarrier2 before = gpu::imageBarrier(image_.handle(), nothing, gpu::copyWritten);
    gpu::recordBarriers(device, commands, &before, 1);
    const gpu::ImageDesc& desc = image_.desc();
    std::vector<VkBufferImageCopy> regions(desc.mipLevels);
    VkDeviceSize offset = 0;
    for (uint32_t mip = 0; mip < desc.mipLevels; ++mip) {
        gpu::ImageDesc one = desc;
        one.extent = {std::max(desc.extent.width >> mip, 1u), std::max(desc.extent.height >> mip, 1u)};
        one.mipLevels = 1;
        regions[mip].bufferOffset = offset;
        regions[mip].imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, desc.layers};
        regions[mip].imageExtent = {one.extent.width, one.extent.height, 1};
        offset += gpu::imageBytes(one);
    }
    device.vk().CmdCopyBufferToImage(commands, staging_.handle(), image_.handle(),
                                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, desc.mipLevels, regions.data());
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(image_.handle(), gpu::copyWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
}

} // namespace seaglass
