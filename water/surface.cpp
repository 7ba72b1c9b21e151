#include "water/surface.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "spirv/motion.frag.h"
#include "spirv/motion.vert.h"
#include "spirv/motion_host_mesh.vert.h"
#include "spirv/motion_host_mesh_views.vert.h"
#include "spirv/motion_outline.frag.h"
#include "spirv/motion_outline.vert.h"
#include "spirv/motion_outline_views.vert.h"
#include "spirv/motion_views.vert.h"
#include "spirv/motion_waves.vert.h"
#include "spirv/motion_waves_host_mesh.vert.h"
#include "spirv/motion_waves_host_mesh_views.vert.h"
#include "spirv/motion_waves_outline.frag.h"
#include "spirv/motion_waves_outline.vert.h"
#include "spirv/motion_waves_outline_views.vert.h"
#include "spirv/motion_waves_shore.vert.h"
#include "spirv/motion_waves_shore_host_mesh.vert.h"
#include "spirv/motion_waves_shore_host_mesh_views.vert.h"
#include "spirv/motion_waves_shore_outline.frag.h"
#include "spirv/motion_waves_shore_outline.vert.h"
#include "spirv/motion_waves_shore_outline_views.vert.h"
#include "spirv/motion_waves_shore_views.vert.h"
#include "spirv/motion_waves_views.vert.h"
#include "spirv/surface.vert.h"
#include "spirv/surface_host_mesh.vert.h"
#include "spirv/surface_host_mesh_views.vert.h"
#include "spirv/surface_outline.vert.h"
#include "spirv/surface_outline_views.vert.h"
#include "spirv/surface_views.vert.h"
#include "spirv/surface_waves.vert.h"
#include "spirv/surface_waves_host_mesh.vert.h"
#include "spirv/surface_waves_host_mesh_views.vert.h"
#include "spirv/surface_waves_outline.vert.h"
#include "spirv/surface_waves_outline_views.vert.h"
#include "spirv/surface_waves_shore.vert.h"
#include "spirv/surface_waves_shore_host_mesh.vert.h"
#include "spirv/surface_waves_shore_host_mesh_views.vert.h"
#include "spirv/surface_waves_shore_outline.vert.h"
#include "spirv/surface_waves_shore_outline_views.vert.h"
#include "spirv/surface_waves_shore_views.vert.h"
#include "spirv/surface_waves_views.vert.h"
#include "surface_fragments.h"
#include "water/surface_uniforms.h"

namespace seaglass {

namespace {

std::span<const uint32_t> motionVertexShader(const SurfaceFeatures& f, bool multiview) {
    using Shader = std::span<const uint32_t>;
    // By shape, then waves, then a shore.
    const Shader one[][3] = {
        {motion_vert, motion_waves_vert, motion_waves_shore_vert},
        {motion_outline_vert, motion_waves_outline_vert, motion_waves_shore_outline_vert},
        {motion_host_mesh_vert, motion_waves_host_mesh_vert, motion_waves_shore_host_mesh_vert}};
    const Shader several[][3] = {
        {motion_views_vert, motion_waves_views_vert, motion_waves_shore_views_vert},
        {motion_outline_views_vert, motion_waves_outline_views_vert, motion_waves_shore_outline_views_vert},
        {motion_host_mesh_views_vert, motion_waves_host_mesh_views_vert,
         motion_waves_shore_host_mesh_views_vert}};
    const auto shape = static_cast<size_t>(f.shape);
    const size_t form = formFor(f.waves, f.shore);
    return multiview ? several[shape][form] : one[shape][form];
}

std::span<const uint32_t> motionFragmentShader(const SurfaceFeatures& f) {
    if (f.shape != SurfaceShape::outlined) return motion_frag;
    if (f.shore) return motion_waves_shore_outline_frag;
    if (f.waves) return motion_waves_outline_frag;
    return motion_outline_frag;
}

std::span<const uint32_t> vertexShader(const SurfaceFeatures& f, bool multiview) {
    if (f.motion) return motionVertexShader(f, multiview);
    using Shader = std::span<const uint32_t>;
    // By shape, then waves, then a shore.
    const Shader one[][3] = {
        {surface_vert, surface_waves_vert, surface_waves_shore_vert},
        {surface_outline_vert, surface_waves_outline_vert, surface_waves_shore_outline_vert},
        {surface_host_mesh_vert, surface_waves_host_mesh_vert, surface_waves_shore_host_mesh_vert}};
    const Shader several[][3] = {
        {surface_views_vert, surface_waves_views_vert, surface_waves_shore_views_vert},
        {surface_outline_views_vert, surface_waves_outline_views_vert,
         surface_waves_shore_outline_views_vert},
        {surface_host_mesh_views_vert, surface_waves_host_mesh_views_vert,
         surface_waves_shore_host_mesh_views_vert}};
    const auto shape = static_cast<size_t>(f.shape);
    const size_t form = formFor(f.waves, f.shore);
    return multiview ? several[shape][form] : one[shape][form];
}

/// As the shaders' names have it: w waves, f foam, s a shore, l reflection, r refraction, o an outline, h a
/// shadow.
std::string lettersOf(const SurfaceFeatures& f) {
    std::string letters;
    if (f.waves) letters += 'w';
    if (f.foam) letters += 'f';
    if (f.shore) letters += 's';
    if (f.reflection) letters += 'l';
    if (f.refraction) letters += 'r';
    if (f.shape == SurfaceShape::outlined) letters += 'o';
    if (f.sunShadow) letters += 'h';
    return letters;
}

std::span<const uint32_t> fragmentShader(const SurfaceFeatures& f) {
    if (f.motion) return motionFragmentShader(f);
    return std::ranges::find(surfaceFragments, lettersOf(f), &SurfaceFragment::letters)->shader;
}

/// In the order of shaders/common/surface.glsl, which numbers bindings likewise.
template<typename Item, typename Waves, typename Shore, typename Extent, typename Motion, typename Foam,
         typename Reflection, typename Refraction, typename Shadow>
std::vector<Item> byFeature(const SurfaceFeatures& f, std::initializer_list<Item> always, Waves&& waves,
                            Shore&& shore, Extent&& extent, Motion&& motion, Foam&& foam,
                            Reflection&& reflection, Refraction&& refraction, Shadow&& shadow) {
    std::vector<Item> list(always);
    if (f.waves)
        for (const Item& item : waves()) list.push_back(item);
    if (f.shore)
        for (const Item& item : shore()) list.push_back(item);
    if (f.shape == SurfaceShape::outlined) list.push_back(extent());
    if (f.motion && f.waves) list.push_back(motion());
    if (f.foam)
        for (const Item& item : foam()) list.push_back(item);
    if (f.reflection)
        for (const Item& item : reflection()) list.push_back(item);
    if (f.refraction)
        for (const Item& item : refraction()) list.push_back(item);
    if (f.sunShadow) list.push_back(shadow());
    return list;
}

std::vector<gpu::Resource> resources(const Context& context, const SurfaceFeatures& f,
                                     const SurfaceInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    const LightingDesc& light = *in.lighting;
    const gpu::Resource uniforms =
        gpu::uniformBuffer(in.uniforms.buffer, in.uniforms.offset, sizeof(SurfaceUniforms));
    // In the cube's place there is what is not bound.
    const gpu::Resource sky =
        f.skyColors ? uniforms
                    : gpu::sampledImage(samplers.trilinearClamp(), light.skyCube, light.skyCubeLayout);
    return byFeature<gpu::Resource>(
        f, {uniforms, in.patches, sky},
        [&] {
            const VkSampler s = samplers.trilinearRepeat();
            return std::array{gpu::sampledImage(s, in.waveMaps[0]), gpu::sampledImage(s, in.waveMaps[1]),
                              gpu::sampledImage(s, in.waveMaps[2])};
        },
        [&] {
            return std::array{gpu::sampledImage(samplers.trilinearClamp(), in.shoreMap), in.shoreRows};
        },
        [&] { return in.extent; },
        [&] { return gpu::sampledImage(samplers.trilinearRepeat(), in.lastDisplacement); },
        [&] {
            const VkSampler s = samplers.trilinearRepeat();
            return std::array{gpu::sampledImage(s, in.foamPattern), gpu::sampledImage(s, in.foamHistory)};
        },
        [&] {
            return std::array{gpu::sampledImage(samplers.trilinearClamp(), in.reflection.color),
                              gpu::sampledImage(samplers.nearestClamp(), in.reflection.info)};
        },
        [&] {
            const VkSampler s = samplers.nearestClamp();
            const gpu::Resource color =
                gpu::sampledImage(s, in.view->sceneColor.view, in.view->sceneColor.layout);
            const gpu::Resource depth =
                gpu::sampledImage(s, in.view->sceneDepth.view, in.view->sceneDepth.layout);
            // Without a bed its shader does not look at it.
            if (f.bedDownscale == 0) return std::array{color, depth, color, depth};
            return std::array{color, depth, gpu::sampledImage(s, in.bed->colorRead()),
                              gpu::sampledImage(s, in.bed->depthRead())};
        },
        [&] {
            return gpu::sampledImage(samplers.nearestClamp(), light.shadow->map.view,
                                     light.shadow->map.layout);
        });
}

} // namespace

/// Of shaders/common/surface.glsl.
constexpr uint32_t skyCubeBinding = 2;

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const SurfaceVariant& variant,
                     DrawPipeline& out) {
    const uint32_t constants[] = {static_cast<uint32_t>(variant.output),
                                  static_cast<uint32_t>(variant.sides),
                                  variant.features.cascades,
                                  variant.features.foamCascades,
                                  variant.features.crestLight,
                                  variant.features.dryRooms,
                                  variant.features.waveShadowSteps,
                                  variant.features.mirrorLooks,
                                  variant.features.refractionLooks,
                                  variant.features.slopeLooks,
                                  variant.features.tilted,
                                  variant.features.relief,
                                  variant.features.bedDownscale,
                                  variant.features.schlick,
                                  variant.features.globe,
                                  variant.features.sharpDownscale,
                                  variant.features.skyColors,
                                  variant.features.sceneEncoded,
                                  target.encoding == Encoding::srgb,
                                  variant.features.manySamples,
                                  variant.features.fog};
    return createDrawPipeline(device, target,
                              {vertexShader(variant.features, target.viewMask != 0),
                               fragmentShader(variant.features), constants,
                               variant.features.skyColors ? skyCubeBinding : gpu::allBindings},
                              Drawing::solid, "surface pipeline", out);
}

Status recordSurface(Context& context, VkCommandBuffer commands, const DrawPipeline& pipeline,
                     SurfaceFeatures features, const SurfaceInputs& inputs) {
    std::vector<gpu::Bound> list;
    for (const gpu::Resource& resource : resources(context, features, inputs))
        list.push_back({static_cast<uint32_t>(list.size()), resource});
    std::erase_if(list, [&](const gpu::Bound& bound) { return !pipeline.layout.has(bound.number); });
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(pipeline.layout, list, set); s != Status::ok) return s;
    const gpu::PassScope pass(context.device, commands, "surface");
    const gpu::DeviceTable& vk = context.device.vk();
    bindDraw(context.device, commands, pipeline, set, inputs.view->viewIndex);
    vk.CmdBindIndexBuffer(commands, inputs.indices, 0, inputs.indexType);
    vk.CmdDrawIndexed(commands, inputs.indexCount, inputs.instanceCount, inputs.firstIndex, 0, 0);
    return Status::ok;
}

} // namespace seaglass
