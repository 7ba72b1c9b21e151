// Screen-space reflection (SSR): follows each pixel's mirrored ray over the picture.
#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel.h"
#include "reflection/reflect_pass.h"
#include "reflection/reflection_images.h"

namespace seaglass {

struct MarchKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

constexpr uint32_t marchDispatches = 1;

/// Writes both images, which come from any layout. `info` is left to be sampled by shaders, mip 0 of `color`
/// as gpu::storageWritten says.
Status recordMarch(const ReflectPass& pass, const MarchKernel& march, const OwnedReflection& images);

/// Only where another technique knew nothing.
struct OpenMarchKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Completes both images in the resolve list of `open`. They come as recordMarch() leaves them, and go so.
Status recordOpenMarch(const ReflectPass& pass, const OpenMarchKernel& march, const gpu::Buffer& open,
                       const OwnedReflection& images);

} // namespace seaglass
