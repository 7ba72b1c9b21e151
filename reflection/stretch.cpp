#include "reflection/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "reflection/mirror.h"
#include "spirv/stretch.comp.h"

namespace seaglass {

namespace {

/// The std140 block of shaders/stretch.comp.
struct StretchUniforms {
    float perMetre = 0;
    int32_t band = 0;
    int32_t along = 0;
    int32_t padding = 0;
};

StretchUniforms uniformsOf(const ReflectPass& pass, VkExtent2D extent) {
    MirrorUniforms mirror;
    std::memcpy(&mirror, pass.mirror.data, sizeof mirror);
    StretchUniforms out;
    const double down = -glm::dot(pass.geometry.forward, glm::dvec3(mirror.plane));
    out.perMetre = pass.desc.edgeStretch * static_cast<float>(std::max(down, 0.0));
    // Height above the horizon grows along the columns that mirror into themselves.
    out.along = std::abs(mirror.heightRow.y) >= std::abs(mirror.heightRow.x) ? 0 : 1;
    const uint32_t length = out.along == 0 ? extent.width : extent.height;
    out.band = std::max(static_cast<int32_t>(pass.desc.edgeStretchBand * static_cast<float>(length)), 1);
    return out;
}

} // namespace

Status StretchKernel::create(Context& context) {
    return kernel.create(context.device, stretch_comp, "stretch pipeline");
}

Status recordStretch(const ReflectPass& pass, const StretchKernel& stretch, const OwnedReflection& images) {
    Context& context = pass.context;
    const VkExtent2D extent = images.color.desc().extent;
    const StretchUniforms uniforms = uniformsOf(pass, extent);
    gpu::Slice slice;
    if (const Status s = context.frame().upload(uniforms, slice); s != Status::ok) return s;
    const gpu::Bound resources[] = {
        {0, gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms))},
        {1, gpu::uniformBuffer(slice.buffer, slice.offset, sizeof uniforms)},
        {2, gpu::storageImage(images.color.firstMipView())},
        {3, gpu::storageImage(images.info.view())},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(stretch.kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_stretch");
    images.recordToBeChanged(context.device, pass.commands);
    const uint32_t lines = uniforms.along == 0 ? extent.height : extent.width;
    stretch.kernel.dispatchAlong(pass.commands, set, lines, 2);
    images.recordInfoSampled(context.device, pass.commands);
    return Status::ok;
}

} // namespace seaglass
