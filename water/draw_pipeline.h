// Graphics pipelines that draw into a host's pass.
#pragma once

#include <span>

#include "gpu/binding.h"
#include "seaglass/water.h"

namespace seaglass {

/// What becomes of what is drawn.
enum class Drawing {
    solid,   ///< depth tested and written, no blending
    over,    ///< replaces the colour, whatever the depth
    blended, ///< the same by its alpha; the target's alpha stays
    scaled,  ///< multiplies the colour; the target's alpha stays
};

struct DrawPipeline {
    gpu::Layout layout;
    VkPipeline handle = VK_NULL_HANDLE;
};

struct DrawShaders {
    std::span<const uint32_t> vertex;
    std::span<const uint32_t> fragment;
    std::span<const uint32_t> constants; ///< of both shaders, number 0 first
};

/// Triangles seen from both sides. `out.layout` is there already.
Status createDrawPipeline(const gpu::Device& device, const TargetDesc& target, const DrawShaders& shaders,
                          Drawing drawing, const char* what, DrawPipeline& out);

} // namespace seaglass
