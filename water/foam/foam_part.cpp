#include "water/foam/foam_part.h"

#include "shaders/shared/foam/foam_tiles.h"
#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/interface/fields/sea.h"
#include "water/interface/foam_gate.h"
#include "water/interface/foam_layers.h"
#include "water/interface/whitecaps.h"
#include "water/waves/in_tile.h"
#include "water/waves/waves_part.h"

namespace seaglass {

namespace {

/// The eye's on a layer, which comes round again after `repeat` [m].
glm::dvec2 placeIn(const FoamLayer& layer, const glm::dvec3& eye, double repeat) {
    double u = eye.x, v = eye.z;
    layer.apply(u, v);
    return {inTile(u, repeat) * repeat, inTile(v, repeat) * repeat};
}

} // namespace

FieldError FoamPart::validate(const BodyDesc& desc) {
    if (desc.foam && !desc.waves) return "BodyDesc.foam needs BodyDesc.waves";
    return badAsked(foamFields, desc.foam);
}

bool FoamPart::wanted(const BodyDesc& desc, const Sea* sea) {
    return desc.foam && sea && breakingOf(*sea, *desc.foam).count > 0;
}

Status FoamPart::addCost(const AskedBody& asked, Estimate& sum) {
    sum.bytes += Foam::bytes(asked.context, *asked.sea, *asked.desc.foam,
                             chosenBackend(asked.context.device, asked.desc));
    return Status::ok;
}

Status FoamPart::create(Body& body, const BodyDesc& desc) {
    if (const Status s = body.context->shareWhileUsed(pattern); s != Status::ok) return s;
    return foam.create(*body.context, *body.sea, *desc.foam, chosenBackend(body.context->device, desc));
}

Status FoamPart::simulate(Body& body, VkCommandBuffer commands, double time) {
    pattern->recordUpload(body.context->device, commands);
    return foam.record(*body.context, commands, body.find<WavesPart>()->waves, time);
}

void FoamPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const Sea& sea = *body.sea;
    const glm::dvec3& eye = view.geometry.eye;
    const FoamGate gate(sea, foam.time());
    const double atRest = warpAtRest(sea.warp), patch = cascade(sea, 0).patch;
    block.foamCell = {gate.firstCell((eye.x - atRest) / patch), gate.firstCell((eye.z - atRest) / patch),
                      static_cast<int32_t>(gate.turns()), static_cast<int32_t>(gate.now())};
    const double half = 0.5 / description(sea).samples;
    block.foamGate =
        glm::vec4(gate.cells() * (inTile(eye.x - atRest, patch) + half),
                  gate.cells() * (inTile(eye.z - atRest, patch) + half), gate.cells() / patch, 0);
    const FoamLayer lace = foamLaceOf(description(sea), foam.time(), foamRepeat);
    const glm::dvec2 laceAt = placeIn(lace, eye, foamRepeat);
    block.foamStep = foam.at().past;
    block.foamAlbedo = foam.albedo();
    block.foamPlace = laceAt;
    for (uint32_t c = 0; c < foam.cascades(); ++c) {
        const Cascade& of = cascade(sea, c);
        const FoamDrift drift = foamDriftOf(description(sea), of, foam.time());
        block.foamDrift[c] = glm::vec4(drift.u, drift.v, foam.at().pastPlume, 0);
    }
    block.foamStreak = {lace.u, lace.v};
    const FoamLayer windrows = foamWindrowsOf(description(sea), foam.time(), windrowTile);
    block.windrows = glm::vec4(windrows.u, windrows.v,
                               placeIn(windrows, eye - glm::dvec3(atRest, 0, atRest), windrowTile));
    const Breaking& breaking = foam.breaking();
    block.breaking = {breaking.now, breaking.nowWidth * breaking.nowWidth, breaking.hidden,
                      breaking.narrower};
    for (uint32_t c = 0; c < maxCascades; ++c) block.breakingCounts[static_cast<int>(c)] = breaking.counts[c];
    block.compression = {breaking.along[0], breaking.along[1], breaking.along[2], foamBreaksApart};
}

void FoamPart::vary(const Body&, const SurfaceDraw&, SurfaceVariant& variant) const {
    variant.hasFoam = true;
    variant.foamCascades = static_cast<int>(foam.cascades());
}

Status FoamPart::bind(Body& body, const BodyView&, Resources& out) {
    const VkSampler repeat = body.context->samplers.trilinearRepeat();
    out.push_back({foamPatternBinding, gpu::sampledImage(repeat, pattern->view())});
    out.push_back({foamHistoryBinding, gpu::sampledImage(repeat, foam.view())});
    return Status::ok;
}

Part foamPart() {
    return partFrom<FoamPart>();
}

} // namespace seaglass
