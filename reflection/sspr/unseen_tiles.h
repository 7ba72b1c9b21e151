// The tiles of a reflection that are not looked up hold nothing: what is blurred, stretched or kept for the
// next frame may be read there, and hosts are promised it.
#pragma once

#include <memory>

#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"

namespace seaglass {

struct UnseenTilesKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Stays null on CPU devices, which clear whole images ten times faster than they store to some of their
/// pixels; on GPUs a clear may take twenty times as long as a reflection.
Status shareUnseenTiles(Context& context, std::shared_ptr<UnseenTilesKernel>& out);

/// 1, or 0 where it stays null.
uint32_t unseenTilesDispatches(const gpu::Device& device);

/// Leaves nothing in mip 0 of both images, which come from any layout, where the flags in `tiles` say that
/// nobody looks, and anything elsewhere; with a null `kernel` nothing anywhere. Both are left for kernels to
/// write.
Status recordUnseenTiles(const ReflectPass& pass, const UnseenTilesKernel* kernel, const gpu::Buffer& tiles,
                         const OwnedReflection& images);

} // namespace seaglass
