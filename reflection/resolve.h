// SSPR's second pass: from mirrored depths to colour, class and hit distance.
#pragma once

#include "gpu/kernel.h"
#include "reflection/reflect_pass.h"
#include "reflection/reflection_images.h"

namespace seaglass {

struct ResolveKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Writes both images, which come from any layout. `info` is left to be sampled by shaders, mip 0 of `color`
/// as gpu::storageWritten says.
Status recordResolve(const ReflectPass& pass, const ResolveKernel& resolve, const gpu::Buffer& keys,
                     const OwnedReflection& images);

} // namespace seaglass
