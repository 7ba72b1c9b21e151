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

Status recordSurface(Context& context, VkCommandBuffer commands, const DrawPipeline& pipeline,
                     const PlacedMesh& mesh, Instances drawn, std::vector<gpu::Bound> resources,
                     uint32_t viewIndex) {
    resources.push_back({meshBinding, mesh.patches});
    resources.push_back({extentBinding, mesh.extent});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline.layout, resources, set); s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, "surface");
    const gpu::DeviceTable& vk = context.device.vk();
    bindDraw(context.device, commands, pipeline, set, viewIndex);
    vk.CmdBindIndexBuffer(commands, mesh.indices, 0, mesh.indexType);
    vk.CmdDrawIndexed(commands, mesh.indexCount, drawn.count, mesh.firstIndex, 0, drawn.first);
    return Status::ok;
}

} // namespace seaglass
