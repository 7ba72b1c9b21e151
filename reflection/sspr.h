// Screen-space planar reflection: scatters mirrored depths, then resolves them to colour.
#pragma once

#include "reflection/reflection_images.h"
#include "reflection/resolve.h"
#include "reflection/scatter.h"
#include "reflection/tiles.h"

namespace seaglass {

struct SsprKernels {
    ScatterKernel scatter;
    TilesKernel tiles;
    ResolveKernel resolve;
    Status create(Context& context);
};

/// What SSPR needs for one view besides its images.
struct SsprScratch {
    gpu::Buffer keys;
    gpu::Buffer tiles;
    Status create(const gpu::Device& device, VkExtent2D extent);
    static VkDeviceSize bytes(VkExtent2D extent);
};

/// Scatter, tiles, and a resolve for each list.
constexpr uint32_t ssprDispatches = 4;

/// Writes mip 0 of `images.color`, left as gpu::storageWritten says, and `images.info`, left to be sampled.
Status recordSspr(const ReflectPass& pass, const SsprKernels& kernels, const SsprScratch& scratch,
                  const OwnedReflection& images);

} // namespace seaglass
