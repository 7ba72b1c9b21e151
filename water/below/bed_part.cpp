#include "water/below/bed_part.h"

#include <glm/matrix.hpp>

#include "reflection/interface/drawn_images.h"
#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/interface/fields/water.h"

namespace seaglass {

namespace {

bool looksAt(const SurfaceDraw& draw) {
    return draw.seesScene && draw.sides != SidesSeen::below && !draw.isMotion();
}

} // namespace

FieldError BedPart::validate(const BodyDesc& desc) {
    if (desc.bed && !desc.refraction) return "BodyDesc.bed needs BodyDesc.refraction";
    return badAsked(bedFields, desc.bed);
}

Status BedPart::addCost(const AskedBody& asked, Estimate& sum) {
    const gpu::Device& device = asked.context.device;
    const BedDesc& desc = *asked.desc.bed;
    if (const Status s = checkDrawn(device, desc.drawn, "BedDesc"); s != Status::ok) return s;
    sum.dispatchesPerView += Bed::dispatches(desc);
    sum.bytesPerView += Bed::bytes(device, desc, asked.desc.shading.bedDownscale, asked.extent);
    return Status::ok;
}

VkExtent2D BedPart::pictureExtent(const BodyDesc& desc, VkExtent2D view) {
    return Bed::pictureExtent(*desc.bed, desc.shading.bedDownscale, view);
}

Status BedPart::create(Body& body, const BodyDesc& desc) {
    bed.desc = *desc.bed;
    bed.downscale = desc.shading.bedDownscale;
    bed.distortion = double{desc.refraction->distortion};
    return Bed::create(*body.context, bed);
}

Status BedPart::handOut(Body& body, const ViewDesc& view, PlanarView& out) {
    ViewGeometry geometry;
    if (const FieldError bad = body.readTurned(view, false, geometry))
        return body.context->device.fail(Status::invalidArgument, "bedView: %s", bad.text());
    out = {};
    out.visible = body.sidesSeen(geometry) != SidesSeen::below && body.maySee(geometry);
    if (!out.visible) return Status::ok;
    // On a shore what shines through a film of water lies as high as the waves run up.
    const double raised = body.sea && body.sea->shore ? body.placing.displacement : 0;
    const glm::dvec4 highest(body.frame.worldFromBody[1], body.plane.w - raised);
    return bed.handOut(*body.context, view, geometry, highest, body.frame, out);
}

Status BedPart::reflect(Body& body, VkCommandBuffer commands, SceneOfCall& scene) {
    return bed.take(*body.context, commands, scene.given.viewIndex);
}

const BedPicture* BedPart::seen(const Body& body, const BodyView& view) const {
    if (!view.surface || !looksAt(*view.surface)) return nullptr;
    return bed.of(*body.context, view.given->viewIndex);
}

void BedPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    block.bedFromRelative = block.relativeFromBed = mat4(1);
    const BedPicture* picture = seen(body, view);
    if (!picture) return;
    glm::dmat4 moved(1);
    moved[3] = glm::dvec4(view.geometry.eye - picture->camera.eye, 1);
    const glm::dmat4 pixelFromRelative = scenePixelFromRelative(picture->camera) * moved;
    block.bedFromRelative = glm::mat4(pixelFromRelative);
    block.relativeFromBed = glm::mat4(glm::inverse(pixelFromRelative));
    block.bedSize = {picture->camera.regionSize, 0, 0};
}

void BedPart::vary(const Body&, const SurfaceDraw& draw, SurfaceVariant& variant) const {
    variant.bedDownscale = looksAt(draw) ? static_cast<int>(bed.downscale) : 0;
}

Status BedPart::bind(Body& body, const BodyView& view, Resources& out) {
    if (!view.surface || !looksAt(*view.surface)) return Status::ok;
    const BedPicture* picture = seen(body, view);
    if (!picture)
        return body.context->device.misused(
            "draw: BodyDesc.bed is set, and bedView() and reflect() were not called for this view before");
    const VkSampler nearest = body.context->samplers.nearestClamp();
    out.push_back({bedColorBinding, gpu::sampledImage(nearest, picture->colorRead())});
    out.push_back({bedDepthBinding, gpu::sampledImage(nearest, picture->depthRead())});
    return Status::ok;
}

Part bedPart() {
    Part part = partFrom<BedPart>();
    part.needsScene = "BodyDesc.bed";
    return part;
}

} // namespace seaglass
