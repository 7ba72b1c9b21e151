// Screen-space reflection: finds the tiles in which the plane is seen, and follows each pixel's mirrored ray
// there.
#pragma once

#include "reflection/march/cells.h"
#include "reflection/march/march.h"
#include "reflection/march/open_tiles.h"
#include "reflection/sspr/unseen_tiles.h"

namespace seaglass {

struct SsrKernels {
    std::shared_ptr<CellsKernel> cells;
    std::shared_ptr<SeenTilesKernel> seenTiles;
    std::shared_ptr<UnseenTilesKernel> unseen;
    std::shared_ptr<MarchKernel> march;
    Status create(Context& context, const ReflectionDesc& desc);
};

/// What SSR needs for one view besides its images.
struct SsrScratch {
    gpu::Buffer cells;
    gpu::Buffer tiles;
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
};

} // namespace seaglass
