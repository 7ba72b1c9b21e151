#include "water/wave_maps.h"

#include <algorithm>
#include <bit>

namespace seaglass {

namespace {

constexpr gpu::Use transferWritten = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr gpu::Use transferRead = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

constexpr const char* mapNames[waveMapCount] = {"wave displacement map", "wave derivative map",
                                                "wave moment map"};

template<typename MakeBarrier>
void barrierOnAll(const gpu::Device& device, VkCommandBuffer commands,
                  const std::array<gpu::OwnedImage, waveMapCount>& images, MakeBarrier&& make) {
    std::array<VkImageMemoryBarrier2, waveMapCount> barriers;
    std::transform(images.begin(), images.end(), barriers.begin(),
                   [&](const gpu::OwnedImage& image) { return make(image.handle()); });
    gpu::recordBarriers(device, commands, barriers.data(), waveMapCount);
}

void blitLevel(const gpu::Device& device, VkCommandBuffer commands, VkImage image, uint32_t level,
               int32_t edge, uint32_t layers) {
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, layers};
    blit.srcOffsets[1] = {edge * 2, edge * 2, 1};
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, layers};
    blit.dstOffsets[1] = {edge, edge, 1};
    device.vk().CmdBlitImage(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
}

} // namespace

Status WaveMaps::create(const gpu::Device& device, uint32_t samplesAcross, uint32_t cascadeCount) {
    samples = samplesAcross;
    cascades = cascadeCount;
    mipLevels = static_cast<uint32_t>(std::bit_width(samplesAcross));
    gpu::ImageDesc desc;
    desc.format = waveMapFormat;
    desc.extent = {samples, samples};
    desc.usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    desc.mipLevels = mipLevels;
    desc.layers = cascades;
    desc.arrayView = true;
    for (uint32_t i = 0; i < waveMapCount; ++i)
        if (const Status s = images[i].create(device, desc, mapNames[i]); s != Status::ok) return s;
    return Status::ok;
}

void WaveMaps::recordBeginUpload(const gpu::Device& device, VkCommandBuffer commands) const {
    gpu::Use before = gpu::sampledByShaders;
    before.access = VK_ACCESS_2_NONE;
    before.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrierOnAll(device, commands, images,
                 [&](VkImage image) { return gpu::imageBarrier(image, before, transferWritten); });
}

void WaveMaps::recordMips(const gpu::Device& device, VkCommandBuffer commands) const {
    for (uint32_t level = 1; level < mipLevels; ++level) {
        barrierOnAll(device, commands, images, [&](VkImage image) {
            return gpu::imageBarrier(image, transferWritten, transferRead, level - 1, 1);
        });
        for (const gpu::OwnedImage& image : images)
            blitLevel(device, commands, image.handle(), level, static_cast<int32_t>(samples >> level),
                      cascades);
    }
    if (mipLevels > 1)
        barrierOnAll(device, commands, images, [&](VkImage image) {
            return gpu::imageBarrier(image, transferRead, gpu::sampledByShaders, 0, mipLevels - 1);
        });
    barrierOnAll(device, commands, images, [&](VkImage image) {
        return gpu::imageBarrier(image, transferWritten, gpu::sampledByShaders, mipLevels - 1, 1);
    });
}

} // namespace seaglass
