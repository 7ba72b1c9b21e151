#include "water/underwater.h"

#include <vector>

#include "spirv/caustics.frag.h"
#include "spirv/caustics.vert.h"
#include "spirv/caustics_views.vert.h"
#include "spirv/underwater.frag.h"
#include "spirv/underwater.vert.h"
#include "spirv/underwater_views.vert.h"
#include "spirv/underwater_waves.frag.h"
#include "spirv/underwater_waves_shore.frag.h"
#include "spirv/waterline.frag.h"
#include "spirv/waterline_waves.frag.h"
#include "spirv/waterline_waves_shore.frag.h"
#include "water/surface_uniforms.h"

namespace seaglass {

namespace {

struct PassInfo {
    const char* name;
    std::span<const uint32_t> shader;
    bool readsColor, readsDepth;
    Drawing drawing;
};

PassInfo infoOf(const UnderwaterVariant& v) {
    using Shader = std::span<const uint32_t>;
    const size_t form = formFor(v.waves, v.shore);
    switch (v.pass) {
    case UnderwaterPass::water: {
        const Shader shaders[] = {underwater_frag, underwater_waves_frag, underwater_waves_shore_frag};
        return {"underwater", shaders[form], true, true, Drawing::over};
    }
    case UnderwaterPass::waterline: {
        const Shader shaders[] = {waterline_frag, waterline_waves_frag, waterline_waves_shore_frag};
        return {"waterline", shaders[form], false, false, Drawing::blended};
    }
    case UnderwaterPass::caustics:
        break;
    }
    return {"caustics", caustics_frag, false, true, Drawing::scaled};
}

/// In the order of the shaders' bindings.
std::vector<gpu::Bound> resources(const Context& context, const UnderwaterVariant& v,
                                  const UnderwaterInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    const PassInfo info = infoOf(v);
    std::vector<gpu::Bound> list;
    const auto add = [&](const gpu::Resource& resource) {
        list.push_back({static_cast<uint32_t>(list.size()), resource});
    };
    const auto addOf = [&](const Image& image) {
        add(gpu::sampledImage(samplers.nearestClamp(), image.view, image.layout));
    };
    add(gpu::uniformBuffer(in.uniforms.buffer, in.uniforms.offset, sizeof(SurfaceUniforms)));
    if (info.readsColor) addOf(in.view->sceneColor);
    if (info.readsDepth) addOf(in.view->sceneDepth);
    if (v.waves) add(gpu::sampledImage(samplers.trilinearRepeat(), in.waveMap));
    if (v.shore) {
        add(gpu::sampledImage(samplers.trilinearClamp(), in.shoreMap));
        add(in.shoreRows);
    }
    if (v.pass == UnderwaterPass::caustics) add(gpu::sampledImage(samplers.trilinearClamp(), in.light));
    return list;
}

} // namespace

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const UnderwaterVariant& variant,
                     DrawPipeline& out) {
    const bool caustics = variant.pass == UnderwaterPass::caustics;
    const bool views = target.viewMask != 0;
    const PassInfo info = infoOf(variant);
    const uint32_t constants[] = {variant.straddles, variant.dryRooms, variant.sceneEncoded,
                                  target.encoding == Encoding::srgb};
    const std::span<const uint32_t> vertex[][2] = {{underwater_vert, underwater_views_vert},
                                                   {caustics_vert, caustics_views_vert}};
    return createDrawPipeline(device, target, {vertex[caustics][views], info.shader, constants}, info.drawing,
                              "underwater pipeline", out);
}

Status recordUnderwater(Context& context, VkCommandBuffer commands, UnderwaterPipelines& pipelines,
                        const UnderwaterVariant& variant, const UnderwaterInputs& inputs) {
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = pipelines.get(variant, pipeline); s != Status::ok) return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s =
            context.frame().allocateSet(pipeline->layout, resources(context, variant, inputs), set);
        s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, infoOf(variant).name);
    bindDraw(context.device, commands, *pipeline, set, inputs.view->viewIndex);
    context.device.vk().CmdDraw(commands, 3, 1, 0, 0);
    return Status::ok;
}

} // namespace seaglass
