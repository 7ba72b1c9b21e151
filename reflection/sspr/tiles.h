// The picture in tiles of 8 x 8 pixels, and lists of those that are worth a dispatch:
// shaders/reflection/sspr/tiles.glsl. Most of a picture is not a mirror, and devices that mask branches pay
// for every pixel that is dispatched.
#pragma once

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"
#include "shaders/shared/tiles_block.h"

namespace seaglass {

/// For a reflection of `extent` pixels.
Status createTiles(const gpu::Device& device, VkExtent2D extent, const char* what, gpu::Buffer& out);
VkDeviceSize heldByTiles(const gpu::Device& device, VkExtent2D extent);

/// Flags the plane as seen in every tile; leaves lists that say nothing.
void recordAllSeen(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& tiles);

struct TilesKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// Looks for what hangs over tiles, too.
struct OverhangsTilesKernel {
    TilesKernel tiles;
    Status create(Context& context);
};

/// Dispatches a kernel that takes an invocation a tile and fills lists; leaves them visible to compute
/// shaders and indirect dispatches.
void recordTileLists(const ReflectPass& pass, const gpu::Kernel& kernel, VkDescriptorSet set);

/// Fills the lists by the flags and keys that the scatter left; leaves them visible to compute shaders and
/// indirect dispatches.
Status recordTiles(const ReflectPass& pass, const TilesKernel& kernel, const gpu::Buffer& keys,
                   const gpu::Buffer& tiles);

} // namespace seaglass
