// The reflection's pyramid: what a rough surface looks its reflection up in.
#pragma once

#include "gpu/context.h"
#include "gpu/image.h"

namespace seaglass {

/// Mips of an image with one mip that stays sharp and `levels` halvings, fewer where it is too small.
uint32_t blurMipLevels(VkExtent2D extent, uint32_t levels);

/// From mip 0 written by a kernel to all mips sampled by shaders. Colour is premultiplied by confidence, so
/// that the mean of a hole and a hit is half a hit.
void recordBlur(Context& context, VkCommandBuffer commands, const gpu::OwnedImage& color);

} // namespace seaglass
