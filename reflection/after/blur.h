// The reflection's pyramid: what rough surfaces, and scattered reflections, look up.
#pragma once

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel.h"

namespace seaglass {

struct BlurKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Mips of an image with one mip that stays sharp and `levels` halvings, fewer where it is too small.
uint32_t blurMipLevels(VkExtent2D extent, uint32_t levels);

/// From mip 0 written by a kernel to all mips sampled by shaders. One dispatch a halving; `blur` may be null
/// where there is none.
Status recordBlur(Context& context, VkCommandBuffer commands, const BlurKernel* blur,
                  const gpu::OwnedImage& color);

} // namespace seaglass
