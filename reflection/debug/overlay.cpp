#include "reflection/debug/overlay.h"

#include <algorithm>

#include "reflection/core/mirror.h"
#include "reflection/interface/fields/reflection.h"
#include "shaders/shared/overlay_block.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/overlay.comp.h"

namespace seaglass {

Status OverlayKernel::create(Context& context) {
    return kernel.create(context.device, overlay_comp, "overlay pipeline");
}

bool showsReflection(OverlayKind kind) {
    return kind != OverlayKind::depth && kind != OverlayKind::plane;
}

FieldError badField(const OverlayDesc& desc, const ViewDesc& view) {
    if (const FieldError bad = badField(overlayFields, &desc)) return bad;
    const Image& target = desc.target;
    if (!target.view) return "OverlayDesc.target.view is null";
    if (target.format != VK_FORMAT_R16G16B16A16_SFLOAT)
        return "OverlayDesc.target.format is not VK_FORMAT_R16G16B16A16_SFLOAT";
    if (target.layout != VK_IMAGE_LAYOUT_GENERAL)
        return "OverlayDesc.target.layout is not VK_IMAGE_LAYOUT_GENERAL";
    const VkViewport& v = view.viewport;
    if (std::max(v.x, v.x + v.width) > static_cast<float>(target.extent.width) ||
        std::max(v.y, v.y + v.height) > static_cast<float>(target.extent.height))
        return "OverlayDesc.target is smaller than the viewport";
    return nullptr;
}

Status recordOverlay(const ReflectPass& pass, const OverlayKernel& overlay, const ReflectionImages& images,
                     const OverlayDesc& desc) {
    Context& context = pass.context;
    const ViewGeometry& view = pass.geometry;
    OverlayBlock block{};
    block.forwardRow = glm::vec4(glm::dvec4(view.forward, 0) * relativeFromScenePixel(view));
    block.contourSpacing = desc.contourSpacing;
    block.kind = static_cast<int32_t>(desc.kind);
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;

    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const gpu::Resource sceneDepth = gpu::sampledImage(nearest, depth.view, depth.layout);
    // What a kind does not show needs something to point at.
    const bool shown = showsReflection(desc.kind);
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {settingsBinding, gpu::uniformBuffer(slice)},
        {sceneDepthBinding, sceneDepth},
        {reflectionColorBinding, shown ? gpu::sampledImage(nearest, images.color) : sceneDepth},
        {reflectionInfoBinding, shown ? gpu::sampledImage(nearest, images.info) : sceneDepth},
        {overlayTargetBinding, gpu::storageImage(desc.target.view, desc.target.format)},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(overlay.kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_overlay");
    overlay.kernel.dispatchOver(pass.commands, set, pass.extent());
    return Status::ok;
}

} // namespace seaglass
