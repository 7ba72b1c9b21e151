#include "water/waves/wave_maps.h"

#include <bit>

namespace seaglass {

namespace {

constexpr const char* mapNames[waveMapCount] = {"wave displacement map", "wave derivative map",
                                                "wave moment map"};

} // namespace

gpu::ImageDesc cascadeMapDesc(const gpu::Device& device, VkFormat format, uint32_t samples, uint32_t cascades,
                              VkImageUsageFlags filledBy) {
    gpu::ImageDesc desc;
    desc.format = format;
    desc.extent = {samples, samples};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | gpu::MipChain::usage(device) |
                 filledBy;
    desc.mipLevels = static_cast<uint32_t>(std::bit_width(samples));
    desc.layers = cascades;
    desc.arrayView = true;
    return desc;
}

VkDeviceSize WaveMaps::bytes(const gpu::Device& device, uint32_t samplesAcross, uint32_t cascadeCount,
                             VkImageUsageFlags filledBy) {
    return gpu::heldBytes(device,
                          cascadeMapDesc(device, waveMapFormat, samplesAcross, cascadeCount, filledBy)) *
           waveMapCount;
}

Status WaveMaps::create(Context& context, uint32_t samplesAcross, uint32_t cascadeCount,
                        VkImageUsageFlags filledBy) {
    const gpu::Device& device = context.device;
    samples = samplesAcross;
    cascades = cascadeCount;
    const gpu::ImageDesc desc = cascadeMapDesc(device, waveMapFormat, samples, cascades, filledBy);
    mipLevels = desc.mipLevels;
    for (uint32_t i = 0; i < waveMapCount; ++i)
        if (const Status s = images[i].create(device, desc, mapNames[i]); s != Status::ok) return s;
    return mips.create(context, waveMapFormat);
}

void WaveMaps::recordBegin(const gpu::Device& device, VkCommandBuffer commands,
                           const gpu::Use& written) const {
    std::array<VkImageMemoryBarrier2, waveMapCount> barriers;
    for (uint32_t i = 0; i < waveMapCount; ++i)
        barriers[i] = gpu::imageBarrier(images[i].handle(), gpu::discardedAfterSampling, written, 0, 1);
    gpu::recordBarriers(device, commands, barriers.data(), waveMapCount);
}

VkDeviceSize WaveMaps::mip0Bytes(uint32_t samplesAcross, uint32_t cascadeCount) {
    constexpr VkDeviceSize texelBytes = 4 * sizeof(float);
    return VkDeviceSize{samplesAcross} * samplesAcross * cascadeCount * texelBytes * waveMapCount;
}

void WaveMaps::recordCopy(const gpu::Device& device, VkCommandBuffer commands, VkBuffer source,
                          uint32_t count) const {
    for (uint32_t map = 0; map < waveMapCount; ++map) {
        VkBufferImageCopy region{};
        region.bufferOffset = mip0Bytes(samples, cascades) / waveMapCount * map;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, count};
        region.imageExtent = {samples, samples, 1};
        device.vk().CmdCopyBufferToImage(commands, source, images[map].handle(),
                                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    }
}

void WaveMaps::recordNoMips(const gpu::Device& device, VkCommandBuffer commands,
                            const gpu::Use& written) const {
    std::array<VkImageMemoryBarrier2, 2 * waveMapCount> barriers;
    for (uint32_t i = 0; i < waveMapCount; ++i) {
        const VkImage image = images[i].handle();
        barriers[2 * i] = gpu::imageBarrier(image, written, gpu::sampledByShaders, 0, 1);
        barriers[2 * i + 1] =
            gpu::imageBarrier(image, gpu::discardedAfterSampling, gpu::sampledByShaders, 1, mipLevels - 1);
    }
    gpu::recordBarriers(device, commands, barriers.data(), 2 * waveMapCount);
}

Status WaveMaps::recordMips(Context& context, VkCommandBuffer commands, const gpu::Use& written) const {
    const gpu::PassScope pass(context.device, commands, "waves_mips");
    const gpu::OwnedImage* const all[waveMapCount] = {&images[0], &images[1], &images[2]};
    return mips.record(context, commands, all, written);
}

} // namespace seaglass
