// SSPR's first pass: mirrored depths, one key a pixel.
#pragma once

#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"

namespace seaglass {

/// One key a pixel.
struct ScatterKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// One key for several pixels.
struct CoarseScatterKernel {
    ScatterKernel scatter;
    Status create(Context& context);
};

/// Clears `keys` (one uint32 each) and `tiles`, and scatters into both. Leaves them visible
/// to compute shaders.
Status recordScatter(const ReflectPass& pass, const ScatterKernel& scatter, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles);

} // namespace seaglass
