#include "water/surface/surface.h"

#include <vector>

#include "shaders/shared/water_bindings.h"
#include "spirv/surface.vert.h"

namespace seaglass {

SurfaceVariant shapeVariant(const SurfaceVariant& all) {
    SurfaceVariant v;
    v.hasWaves = all.hasWaves;
    v.hasShore = all.hasShore;
    v.shape = all.shape;
    v.cascades = all.cascades;
    v.isWarped = all.isWarped;
    v.exclusionVolumes = all.exclusionVolumes;
    v.onGlobe = all.onGlobe;
    return v;
}

Status buildMeshPipeline(const gpu::Device& device, const TargetDesc& target,
                         std::span<const uint32_t> fragment, const SurfaceVariant& variant, const char* what,
                         DrawPipeline& out) {
    SurfaceVariant drawn = variant;
    drawn.inViews = target.viewMask != 0;
    drawn.targetIsEncoded = target.encoding == Encoding::srgb;
    return createDrawPipeline(device, target, {surface_vert, fragment, drawn.constants()}, Drawing::solid,
                              what, out);
}

Status recordSurface(Context& context, VkCommandBuffer commands, std::span<const InstancesDraw> draws,
                     const PlacedMesh& mesh, std::vector<gpu::Bound> resources, uint32_t viewIndex) {
    resources.push_back({meshBinding, mesh.patches});
    resources.push_back({extentBinding, mesh.extent});
    const gpu::PassScope pass(context.device, commands, "surface");
    const gpu::DeviceTable& vk = context.device.vk();
    vk.CmdBindIndexBuffer(commands, mesh.indices, 0, mesh.indexType);
    const gpu::Layout* filled = nullptr;
    VkDescriptorSet set = VK_NULL_HANDLE;
    for (const auto& [pipeline, drawn] : draws) {
        if (drawn.count == 0) continue;
        if (!filled || !filled->sharesSets(pipeline->layout)) {
            filled = &pipeline->layout;
            if (const Status s = context.frame().allocateSet(*filled, resources, set); s != Status::ok)
                return s;
        }
        bindDraw(context.device, commands, *pipeline, set, viewIndex);
        vk.CmdDrawIndexed(commands, mesh.indexCount, drawn.count, mesh.firstIndex, 0, drawn.first);
    }
    return Status::ok;
}

} // namespace seaglass
