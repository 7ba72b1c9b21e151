// The pipelines that a body will ask a target for, made ahead of its first draw.
#include <cmath>
#include <cstdint>

#include "reflection/encoding.h"
#include "reflection/single_sample.h"
#include "water/body.h"
#include "water/target.h"

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
    const auto prepared = [&](SidesSeen sides) {
        SurfaceFeatures wanted;
        if (output == SurfaceOutput::motion) {
            wanted = motionFeatures();
        } else {
            ReflectionImages images;
            // Asked for nothing but whether it is there.
            if (reflector) images.color = reinterpret_cast<VkImageView>(uintptr_t{1});
            if (reflector) images.downscale = preparedDownscale(reflector->desc, view);
            wanted = features(images, lighting, !view || hasScene(*view));
            wanted.sceneEncoded = wanted.refraction && readsEncoded(target, view);
            wanted.manySamples = wanted.refraction && view && isMultisampled(*view);
        }
        if (sides == SidesSeen::below) wanted.bedDownscale = 0;
        const DrawPipeline* pipeline = nullptr;
        return target.pipelines.get({wanted, output, sides}, pipeline);
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
        if (const Status s = prepared({.pass = UnderwaterPass::caustics, .dryRooms = roomsPacked(dryRooms)});
            s != Status::ok)
            return s;
    if (!underwater) return Status::ok;
    UnderwaterVariant over = {.pass = UnderwaterPass::water};
    over.sceneEncoded = readsEncoded(target, view);
    if (const Status s = prepared(over); s != Status::ok) return s;
    over.straddles = true;
    over.waves = waves.has_value();
    over.shore = shore.has_value();
    if (const Status s = prepared(over); s != Status::ok || underwater->meniscus <= 0) return s;
    over.pass = UnderwaterPass::waterline;
    over.sceneEncoded = false;
    return prepared(over);
}

Status Body::prepareKernels(Target& target, const ViewDesc* view, const LightingDesc& lighting) const {
    if (caustics && lighting.shadow)
        if (const Status s = target.prepared.keep<ShadowedCausticBlurKernel>(*context); s != Status::ok)
            return s;
    const bool readsScene =
        refraction || (reflector && reflector->desc.technique != ReflectionTechnique::planar);
    if (!view || !readsScene || !hasScene(*view) || !isMultisampled(*view)) return Status::ok;
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
