// Mip chains by halving.
#pragma once

#include <span>

#include "gpu/image.h"

namespace seaglass::gpu {

/// Fills every mip of each image from its mip 0, which `written` has left, all layers, and leaves all of them
/// to be sampled by shaders. What the other mips held is lost. All images have as many mips. Each mip is the
/// linear filter's mean of the one before.
void recordMipChain(const Device& device, VkCommandBuffer commands, std::span<const OwnedImage* const> images,
                    const Use& written);

} // namespace seaglass::gpu
