// What a body draws in a view: its surface, and what its parts have over it.
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"
#include "water/shading/shading_part.h"

namespace seaglass {

namespace {

/// What is drawn of motion is where the surface is, and was.
SurfaceVariant ofMotion(const SurfaceVariant& all) {
    SurfaceVariant v = shapeVariant(all);
    v.surfaceOutput = all.surfaceOutput;
    v.forMotion = true;
    return v;
}

} // namespace

SurfaceVariant Body::surfaceVariant(const SurfaceDraw& drawn) const {
    SurfaceVariant variant;
    variant.surfaceOutput = static_cast<uint32_t>(drawn.output);
    variant.sidesSeen = static_cast<uint32_t>(drawn.sides);
    variant.tilted = frame.tilted;
    for (const auto& [part, state] : has)
        if (part->vary) part->vary(state.get(), *this, drawn, variant);
    return drawn.isMotion() ? ofMotion(variant) : variant;
}

Status Body::drawParts(const DrawCall& call, DrawMoment moment) {
    for (const auto& [part, state] : has)
        if (part->draw)
            if (const Status s = part->draw(state.get(), *this, call, moment); s != Status::ok) return s;
    return Status::ok;
}

Status Body::checkDepth(const Target& target, const ViewGeometry& geometry) const {
    if (geometry.reversedDepth == target.desc.reversedDepth) return Status::ok;
    return context->device.fail(
        Status::invalidArgument,
        "draw: ViewDesc.projection makes what is nearer %s, expected TargetDesc.reversedDepth to be %s",
        geometry.reversedDepth ? "greater" : "less", geometry.reversedDepth ? "true" : "false");
}

Status Body::see(const char* call, const Target* target, SeenSurface& out) {
    const ViewGeometry& geometry = out.view.geometry;
    const bool motion = out.drawn.isMotion();
    if (motion && sea && !keepsMotion)
        return context->device.fail(Status::invalidArgument,
                                    "%s: SurfaceOutput::motion needs BodyDesc.motion", call);
    const glm::mat4 lastPixel =
        motion ? lastViews.pixelFromRelative(*out.view.given, geometry) : glm::mat4(1);
    if (placing.outline && !maySee(geometry)) return Status::ok;

    MeshView asMeshed = placing.meshView(geometry);
    asMeshed.farthestFirst = target && !target->desc.depthWrite;
    if (const Status s = placing.place(*context, asMeshed, exclusionVolumes, out.mesh); s != Status::ok)
        return s;
    if (out.mesh.instanceCount == 0) return Status::ok;
    out.block = bodyBlock(*this, out.view);
    if (motion) out.block.relativeFromPixel = lastPixel;
    if (asMeshed.parallel) out.block.parallelDistance = static_cast<float>(asMeshed.parallel->distance);
    return Status::ok;
}

Status Body::draw(const DrawCall& call, SurfaceOutput output) {
    SeenSurface seen;
    if (const Status s = readSurface("draw", call.view, call.lighting, output, seen.view, seen.drawn);
        s != Status::ok)
        return s;
    if (const Status s = checkDepth(call.target, seen.view.geometry); s != Status::ok) return s;
    return find<ShadingPart>()->place(*this, call, seen);
}

} // namespace seaglass
