// The pipelines that a body will ask a target for, made ahead of its first draw.
#include <cmath>
#include <cstdint>

#include "gpu/view/encoding.h"
#include "gpu/view/single_sample.h"
#include "water/body/body.h"
#include "water/body/target.h"

namespace seaglass {

namespace {

/// Of scene and target alike, unless a view says otherwise.
bool readsEncoded(const Target& target, const ViewDesc* view) {
    return view ? isEncoded(view->sceneColor) : target.desc.encoding == Encoding::srgb;
}

/// Rows in the place of a fraction are those of the view.
uint32_t preparedDownscale(const ReflectionDesc& desc, const ViewDesc* view) {
    if (!view || desc.height == 0) return desc.downscale;
    const VkExtent2D extent = {static_cast<uint32_t>(std::abs(view->viewport.width)),
                               static_cast<uint32_t>(std::abs(view->viewport.height))};
    return sizedFor(desc, extent).downscale;
}

} // namespace

Status Body::prepareSurface(Target& target, const ViewDesc* view, const LightingDesc& lighting,
                            SurfaceOutput output) const {
    SurfaceDraw drawn = {.output = output,
                         .seesScene = !view || hasScene(*view),
                         .sceneIsEncoded = readsEncoded(target, view),
                         .manySamples = view && isMultisampled(*view)};
    if (reflector) drawn.reflectionDownscale = preparedDownscale(reflection, view);
    const auto prepared = [&](SidesSeen sides) {
        drawn.sides = sides;
        const DrawPipeline* pipeline = nullptr;
        return target.pipelines.get(surfaceVariant(drawn, lighting), pipeline);
    };
    if (const Status s = prepared(SidesSeen::above); s != Status::ok) return s;
    if (!underwater || output == SurfaceOutput::motion) return Status::ok;
    if (const Status s = prepared(SidesSeen::below); s != Status::ok) return s;
    return prepared(SidesSeen::either);
}

Status Body::prepareOverView(Target& target, const ViewDesc* view) const {
    const auto prepared = [&](const UnderwaterVariant& variant) {
        const DrawPipeline* pipeline = nullptr;
        return target.underwater.get(variant, pipeline);
    };
    if (caustics && (holdsFloats(target.desc.colorFormat) || target.desc.encoding == Encoding::srgb))
        if (const Status s = prepared(
                {.pass = UnderwaterPass::caustics, .exclusionVolumes = volumesPacked(exclusionVolumes)});
            s != Status::ok)
            return s;
    if (!underwater) return Status::ok;
    UnderwaterVariant over = {.pass = UnderwaterPass::water};
    over.sceneIsEncoded = readsEncoded(target, view);
    if (const Status s = prepared(over); s != Status::ok) return s;
    over.straddles = true;
    over.hasWaves = waves.has_value();
    over.hasShore = shore.has_value();
    if (const Status s = prepared(over); s != Status::ok || underwater->meniscus <= 0) return s;
    over.pass = UnderwaterPass::waterline;
    over.sceneIsEncoded = false;
    return prepared(over);
}

Status Body::prepareKernels(Target& target, const ViewDesc* view, const LightingDesc& lighting) const {
    if (caustics && lighting.shadow)
        if (const Status s = target.prepared.keep<ShadowedCausticBlurKernel>(*context); s != Status::ok)
            return s;
    const bool reads = refraction || (reflector && readsScene(reflection));
    if (!view || !reads || !hasScene(*view) || !isMultisampled(*view)) return Status::ok;
    if (const Status s = target.prepared.keep<DepthSampleKernel>(*context); s != Status::ok) return s;
    return view->sceneColor.samples == VK_SAMPLE_COUNT_1_BIT
               ? target.prepared.keep<ResolvedColorKernel>(*context)
               : target.prepared.keep<ColorSampleKernel>(*context);
}

Status Body::prepare(Target& target, const ViewDesc* view, const LightingDesc* lighting,
                     SurfaceOutput output) const {
    LightingDesc usual;
    // Asked for nothing but whether it is there.
    usual.skyCube = reinterpret_cast<VkImageView>(uintptr_t{1});
    const LightingDesc& lights = lighting ? *lighting : usual;
    if (const Status s = prepareKernels(target, view, lights); s != Status::ok) return s;
    if (const Status s = prepareSurface(target, view, lights, output); s != Status::ok) return s;
    return output == SurfaceOutput::shaded ? prepareOverView(target, view) : Status::ok;
}

} // namespace seaglass
