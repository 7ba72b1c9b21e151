// SSPR first, and a ray only where it knows nothing.
#pragma once

#include "reflection/march/cells.h"
#include "reflection/march/march.h"
#include "reflection/march/open_tiles.h"
#include "reflection/sspr/sspr.h"

namespace seaglass {

struct HybridKernels {
    std::shared_ptr<CellsKernel> cells; ///< null without ReflectionDesc::marchCells
    std::shared_ptr<OpenTilesKernel> openTiles;
    std::shared_ptr<MarchKernel> march;
    Status create(Context& context, const ReflectionDesc& desc);
};

/// What the hybrid needs for one view besides SSPR's.
struct HybridScratch {
    gpu::Buffer cells; ///< empty without ReflectionDesc::marchCells
    gpu::Buffer open;
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
};

uint32_t hybridDispatches(const ReflectionDesc& desc);

/// As recordSspr().
Status recordHybrid(const ReflectPass& pass, const SsprKernels& sspr, const HybridKernels& hybrid,
                    const SsprScratch& ssprScratch, const HybridScratch& scratch,
                    const OwnedReflection& images);

} // namespace seaglass
