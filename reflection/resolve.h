// SSPR's second pass: from mirrored depths to colour, class and hit distance.
#pragma once

#include "gpu/context.h"
#include "gpu/image.h"
#include "gpu/kernel.h"

namespace seaglass {

struct ResolveKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Writes both images, which come from any layout. `info` is left to be sampled by shaders, mip 0 of `color`
/// as gpu::storageWritten says.
Status recordResolve(Context& context, const ResolveKernel& resolve, VkCommandBuffer commands,
                     const gpu::Slice& uniforms, const ViewDesc& view, const gpu::Buffer& keys,
                     const gpu::OwnedImage& color, const gpu::OwnedImage& info);

} // namespace seaglass
