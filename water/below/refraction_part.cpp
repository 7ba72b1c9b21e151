#include "water/below/refraction_part.h"

#include <algorithm>

#include "gpu/view/encoding.h"
#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/body/target.h"
#include "water/interface/fields/water.h"

namespace seaglass {

FieldError RefractionPart::validate(const BodyDesc& desc) {
    return badAsked(refractionFields, desc.refraction);
}

Status RefractionPart::addCost(const AskedBody& asked, Estimate& sum) {
    const VkSampleCountFlagBits samples = asked.samples.depth;
    sum.bytesPerSharedView =
        std::max(sum.bytesPerSharedView,
                 uint64_t{SingleSampledScene::bytes(asked.context.device, asked.extent, samples)});
    sum.dispatchesPerSharedView =
        std::max(sum.dispatchesPerSharedView, SingleSampledScene::dispatches(samples));
    return Status::ok;
}

Status RefractionPart::create(Body&, const BodyDesc& of) {
    desc = *of.refraction;
    return Status::ok;
}

Status RefractionPart::reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene) {
    Context& context = *body.context;
    if (!isMultisampled(scene.given)) {
        dropSamples(context, singleSamples.get(), scene.given.viewIndex);
        return Status::ok;
    }
    if (scene.taken) return context.shareWhileUsed(singleSamples);
    ViewGeometry geometry;
    if (const FieldError bad = body.readTurned(scene.given, true, geometry))
        return context.device.fail(Status::invalidArgument, "reflect: %s", bad.text());
    if (!body.maySee(geometry)) return Status::ok;
    return takeSamples(context, commands, geometry, singleSamples, scene);
}

Status RefractionPart::standIn(Context& context, const ViewDesc& view, ViewDesc& read) const {
    if (!singleSamples || !singleSamples->views[view.viewIndex].fits(view))
        return context.device.misused(
            "draw: ViewDesc.sceneDepth.samples is not 1, and reflect() was not called for this view before");
    singleSamples->views[view.viewIndex].standIn(read);
    return Status::ok;
}

void RefractionPart::fill(const Body&, const BodyView&, BodyBlock& block) const {
    block.absorption = {desc.absorption[0], desc.absorption[1], desc.absorption[2], desc.scattering};
    block.backscatter = {desc.backscatter[0], desc.backscatter[1], desc.backscatter[2], 0};
    block.refractionDistortion = desc.distortion;
}

void RefractionPart::vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const {
    // Without a scene the water is endlessly deep: its colour is in the uniforms.
    variant.hasRefraction = draw.seesScene;
    variant.sceneIsEncoded = draw.seesScene && draw.sceneIsEncoded;
    variant.manySamples = draw.seesScene && draw.manySamples;
    variant.hasSubsurfaceScattering = body.sea && desc.scattering > 0;
    if (variant.hasRefraction || variant.hasSubsurfaceScattering)
        variant.refractionSamples = static_cast<int>(body.shading.refractionSamples);
}

Status RefractionPart::bind(Body& body, const BodyView& view, Resources& out) {
    out.push_back({sceneColorBinding, sampledTexels(*body.context, view.read.sceneColor)});
    out.push_back({sceneDepthBinding, sampledTexels(*body.context, view.read.sceneDepth)});
    return Status::ok;
}

Status prepareSamples(const Body& body, const PrepareCall& call) {
    if (!call.view || !hasScene(*call.view) || !isMultisampled(*call.view)) return Status::ok;
    SingleSamples samples;
    return shareKernels(*body.context, *call.view, samples);
}

Status RefractionPart::prepare(const Body& body, const PrepareCall& call) const {
    return prepareSamples(body, call);
}

Part refractionPart() {
    return partFrom<RefractionPart>();
}

} // namespace seaglass
