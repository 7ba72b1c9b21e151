#include "water/below/underwater_part.h"

#include "gpu/view/encoding.h"
#include "seaglass/fields/water.h"
#include "water/below/underwater.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"

namespace seaglass {

FieldError UnderwaterPart::validate(const BodyDesc& desc) {
    if (desc.underwater && !desc.refraction) return "BodyDesc.underwater needs BodyDesc.refraction";
    return badAsked(underwaterFields, desc.underwater);
}

Status UnderwaterPart::create(Body&, const BodyDesc& of) {
    desc = *of.underwater;
    return Status::ok;
}

void UnderwaterPart::fill(const Body&, const BodyView&, BodyBlock& block) const {
    block.within.y = desc.meniscus / 2;
}

Status UnderwaterPart::draw(Body& body, const DrawCall& call, DrawMoment moment) const {
    BodyView view;
    if (const Status s = body.read("draw", call.view, call.lighting, body.needsScene(), view);
        s != Status::ok)
        return s;
    const SidesSeen sides = body.sidesSeen(view.geometry);
    const bool straddles = sides == SidesSeen::either, isWater = moment == DrawMoment::beforeSurfaces;
    const bool wanted = isWater ? sides != SidesSeen::above : straddles && desc.meniscus > 0;
    if (!wanted) return Status::ok;
    Resources resources;
    if (const Status s = bindBody(body, view, resources); s != Status::ok) return s;
    return recordUnderwater(*body.context, call, view,
                            {.pass = isWater ? UnderwaterPass::water : UnderwaterPass::waterline,
                             .straddles = straddles,
                             .hasWaves = straddles && body.sea,
                             .hasShore = straddles && body.sea && body.sea->shore,
                             .sceneIsEncoded = isWater && isEncoded(call.view.sceneColor)},
                            resources);
}

Status UnderwaterPart::prepare(const Body& body, const PrepareCall& call) const {
    if (call.output != SurfaceOutput::shaded) return Status::ok;
    const auto prepared = [&](const UnderwaterVariant& variant) {
        return prepareUnderwater(call.target.underwater, variant);
    };
    UnderwaterVariant over = {.pass = UnderwaterPass::water};
    over.sceneIsEncoded = call.sceneIsEncoded;
    if (const Status s = prepared(over); s != Status::ok) return s;
    over.straddles = true;
    over.hasWaves = body.sea != nullptr;
    over.hasShore = body.sea && body.sea->shore;
    if (const Status s = prepared(over); s != Status::ok || desc.meniscus <= 0) return s;
    over.pass = UnderwaterPass::waterline;
    over.sceneIsEncoded = false;
    return prepared(over);
}

Part underwaterPart() {
    Part part = partFrom<UnderwaterPart>();
    part.needsScene = "BodyDesc.underwater";
    return part;
}

} // namespace seaglass
