// Follows mirrored rays over the picture, in the tiles of a list.
#pragma once

#include <memory>

#include "gpu/memory/buffer.h"
#include "reflection/core/color_kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"

namespace seaglass {

struct MarchKernel {
    ColorKernel kernel;
    bool takesNormals = false;
    Status create(Context& context, bool cells, bool open);
};

/// A type for each variant, for Context::share().
template<bool cells, bool open>
struct SharedMarch {
    MarchKernel march;
    Status create(Context& context) { return march.create(context, cells, open); }
};

/// `cells`: rays pass over cells of pixels (reflection/march/cells.h) and look at each pixel of the others;
/// else they go in strides. `open`: only pixels that another technique knew nothing of, without the view's
/// normals.
Status shareMarch(Context& context, bool cells, bool open, std::shared_ptr<MarchKernel>& out);

constexpr uint32_t marchDispatches = 1;

/// Completes both images in the resolve list of `tiles`. They come and go with `info` to be sampled by
/// shaders, mip 0 of `color` as gpu::storageWritten says. `cells`: null for a kernel that does without.
Status recordMarch(const ReflectPass& pass, MarchKernel& march, const gpu::Buffer& tiles,
                   const gpu::Buffer* cells, const OwnedReflection& images);

} // namespace seaglass
