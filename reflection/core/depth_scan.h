// Kernels that pass over the scene's depth once, and leave what they find of it in a buffer and in the flags
// of the tiles.
#pragma once

#include <span>

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"

namespace seaglass {

/// Binds mirror.glsl's block, the scene's depth, what is found and the tiles: what the kernel declares of
/// them.
Status allocateDepthScan(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Bound& found,
                         const gpu::Buffer& tiles, VkDescriptorSet& out);

/// After the dispatch: leaves what was found visible to compute shaders.
void recordScanned(const ReflectPass& pass);

} // namespace seaglass
