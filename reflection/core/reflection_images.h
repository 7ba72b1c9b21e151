// What every technique leaves for a view: the picture the plane mirrors, and what is known about each pixel
// of it.
#pragma once

#include "gpu/memory/image.h"
#include "seaglass/reflection.h"

namespace seaglass {

/// The size of a view's reflection, or of its keys.
constexpr VkExtent2D scaledDown(VkExtent2D extent, uint32_t scale) {
    return {(extent.width + scale - 1) / scale, (extent.height + scale - 1) / scale};
}

/// Of a description by which sizedFor() has gone.
VkExtent2D scaledDown(VkExtent2D extent, const ReflectionDesc& sized);

constexpr VkFormat reflectionColorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

struct OwnedReflection {
    gpu::OwnedImage color; ///< RGBA16F, premultiplied by confidence, with the pyramid's mips
    gpu::OwnedImage info;  ///< R16F, see shaders/host/reflection_info.glsl

    /// `drawnInto`: mip 0 of the colour is an attachment too.
    Status create(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels, bool drawnInto);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels,
                              bool drawnInto);
    /// Mip 0 of both, which come from any layout, for `use` to write; what they held is lost.
    void recordDiscarded(const gpu::Device& device, VkCommandBuffer commands, const gpu::Use& use) const;
    /// Mip 0 of both, as techniques leave them, for a kernel to read and write.
    void recordToBeChanged(const gpu::Device& device, VkCommandBuffer commands) const;
    /// `info` from written by a kernel to sampled by shaders.
    void recordInfoSampled(const gpu::Device& device, VkCommandBuffer commands) const;
    ReflectionImages handles() const;
};

} // namespace seaglass
