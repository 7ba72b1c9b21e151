// What every technique is given to record the reflection of one view.
#pragma once

#include "gpu/context.h"
#include "gpu/view/view.h"
#include "seaglass/reflection.h"

namespace seaglass {

struct ReflectPass {
    Context& context;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    const ViewDesc& view;
    const ViewGeometry& geometry;
    const ReflectionDesc& desc;
    gpu::Slice mirror;       ///< MirrorBlock
    const glm::dvec4& plane; ///< in the world, unit normal

    /// Of the view's region [pixel].
    VkExtent2D extent() const { return extentOf(geometry); }
};

} // namespace seaglass
