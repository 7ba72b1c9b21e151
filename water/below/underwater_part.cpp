#include "water/below/underwater_part.h"

#include <cmath>

#include "gpu/view/encoding.h"
#include "water/below/caustics.h"
#include "water/below/view_pass.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"
#include "water/interface/fields/water.h"
#include "water/interface/wrapped_cell.h"

namespace seaglass {

namespace {

/// In the order in which they are drawn.
constexpr ViewPass passes[] = {ViewPass::water, ViewPass::shafts, ViewPass::snow, ViewPass::waterline};

ViewPassVariant passVariant(const Body& body, ViewPass pass, bool straddles) {
    if (pass == ViewPass::snow) return {.pass = pass};
    return {.pass = pass,
            .hasWaves = straddles && body.sea,
            .hasShore = straddles && body.sea && body.sea->shore,
            .straddles = straddles};
}

} // namespace

FieldError UnderwaterPart::validate(const BodyDesc& desc) {
    if (desc.underwater && !desc.refraction) return "BodyDesc.underwater needs BodyDesc.refraction";
    return badAsked(underwaterFields, desc.underwater);
}

Status UnderwaterPart::create(Body&, const BodyDesc& of) {
    desc = *of.underwater;
    return Status::ok;
}

void UnderwaterPart::fillSnow(const Body& body, const BodyView& view, BodyBlock& block) const {
    constexpr double finestCell = 0.16, sinks = 1e-3, sways = 1 / 4.0; // [m], [m/s], [1/s]
    const double time = body.simulatedTime;
    const glm::dvec3 eye = view.geometry.eye + glm::dvec3(0, time * sinks, 0);
    block.snow = {desc.snow, sways * time - std::floor(sways * time), 0, 0};
    for (int i = 0; i < snowSizes; ++i) {
        const double cell = std::pow(2.2, i) * finestCell;
        const glm::dvec3 first = glm::floor(eye / cell) - snowCellsAcross / 2.0;
        block.snowCells[i] = {wrappedCell(first.x), wrappedCell(first.y), wrappedCell(first.z), 0};
        block.snowPlaces[i] = glm::vec4(glm::vec3(first * cell - eye), cell);
    }
}

void UnderwaterPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    block.halfMeniscus = desc.meniscus / 2;
    if (desc.snow > 0) fillSnow(body, view, block);
    if (!draws(body, ViewPass::shafts)) return;
    const SunInWater sun = fillSunInWater(block);
    const double slopes = resolvedSlopeVariance(*body.sea) + unresolvedSlopeVariance(*body.sea);
    // By a deviation of where slopes turn a ray.
    block.shafts = {desc.shafts, sun.turnedAcross * std::sqrt(slopes / 2), sun.turnedAcross, 0};
}

Status UnderwaterPart::draw(Body& body, const DrawCall& call, DrawMoment moment) const {
    for (const ViewPass pass : passes) {
        const bool isNow = (pass == ViewPass::water) == (moment == DrawMoment::beforeSurfaces);
        if (!isNow || !draws(body, pass)) continue;
        if (const Status s = record(body, call, pass); s != Status::ok) return s;
    }
    return Status::ok;
}

Status UnderwaterPart::record(Body& body, const DrawCall& call, ViewPass pass) const {
    BodyView view;
    if (const Status s = body.read("draw", call.view, call.lighting, body.needsScene(), view);
        s != Status::ok)
        return s;
    const SidesSeen sides = body.sidesSeen(view.geometry);
    const bool straddles = sides == SidesSeen::either;
    if (pass == ViewPass::waterline ? !straddles : sides == SidesSeen::above) return Status::ok;
    if (pass == ViewPass::snow && view.geometry.parallel) return Status::ok;
    if (pass == ViewPass::shafts && body.toSun(call.lighting).y <= 0) return Status::ok;
    ViewPassVariant variant = passVariant(body, pass, straddles);
    variant.sceneIsEncoded = pass == ViewPass::water && isEncoded(call.view.sceneColor);
    Resources resources;
    if (const Status s = bindBody(body, view, resources); s != Status::ok) return s;
    return recordViewPass(*body.context, call, view, variant, resources);
}

bool UnderwaterPart::draws(const Body& body, ViewPass pass) const {
    switch (pass) {
    case ViewPass::shafts:
        return desc.shafts > 0 && body.sea;
    case ViewPass::snow:
        return desc.snow > 0;
    case ViewPass::waterline:
        return desc.meniscus > 0;
    default:
        return true;
    }
}

Status UnderwaterPart::prepare(const Body& body, const PrepareCall& call) const {
    if (call.output != SurfaceOutput::shaded) return Status::ok;
    for (const ViewPass pass : passes)
        for (const bool straddles : {false, true}) {
            if (!draws(body, pass) || (pass == ViewPass::waterline && !straddles)) continue;
            ViewPassVariant variant = passVariant(body, pass, straddles);
            variant.sceneIsEncoded = pass == ViewPass::water && call.sceneIsEncoded;
            if (const Status s = prepareViewPass(call.target.viewPasses, variant); s != Status::ok) return s;
        }
    return Status::ok;
}

Part underwaterPart() {
    Part part = partFrom<UnderwaterPart>();
    part.needsScene = "BodyDesc.underwater";
    return part;
}

} // namespace seaglass
