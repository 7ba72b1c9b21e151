#include "water/reflection/reflection_part.h"

#include <algorithm>
#include <cmath>

#include "reflection/interface/fields/reflection.h"
#include "shaders/shared/water_bindings.h"
#include "water/below/refraction_part.h"
#include "water/body/body.h"

namespace seaglass {

namespace {

/// What is asked for of a reflection, but for what still water would not show: nothing bends it, and nothing
/// but `scatter` blurs it.
ReflectionDesc reflectionOf(const ReflectionDesc& desc, bool hasWaves) {
    ReflectionDesc seen = desc;
    if (hasWaves) return seen;
    seen.distortion = 0;
    if (seen.scatter == 0) seen.blurLevels = 0;
    return seen;
}

/// Pixels of a view to one of what is there of its reflection; 0: there is none. Of one that is yet to be
/// made rows in the place of a fraction are those of the view.
uint32_t downscaleOf(const ReflectionPart& part, const SurfaceDraw& draw) {
    if (!draw.isAhead) {
        const ReflectionImages images = reflectionImages(part.reflector.get(), draw.view->viewIndex);
        return images.color ? images.downscale : 0;
    }
    if (!draw.view) return downscaleFor(part.desc, nullptr);
    const VkExtent2D extent = {static_cast<uint32_t>(std::abs(draw.view->viewport.width)),
                               static_cast<uint32_t>(std::abs(draw.view->viewport.height))};
    return downscaleFor(part.desc, &extent);
}

} // namespace

FieldError ReflectionPart::validate(const BodyDesc& desc) {
    return badAsked(reflectionFields, desc.reflection);
}

bool ReflectionPart::wanted(const BodyDesc& desc, const Sea*) {
    return desc.reflection && desc.reflection->technique != ReflectionTechnique::sky;
}

Status ReflectionPart::addCost(const AskedBody& asked, Estimate& sum) {
    const ReflectionDesc reflection = reflectionOf(*asked.desc.reflection, asked.sea);
    Estimate own;
    if (const Status s = estimate(&asked.context, &reflection, asked.extent, &own, asked.samples);
        s != Status::ok)
        return s;
    sum.bytes += own.bytes;
    sum.bytesPerView += own.bytesPerView;
    sum.dispatchesPerView += own.dispatchesPerView;
    sum.bytesPerSharedView = std::max(sum.bytesPerSharedView, own.bytesPerSharedView);
    sum.dispatchesPerSharedView = std::max(sum.dispatchesPerSharedView, own.dispatchesPerSharedView);
    return Status::ok;
}

Status ReflectionPart::create(Body& body, const BodyDesc& of) {
    const Placing& placing = body.placing;
    ReflectorDesc made;
    std::ranges::copy(of.plane, made.plane);
    made.reflection = reflectionOf(*of.reflection, body.sea != nullptr);
    if (placing.outline) {
        const Outline& outline = *placing.outline;
        const double low[] = {outline.low.x, placing.level - placing.displacement, outline.low.y};
        const double high[] = {outline.high.x, placing.level + placing.displacement, outline.high.y};
        std::ranges::copy(low, made.boundsLow);
        std::ranges::copy(high, made.boundsHigh);
    }
    desc = made.reflection;
    distortion = of.reflection->distortion;
    return createReflector(*body.context, made, body.frame.worldFromBody, reflector);
}

void ReflectionPart::aim(const Body& body, const ViewDesc& view) {
    ViewGeometry geometry;
    if (!body.readTurned(view, false, geometry))
        raiseMirror(*reflector, mirroredLevel(body, geometry, eyeOverWaves).raised);
}

Status ReflectionPart::reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene) {
    const uint32_t view = scene.given.viewIndex;
    const uint64_t now = body.context->frameNumber;
    if (view < maxViews && mirroredIn[view] == now && reflectedIn[view] != now)
        return body.context->device.misused("reflect: the body was drawn in this view and frame before");
    aim(body, scene.given);
    if (const Status s = seaglass::reflect(commands, *reflector, scene); s != Status::ok) return s;
    reflectedIn[view] = now;
    return Status::ok;
}

void ReflectionPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const bool bent = view.surface && !view.surface->isMotion() &&
                      reflectionImages(reflector.get(), view.given->viewIndex).bent;
    const MirroredLevel mirrored = mirroredLevel(body, view.geometry, eyeOverWaves);
    block.mirror.x = static_cast<float>(body.heightOf(view.geometry.eye) - mirrored.raised);
    block.mirror.y = mirrored.share;
    block.reflectionDistortion = bent ? 0 : distortion;
    const VkExtent2D extent = extentOf(view.geometry);
    block.reflectionScale = static_cast<float>(downscaleFor(desc, &extent));
    block.reflectionBlur = {desc.clearDistance, desc.scatter, desc.skyFadeDistance, 0};
}

void ReflectionPart::vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const {
    const uint32_t downscale = draw.isMotion() ? 0 : downscaleOf(*this, draw);
    variant.hasReflection = downscale > 0;
    if (!body.sea && desc.blurLevels == 0) variant.sharpDownscale = static_cast<int>(downscale);
}

Status ReflectionPart::bind(Body& body, const BodyView& view, Resources& out) {
    if (!view.surface || view.surface->isMotion()) return Status::ok;
    const gpu::Samplers& samplers = body.context->samplers;
    const uint32_t index = view.given->viewIndex;
    const ReflectionImages images = reflectionImages(reflector.get(), index);
    mirroredIn[index] = body.context->frameNumber;
    out.push_back({reflectionColorBinding, gpu::sampledImage(samplers.trilinearClamp(), images.color)});
    out.push_back({reflectionInfoBinding, gpu::sampledImage(samplers.nearestClamp(), images.info)});
    return Status::ok;
}

Status ReflectionPart::prepare(const Body& body, const PrepareCall& call) const {
    const bool prepared = !readsScene(desc) || body.find<RefractionPart>();
    return prepared ? Status::ok : prepareSamples(body, call);
}

Part reflectionPart() {
    return partFrom<ReflectionPart>();
}

} // namespace seaglass
