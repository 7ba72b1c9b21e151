// Lists of the tiles in which a reflection is looked up: where rays are followed, or something else is done
// with it.
#pragma once

#include "reflection/core/reflection_images.h"
#include "reflection/sspr/tiles.h"

namespace seaglass {

/// All that are looked up.
struct SeenTilesKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// The same, to be taken column by column.
struct SeenColumnsKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Those in which a reflection still holds pixels that nothing is known of.
struct OpenTilesKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Fills the resolve list of `tiles` by its own flags.
Status recordSeenTiles(const ReflectPass& pass, const SeenTilesKernel& kernel, const gpu::Buffer& tiles);

/// Fills the list of columns by the flags in `tiles`, whose own lists are done with and lost. The list is
/// left visible to compute shaders and indirect dispatches.
Status recordSeenColumns(const ReflectPass& pass, const SeenColumnsKernel& kernel, const gpu::Buffer& tiles);

/// Fills the resolve list of `open` from SSPR's flags in `sorted` and the info it left to be sampled. Both
/// leave the list visible to compute shaders and indirect dispatches.
Status recordOpenTiles(const ReflectPass& pass, const OpenTilesKernel& kernel, const gpu::Buffer& sorted,
                       const OwnedReflection& images, const gpu::Buffer& open);

} // namespace seaglass
