// How near the nearest thing above the plane is, in cells of 8 x 8 pixels and in blocks of 64 x 64. A ray
// passes over squares in which all lies farther than it does without looking at their pixels.
#pragma once

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"

namespace seaglass {

struct CellsKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// `extent`: of the view's region.
Status createCells(const gpu::Device& device, VkExtent2D extent, const char* what, gpu::Buffer& out);
VkDeviceSize heldByCells(const gpu::Device& device, VkExtent2D extent);

constexpr uint32_t cellsDispatches = 1;

/// Fills `cells`, and flags in `tiles` where the plane is seen or, with lookups that bend, may be looked up;
/// both are left visible to compute shaders.
Status recordCells(const ReflectPass& pass, const CellsKernel& kernel, const gpu::Buffer& cells,
                   const gpu::Buffer& tiles);

} // namespace seaglass
