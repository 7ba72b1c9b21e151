// The sea's surface on the GPU: per cascade its displacement, derivatives and moments with whole mip chains.
// Whoever computes waves fills mip 0; what a mip holds is the mean over its footprint, so the moments' mips
// give the variance that the derivatives' mips lose.
#pragma once

#include <array>

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/memory/mip_chain.h"
#include "water/interface/waves_backend.h"

namespace seaglass {

constexpr VkFormat waveMapFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr uint32_t waveMapCount = 3;

/// A layer for each cascade, a texel for each sample, with a whole mip chain.
gpu::ImageDesc cascadeMapDesc(const gpu::Device& device, VkFormat format, uint32_t samples, uint32_t cascades,
                              VkImageUsageFlags filledBy);

struct WaveMaps {
    std::array<gpu::OwnedImage, waveMapCount> images; ///< displacement, derivatives, moments: see CascadeMaps
    uint32_t samples = 0;
    uint32_t cascades = 0;
    uint32_t mipLevels = 0;
    gpu::MipChain mips;

    /// `filledBy` is the usage that whoever fills mip 0 needs.
    Status create(Context& context, uint32_t samplesAcross, uint32_t cascadeCount,
                  VkImageUsageFlags filledBy);
    static VkDeviceSize bytes(const gpu::Device& device, uint32_t samplesAcross, uint32_t cascadeCount,
                              VkImageUsageFlags filledBy);
    /// Makes mip 0 ready to be `written`, its former content lost; readers of earlier frames are waited for.
    void recordBegin(const gpu::Device& device, VkCommandBuffer commands, const gpu::Use& written) const;
    /// Fills mip 0 of the first `count` cascades, ready for copies, from a buffer that holds map after map,
    /// cascade after cascade.
    void recordCopy(const gpu::Device& device, VkCommandBuffer commands, VkBuffer source,
                    uint32_t count) const;
    static VkDeviceSize mip0Bytes(uint32_t samplesAcross, uint32_t cascadeCount);
    /// From mip 0 `written` to all mips readable by shaders.
    Status recordMips(Context& context, VkCommandBuffer commands, const gpu::Use& written) const;
    /// From mip 0 `written` to mip 0 readable by shaders, with nothing in the others.
    void recordNoMips(const gpu::Device& device, VkCommandBuffer commands, const gpu::Use& written) const;
};

} // namespace seaglass
