// What is behind seaglass::Reflector: one plane, one technique, and the images of each view that looked at
// it.
#pragma once

#include <array>
#include <memory>

#include <glm/vec4.hpp>

#include "gpu/context.h"
#include "gpu/image.h"
#include "reflection/limits.h"
#include "reflection/resolve.h"
#include "reflection/scatter.h"
#include "seaglass/reflection.h"

namespace seaglass {

struct SsprKernels {
    ScatterKernel scatter;
    ResolveKernel resolve;
    Status create(Context& context);
};

/// What SSPR keeps for one view.
struct SsprImages {
    gpu::Buffer keys;
    gpu::OwnedImage color;
    gpu::OwnedImage info;
    Status create(const gpu::Device& device, VkExtent2D extent, uint32_t blurLevels);
};

/// Null when the description is usable, else what is wrong with it.
const char* badField(const ReflectionDesc& desc);

struct Reflector {
    Context* context = nullptr;
    glm::dvec4 plane{0}; ///< world, unit normal
    ReflectionDesc desc;
    std::shared_ptr<SsprKernels> kernels; ///< null with technique `sky`
    std::array<SsprImages, maxViews> views;

    Status create(Context& owner, const ReflectorDesc& description);
    Status record(VkCommandBuffer commands, const ViewDesc& view);
    ReflectionImages images(uint32_t viewIndex) const;
};

} // namespace seaglass
