// SSPR's first pass: mirrored depths, one key a pixel.
#pragma once

#include "gpu/context.h"
#include "gpu/kernel.h"

namespace seaglass {

struct ScatterKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Clears `keys` (one uint32 a pixel of the region) and scatters into it. `uniforms` holds MirrorUniforms.
/// Leaves the keys visible to compute shaders.
Status recordScatter(Context& context, const ScatterKernel& scatter, VkCommandBuffer commands,
                     const gpu::Slice& uniforms, const Image& sceneDepth, const gpu::Buffer& keys,
                     VkExtent2D region);

} // namespace seaglass
