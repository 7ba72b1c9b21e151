#include "water/spray/spray_part.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "shaders/shared/water_bindings.h"
#include "water/below/underwater_part.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/parallel_view.h"
#include "water/body/target.h"
#include "water/foam/foam_fading.h"
#include "water/foam/foam_part.h"
#include "water/interface/fields/water.h"
#include "water/light/lighting.h"
#include "water/spray/spume.h"

namespace seaglass {

namespace {

constexpr double life = 2; ///< how long drops are seen [s]
/// Of the wind at 10 m, what blows at 1 m over a sea whose roughness length is 1 mm (logarithmic profile).
constexpr double windAtCrests = 0.75;
/// Optical depth, seen from above, of all that is torn off where waves break.
constexpr double opticalDepth = 2.4;

} // namespace

FieldError SprayPart::validate(const BodyDesc& desc) {
    if (!desc.spray) return {};
    if (!desc.foam) return "BodyDesc.spray needs BodyDesc.foam";
    if (desc.extent.shape != ExtentShape::unbounded)
        return "BodyDesc.spray is of the open sea, expected BodyDesc.extent to be unbounded";
    return badAsked(sprayFields, desc.spray);
}

bool SprayPart::wanted(const BodyDesc& desc, const Sea* sea) {
    return desc.spray && desc.spray->density > 0 && sea && breakingOf(*sea, *desc.foam).count > 0 &&
           tornShare(static_cast<double>(description(*sea).windSpeed)) > 0;
}

Status SprayPart::create(Body& body, const BodyDesc& of) {
    desc = *of.spray;
    particles = of.shading.sprayParticles;
    const Breaking breaks = breakingOf(*body.sea, *of.foam);
    most = static_cast<uint32_t>(std::ranges::max_element(breaks.share) - breaks.share);
    floor = fadingsOf(*of.foam, breaks)[most].foam.floor;
    fading = oddsDecayTime(*of.foam) / double{breaks.share[most]};
    breaking = breaks.count;
    for (uint32_t c = 0; c < breaks.count; ++c)
        crestsRun += static_cast<double>(breaks.share[c]) *
                     std::hypot(double{breaks.runs[c][0]}, double{breaks.runs[c][1]});
    const SeaDesc& sea = description(*body.sea);
    const auto wind = static_cast<double>(sea.windSpeed), towards = static_cast<double>(sea.windDirection);
    blows = windAtCrests * wind * glm::dvec2(std::cos(towards), std::sin(towards));
    torn = tornShare(wind);
    return Status::ok;
}

SprayVariant SprayPart::variant(const Body& body, const LightingDesc& lighting, bool straddles) const {
    const SeaDesc& sea = description(*body.sea);
    SprayVariant variant;
    variant.hasWaves = true;
    variant.straddles = straddles;
    variant.cascades = static_cast<int>(cascadeCount(*body.sea));
    variant.foamCascades = static_cast<int>(breaking);
    variant.isWarped = sea.warp > 0;
    variant.hasShore = body.sea->shore.has_value();
    variant.onGlobe = !body.placing.globe.flat();
    variant.hasSunShadow = lighting.shadow != nullptr;
    variant.fogKind = fogKind(lighting.fog);
    variant.skyHasColors = lighting.skyCube == VK_NULL_HANDLE;
    variant.tilted = body.frame.tilted;
    return variant;
}

SprayLattice SprayPart::lattice(const Body& body, const BodyView& view) const {
    return sprayLattice({view.geometry, body.heightOf(view.geometry.eye), body.placing.displacement,
                         life * glm::length(blows)},
                        particles);
}

glm::dvec2 SprayPart::placeInAir(const glm::dvec3& eye, double time) const {
    const double speed = glm::length(blows);
    const glm::dvec2 downwind = blows / speed, at(eye.x, eye.z);
    return {std::fmod(glm::dot(at, downwind) - speed * time, double{sprayAirStretch} * sprayAirRepeat),
            std::fmod(glm::dot(at, glm::dvec2(-downwind.y, downwind.x)), sprayAirRepeat)};
}

SprayBlock SprayPart::block(const BodyView& view, const SprayLattice& lattice, double time) const {
    SprayBlock block{};
    lattice.fill(view.geometry.eye, block);
    const glm::dvec2 inAir = placeInAir(view.geometry.eye, time);
    block.wind = {blows.x, blows.y, life, crestsRun};
    block.foam = {fading, 1 / foamStepsPerSecond, floor, most};
    block.form = {opticalDepth * torn * static_cast<double>(desc.density), desc.shutterTime, inAir.x,
                  inAir.y};
    return block;
}

Status SprayPart::draw(Body& body, const DrawCall& call, DrawMoment moment) const {
    if (moment != DrawMoment::afterSurfaces) return Status::ok;
    if (!call.target.desc.depthWrite)
        return body.context->device.fail(
            Status::invalidArgument,
            "draw: BodyDesc.spray is hidden by waves before it, expected TargetDesc.depthWrite to be true");
    BodyView view;
    if (const Status s = body.read("draw", call.view, call.lighting, body.needsScene(), view);
        s != Status::ok)
        return s;
    const SidesSeen sides = body.sidesSeen(view.geometry);
    if (sides == SidesSeen::below) return Status::ok;
    const SprayLattice seen = lattice(body, view);
    if (seen.count == 0) return Status::ok;
    BodyBlock drawn = bodyBlock(body, view);
    const auto lines =
        parallelLines(view.geometry, body.heightOf(view.geometry.eye), body.placing.displacement);
    if (lines) drawn.parallelDistance = static_cast<float>(lines->distance);
    Resources resources;
    if (const Status s = bindBody(body, view, drawn, resources); s != Status::ok) return s;
    gpu::Slice slice;
    if (const Status s =
            body.context->frame().upload(block(view, seen, body.find<FoamPart>()->foam.time()), slice);
        s != Status::ok)
        return s;
    resources.push_back({sprayBinding, gpu::uniformBuffer(slice)});
    return recordSpray(*body.context, call, view, variant(body, call.lighting, sides == SidesSeen::either),
                       seen.count, resources);
}

Status SprayPart::prepare(const Body& body, const PrepareCall& call) const {
    if (call.output != SurfaceOutput::shaded) return Status::ok;
    for (const bool straddles : {false, true}) {
        if (straddles && !body.find<UnderwaterPart>()) continue;
        const DrawPipeline* pipeline = nullptr;
        if (const Status s = call.target.spray.get(variant(body, call.lighting, straddles), pipeline);
            s != Status::ok)
            return s;
    }
    return Status::ok;
}

Part sprayPart() {
    return partFrom<SprayPart>();
}

} // namespace seaglass
