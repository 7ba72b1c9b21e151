// SSPR first, and a ray only where it knows nothing.
#pragma once

#include "reflection/march.h"
#include "reflection/open_tiles.h"
#include "reflection/sspr.h"

namespace seaglass {

struct HybridKernels {
    OpenTilesKernel openTiles;
    OpenMarchKernel march;
    Status create(Context& context);
};

/// What the hybrid needs for one view besides SSPR's.
struct HybridScratch {
    gpu::Buffer open;
    Status create(const gpu::Device& device, VkExtent2D imageExtent);
};

constexpr uint32_t hybridDispatches = ssprDispatches + 1 + marchDispatches;

/// As recordSspr().
Status recordHybrid(const ReflectPass& pass, const SsprKernels& sspr, const HybridKernels& hybrid,
                    const SsprScratch& ssprScratch, const HybridScratch& scratch,
                    const OwnedReflection& images);

} // namespace seaglass
