#include "water/below/caustics_part.h"

#include <cstring>

#include "shaders/shared/water_bindings.h"
#include "water/below/view_pass.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"
#include "water/interface/fields/water.h"

namespace seaglass {

namespace {

ViewPassVariant variantOf(const Body& body) {
    ViewPassVariant variant = {ViewPass::caustics};
    variant.exclusionVolumes = volumesPacked(body.exclusionVolumes);
    return variant;
}

/// Light that is gathered exceeds 1.
bool holdsLight(const TargetDesc& target) {
    return holdsFloats(target.colorFormat) || target.encoding == Encoding::srgb;
}

} // namespace

FieldError CausticsPart::validate(const BodyDesc& desc) {
    if (desc.caustics && (!desc.waves || !desc.refraction))
        return "BodyDesc.caustics needs BodyDesc.waves and BodyDesc.refraction";
    return badAsked(causticsFields, desc.caustics);
}

Status CausticsPart::addCost(const AskedBody& asked, Estimate& sum) {
    sum.bytesPerView += Caustics::bytes(asked.context.device, asked.desc, asked.extent);
    return Status::ok;
}

Status CausticsPart::create(Body& body, const BodyDesc& desc) {
    return caustics.create(*body.context, *body.sea, *desc.caustics);
}

Status CausticsPart::cast(Body& body, VkCommandBuffer commands, const ViewDesc& view,
                          const LightingDesc& lighting) {
    Context& context = *body.context;
    if (isMultisampled(view))
        return context.device.fail(
            Status::unsupported,
            "castCaustics: ViewDesc.sceneDepth.samples is not 1: nothing has taken one sample of each yet");
    BodyView read;
    if (const Status s = body.read("castCaustics", view, lighting, "BodyDesc.caustics", read);
        s != Status::ok)
        return s;
    if (body.toSun(lighting).y <= 0) return Status::ok;
    CausticInputs inputs;
    inputs.viewIndex = view.viewIndex;
    inputs.inShadow = lighting.shadow;
    inputs.region = read.geometry.regionSize;
    inputs.grid = causticGrid(body.shading, read.geometry, body.heightOf(read.geometry.eye));
    if (const Status s = bindBody(body, read, inputs.resources); s != Status::ok) return s;
    return caustics.record(context, commands, inputs);
}

Status CausticsPart::drawLight(Body& body, const DrawCall& call) const {
    const gpu::Device& device = body.context->device;
    if (!holdsLight(call.target.desc))
        return device.fail(
            Status::invalidArgument,
            "drawCaustics: TargetDesc.colorFormat holds no floats, and light that is gathered exceeds 1");
    BodyView view;
    if (const Status s = body.read("drawCaustics", call.view, call.lighting, "BodyDesc.caustics", view);
        s != Status::ok)
        return s;
    if (body.toSun(call.lighting).y <= 0) return Status::ok;
    const VkBuffer light = caustics.lightOf(*body.context, call.view.viewIndex, view.geometry.regionSize);
    if (!light)
        return device.misused(
            "drawCaustics: castCaustics() was not called for this view before, or for another since");
    Resources resources;
    if (const Status s = bindBody(body, view, resources); s != Status::ok) return s;
    resources.push_back({causticSumsBinding, gpu::storageBuffer(light)});
    return recordViewPass(*body.context, call, view, variantOf(body), resources);
}

void CausticsPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const CausticGrid grid = causticGrid(body.shading, view.geometry, body.heightOf(view.geometry.eye));
    const SunInWater sun = fillSunInWater(block);
    block.sunTurned = glm::vec4(sun.turnedAlong, sun.turnedAcross, 0, 0);
    block.causticStrength = caustics.strength();
    block.causticGrid = {grid.step, grid.margin, grid.rowLength, grid.firstRow};
    static_assert(sizeof block.lostSlopes == sizeof(LostSlopes));
    std::memcpy(block.lostSlopes, caustics.lostSlopes().data(), sizeof block.lostSlopes);
}

Status CausticsPart::prepare(const Body& body, const PrepareCall& call) const {
    Target& target = call.target;
    if (call.lighting.shadow) {
        std::shared_ptr<ShadowedCausticBlurKernel> kept;
        if (const Status s = body.context->share(kept); s != Status::ok) return s;
    }
    if (call.output != SurfaceOutput::shaded || !holdsLight(target.desc)) return Status::ok;
    return prepareViewPass(target.viewPasses, variantOf(body));
}

Part causticsPart() {
    return partFrom<CausticsPart>();
}

} // namespace seaglass
