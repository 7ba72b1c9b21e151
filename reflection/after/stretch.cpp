#include "reflection/after/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "reflection/core/mirror.h"
#include "shaders/shared/reflection_bindings.h"
#include "shaders/shared/stretch_block.h"
#include "spirv/stretch.comp.h"

namespace seaglass {

namespace {

StretchBlock blockOf(const ReflectPass& pass, VkExtent2D extent) {
    MirrorBlock mirror;
    std::memcpy(&mirror, pass.mirror.data, sizeof mirror);
    StretchBlock out{};
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
    const StretchBlock block = blockOf(pass, extent);
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {settingsBinding, gpu::uniformBuffer(slice)},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(stretch.kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_stretch");
    images.recordToBeChanged(context.device, pass.commands);
    const uint32_t lines = block.along == 0 ? extent.height : extent.width;
    stretch.kernel.dispatchAlong(pass.commands, set, lines, 2);
    images.recordInfoSampled(context.device, pass.commands);
    return Status::ok;
}

} // namespace seaglass
