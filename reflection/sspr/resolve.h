// SSPR's second pass: from mirrored depths to colour, class and hit distance.
#pragma once

#include "reflection/core/color_kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"
#include "reflection/sspr/unseen_tiles.h"

namespace seaglass {

struct ResolveKernel {
    ColorKernel kernel;
    gpu::Kernel miss; ///< for tiles that no key is near
    std::shared_ptr<UnseenTilesKernel> unseen;
    Status create(Context& context);
};

/// Looks for what hangs over the mirror, too.
struct OverhangsResolveKernel {
    ResolveKernel resolve;
    Status create(Context& context);
};

/// Writes both images, which come from any layout, where `tiles` lists tiles, and leaves nothing in them
/// elsewhere. `info` is left to be sampled by shaders, mip 0 of `color` as gpu::storageWritten says.
Status recordResolve(const ReflectPass& pass, ResolveKernel& resolve, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles, const OwnedReflection& images);

} // namespace seaglass
