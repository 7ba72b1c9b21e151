// What a body draws in a view: its surface, and what its parts have over it.
#include "gpu/view/encoding.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"

namespace seaglass {

namespace {

/// What is drawn of motion is where the surface is, and was.
SurfaceVariant ofMotion(const SurfaceVariant& all) {
    SurfaceVariant v;
    v.surfaceOutput = all.surfaceOutput;
    v.forMotion = true;
    v.hasWaves = all.hasWaves;
    v.hasShore = all.hasShore;
    v.shape = all.shape;
    v.cascades = all.cascades;
    v.isWarped = all.isWarped;
    v.exclusionVolumes = all.exclusionVolumes;
    v.onGlobe = all.onGlobe;
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

Status Body::draw(const DrawCall& call, SurfaceOutput output) {
    const gpu::Device& device = context->device;
    const ViewDesc& given = call.view;
    Target& target = call.target;
    BodyView view;
    if (const Status s = read(given, call.lighting, needsScene(), view); s != Status::ok) return s;
    const ViewGeometry& geometry = view.geometry;
    if (const Status s = checkEye(given, geometry); s != Status::ok) return s;
    if (geometry.reversedDepth != target.desc.reversedDepth)
        return device.fail(
            Status::invalidArgument,
            "draw: ViewDesc.projection makes what is nearer %s, expected TargetDesc.reversedDepth to be %s",
            geometry.reversedDepth ? "greater" : "less", geometry.reversedDepth ? "true" : "false");
    const bool motion = output == SurfaceOutput::motion;
    if (motion && sea && !keepsMotion)
        return device.fail(Status::invalidArgument, "draw: SurfaceOutput::motion needs BodyDesc.motion");
    const glm::mat4 lastPixel = motion ? lastViews.pixelFromRelative(given, geometry) : glm::mat4(1);
    if (placing.outline && !maySee(geometry)) return Status::ok;

    MeshView asMeshed = placing.meshView(geometry);
    asMeshed.farthestFirst = !target.desc.depthWrite;
    PlacedMesh mesh;
    if (const Status s = placing.place(*context, asMeshed, mesh); s != Status::ok) return s;
    if (mesh.instanceCount == 0) return Status::ok;

    const SurfaceDraw drawn = {.output = output,
                               .sides = motion ? SidesSeen::above : sidesSeen(geometry),
                               .seesScene = hasScene(given),
                               .sceneIsEncoded = isEncoded(given.sceneColor),
                               .manySamples = isMultisampled(given),
                               .view = &given,
                               .lighting = &call.lighting};
    view.surface = &drawn;
    BodyBlock block = bodyBlock(*this, view);
    if (motion) block.relativeFromPixel = lastPixel;
    if (asMeshed.parallel) block.within.w = static_cast<float>(asMeshed.parallel->distance);
    Resources resources;
    if (const Status s = bindBody(*this, view, block, resources); s != Status::ok) return s;
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = target.pipelines.get(surfaceVariant(drawn), pipeline); s != Status::ok) return s;
    setViewport(device, call.commands, given, geometry);
    return recordSurface(*context, call.commands, *pipeline, mesh, std::move(resources), given.viewIndex);
}

} // namespace seaglass
