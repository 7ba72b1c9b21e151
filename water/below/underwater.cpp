#include "water/below/underwater.h"

#include <vector>

#include "shaders/shared/water_bindings.h"
#include "spirv/caustics.frag.h"
#include "spirv/caustics.vert.h"
#include "spirv/underwater.frag.h"
#include "spirv/underwater.vert.h"
#include "spirv/waterline.frag.h"
#include "water/body/body_block.h"

namespace seaglass {

namespace {

struct PassInfo {
    const char* name;
    std::span<const uint32_t> vertex, fragment;
    Drawing drawing;
};

PassInfo infoOf(UnderwaterPass pass) {
    switch (pass) {
    case UnderwaterPass::water:
        return {"underwater", underwater_vert, underwater_frag, Drawing::over};
    case UnderwaterPass::waterline:
        return {"waterline", underwater_vert, waterline_frag, Drawing::blended};
    case UnderwaterPass::caustics:
        break;
    }
    return {"caustics", caustics_vert, caustics_frag, Drawing::scaled};
}

/// All that some pipeline's shaders read.
std::vector<gpu::Bound> resources(const Context& context, const UnderwaterInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    std::vector<gpu::Bound> list;
    const auto bind = [&](uint32_t number, const gpu::Resource& resource) {
        list.push_back({number, resource});
    };
    const auto bindImage = [&](uint32_t number, const Image& image) {
        bind(number, gpu::sampledImage(samplers.nearestClamp(), image.view, image.layout));
    };
    bind(bodyBinding, gpu::uniformBuffer(in.uniforms));
    bindImage(sceneColorBinding, in.view->sceneColor);
    bindImage(sceneDepthBinding, in.view->sceneDepth);
    bind(waveDisplacementBinding, gpu::sampledImage(samplers.trilinearRepeat(), in.waveMap));
    bind(shoreMapBinding, gpu::sampledImage(samplers.trilinearClamp(), in.shoreMap));
    bind(shoreSignalBinding, in.shoreRows);
    bind(causticLightBinding, gpu::sampledImage(samplers.trilinearClamp(), in.light));
    return list;
}

} // namespace

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const UnderwaterVariant& variant,
                     DrawPipeline& out) {
    UnderwaterVariant drawn = variant;
    drawn.inViews = target.viewMask != 0;
    drawn.targetIsEncoded = target.encoding == Encoding::srgb;
    const PassInfo info = infoOf(variant.pass);
    return createDrawPipeline(device, target, {info.vertex, info.fragment, drawn.constants()}, info.drawing,
                              "underwater pipeline", out);
}

Status recordUnderwater(Context& context, VkCommandBuffer commands, UnderwaterPipelines& pipelines,
                        const UnderwaterVariant& variant, const UnderwaterInputs& inputs) {
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = pipelines.get(variant, pipeline); s != Status::ok) return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline->layout, resources(context, inputs), set);
        s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, infoOf(variant.pass).name);
    bindDraw(context.device, commands, *pipeline, set, inputs.view->viewIndex);
    context.device.vk().CmdDraw(commands, 3, 1, 0, 0);
    return Status::ok;
}

} // namespace seaglass
