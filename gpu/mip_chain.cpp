#include "gpu/mip_chain.h"

#include <algorithm>
#include <vector>

namespace seaglass::gpu {

namespace {

constexpr Use blitWritten = {VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr Use blitRead = {VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkOffset3D mipSize(const ImageDesc& desc, uint32_t mip) {
    const auto halved = [&](uint32_t size) { return static_cast<int32_t>(std::max(size >> mip, 1u)); };
    return {halved(desc.extent.width), halved(desc.extent.height), 1};
}

void blit(const Device& device, VkCommandBuffer commands, const OwnedImage& image, uint32_t mip) {
    const ImageDesc& desc = image.desc();
    VkImageBlit region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, desc.layers};
    region.srcOffsets[1] = mipSize(desc, mip - 1);
    region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, desc.layers};
    region.dstOffsets[1] = mipSize(desc, mip);
    device.vk().CmdBlitImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.handle(),
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_LINEAR);
}

/// One barrier an image and span of mips, gathered so that each step costs one command.
class Barriers {
  public:
    explicit Barriers(std::span<const OwnedImage* const> images) : images_(images) {}
    Barriers& add(const Use& before, const Use& after, uint32_t firstMip, uint32_t mips) {
        if (mips > 0)
            for (const OwnedImage* image : images_)
                list_.push_back(imageBarrier(image->handle(), before, after, firstMip, mips));
        return *this;
    }
    void record(const Device& device, VkCommandBuffer commands) {
        recordBarriers(device, commands, list_.data(), static_cast<uint32_t>(list_.size()));
        list_.clear();
    }

  private:
    std::span<const OwnedImage* const> images_;
    std::vector<VkImageMemoryBarrier2> list_;
};

} // namespace

void recordMipChain(const Device& device, VkCommandBuffer commands, std::span<const OwnedImage* const> images,
                    const Use& written) {
    const uint32_t mips = images.front()->desc().mipLevels;
    Barriers barriers(images);
    if (mips == 1) {
        barriers.add(written, sampledByShaders, 0, 1).record(device, commands);
        return;
    }
    barriers.add(written, blitRead, 0, 1)
        .add(discardedAfterSampling, blitWritten, 1, mips - 1)
        .record(device, commands);
    for (uint32_t mip = 1; mip < mips; ++mip) {
        if (mip > 1) barriers.add(blitWritten, blitRead, mip - 1, 1).record(device, commands);
        for (const OwnedImage* image : images) blit(device, commands, *image, mip);
    }
    barriers.add(blitRead, sampledByShaders, 0, mips - 1).add(blitWritten, sampledByShaders, mips - 1, 1);
    barriers.record(device, commands);
}

} // namespace seaglass::gpu
