// Screen-space planar reflection: scatters mirrored depths, then resolves them to colour.
#pragma once

#include "reflection/core/reflection_images.h"
#include "reflection/sspr/resolve.h"
#include "reflection/sspr/scatter.h"
#include "reflection/sspr/tiles.h"

namespace seaglass {

struct SsprKernels {
    std::shared_ptr<ScatterKernel> scatter, coarseScatter; ///< null where no view needs it
    std::shared_ptr<TilesKernel> tiles;
    std::shared_ptr<ResolveKernel> resolve;
    /// Those that `desc` needs, shared with all who need them.
    Status create(Context& context, const ReflectionDesc& desc);
};

/// What SSPR needs for one view besides its images.
struct SsprScratch {
    gpu::Buffer keys;
    gpu::Buffer tiles;
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
};

/// Scatter, tiles, and a resolve for each list; besides those of tiles that are not looked up.
constexpr uint32_t ssprDispatches = 4;

/// Writes mip 0 of `images.color`, left as gpu::storageWritten says, and `images.info`, left to be sampled.
Status recordSspr(const ReflectPass& pass, SsprKernels& kernels, SsprScratch& scratch,
                  const OwnedReflection& images);

} // namespace seaglass
