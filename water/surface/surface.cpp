#include "water/surface/surface.h"

#include <vector>

#include "shaders/shared/water_bindings.h"
#include "spirv/motion.frag.h"
#include "spirv/surface.frag.h"
#include "spirv/surface.vert.h"
#include "water/body/body_block.h"

namespace seaglass {

namespace {

/// All that some pipeline's shaders read.
std::vector<gpu::Bound> resources(const Context& context, const SurfaceInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    const VkSampler repeat = samplers.trilinearRepeat(), clamp = samplers.trilinearClamp(),
                    nearest = samplers.nearestClamp();
    const LightingDesc& light = *in.lighting;
    std::vector<gpu::Bound> list;
    const auto bind = [&](uint32_t number, const gpu::Resource& resource) {
        list.push_back({number, resource});
    };
    const auto bindImage = [&](uint32_t number, const Image& image) {
        bind(number, gpu::sampledImage(nearest, image.view, image.layout));
    };
    bind(bodyBinding, gpu::uniformBuffer(in.uniforms));
    bind(meshBinding, in.patches);
    bind(skyCubeBinding, gpu::sampledImage(clamp, light.skyCube, light.skyCubeLayout));
    bind(waveDisplacementBinding, gpu::sampledImage(repeat, in.waveMaps[0]));
    bind(waveDerivativesBinding, gpu::sampledImage(repeat, in.waveMaps[1]));
    bind(waveMomentsBinding, gpu::sampledImage(repeat, in.waveMaps[2]));
    bind(shoreMapBinding, gpu::sampledImage(clamp, in.shoreMap));
    bind(shoreSignalBinding, in.shoreRows);
    bind(extentBinding, in.extent);
    bind(lastDisplacementBinding, gpu::sampledImage(repeat, in.lastDisplacement));
    bind(foamPatternBinding, gpu::sampledImage(repeat, in.foamPattern));
    bind(foamHistoryBinding, gpu::sampledImage(repeat, in.foamHistory));
    bind(reflectionColorBinding, gpu::sampledImage(clamp, in.reflection.color));
    bind(reflectionInfoBinding, gpu::sampledImage(nearest, in.reflection.info));
    bindImage(sceneColorBinding, in.view->sceneColor);
    bindImage(sceneDepthBinding, in.view->sceneDepth);
    if (in.bed) {
        bind(bedColorBinding, gpu::sampledImage(nearest, in.bed->colorRead()));
        bind(bedDepthBinding, gpu::sampledImage(nearest, in.bed->depthRead()));
    }
    if (light.shadow) bindImage(sunShadowMapBinding, light.shadow->map);
    return list;
}

} // namespace

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SurfaceVariant& variant,
                     DrawPipeline& out) {
    SurfaceVariant drawn = variant;
    drawn.inViews = target.viewMask != 0;
    drawn.targetIsEncoded = target.encoding == Encoding::srgb;
    const std::span<const uint32_t> fragment =
        drawn.forMotion ? motion_frag : std::span<const uint32_t>(surface_frag);
    return createDrawPipeline(device, target, {surface_vert, fragment, drawn.constants()}, Drawing::solid,
                              "surface pipeline", out);
}

Status recordSurface(Context& context, VkCommandBuffer commands, const DrawPipeline& pipeline,
                     const SurfaceInputs& inputs) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline.layout, resources(context, inputs), set);
        s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, "surface");
    const gpu::DeviceTable& vk = context.device.vk();
    bindDraw(context.device, commands, pipeline, set, inputs.view->viewIndex);
    vk.CmdBindIndexBuffer(commands, inputs.indices, 0, inputs.indexType);
    vk.CmdDrawIndexed(commands, inputs.indexCount, inputs.instanceCount, inputs.firstIndex, 0, 0);
    return Status::ok;
}

} // namespace seaglass
