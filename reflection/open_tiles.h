// The tiles in which a reflection still holds pixels that nothing is known of.
#pragma once

#include "reflection/reflection_images.h"
#include "reflection/tiles.h"

namespace seaglass {

struct OpenTilesKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Fills the resolve list of `open` from SSPR's flags in `sorted` and the info it left to be sampled; leaves
/// the list visible to compute shaders and indirect dispatches.
Status recordOpenTiles(const ReflectPass& pass, const OpenTilesKernel& kernel, const gpu::Buffer& sorted,
                       const OwnedReflection& images, const gpu::Buffer& open);

} // namespace seaglass
