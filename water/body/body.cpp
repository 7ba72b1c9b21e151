#include "water/body/body.h"

#include <cmath>
#include <cstring>

#include "gpu/view/plane.h"
#include "water/body/body_desc.h"
#include "water/sea/sea.h"
#include "water/spectrum/spectrum.h"

namespace seaglass {

namespace {

/// Whether a bottom would take much of the wind sea's energy that its model leaves there. What a table says
/// was measured over it.
bool isTooHighForItsDepth(const SeaDesc& desc) {
    constexpr double much = 0.1;
    if (desc.spectrum == SpectrumModel::tma || desc.spectrum == SpectrumModel::table) return false;
    if (!(desc.windSpeed > 0) || !(desc.depth > 0) || !std::isfinite(desc.depth)) return false;
    return kitaigorodskii(makeSpectrum(desc).peak, double{desc.depth}) < 1 - much;
}

} // namespace

Status PatchIndices::create(Context& context) {
    const std::vector<uint16_t> indices = patchIndices();
    const VkDeviceSize bytes = indices.size() * sizeof(uint16_t);
    if (const Status s = buffer.createMapped(context.device, bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                             "patch index buffer");
        s != Status::ok)
        return s;
    std::memcpy(buffer.mapped(), indices.data(), bytes);
    return Status::ok;
}

Status Body::create(Context& owner, const BodyDesc& desc) {
    context = &owner;
    if (const FieldError bad = badField(desc))
        return owner.device.fail(Status::invalidArgument, "%s", bad.text());
    if (const char* bad = readPlane(desc.plane, plane))
        return owner.device.fail(Status::invalidArgument, "%s", bad);
    frame = BodyFrame::of(glm::dvec3(plane));
    plane = {0, 1, 0, plane.w};
    if (desc.extent.shape == ExtentShape::unbounded) globe = Globe::of(desc.extent.planetRadius);
    mesh = desc.mesh;
    shading = desc.shading;
    if (desc.waves)
        if (const Status s = createWaves(desc); s != Status::ok) return s;
    if (desc.foam && waves)
        if (const Status s = createFoam(*desc.foam); s != Status::ok) return s;
    if (desc.refraction) refraction = *desc.refraction;
    if (desc.bed)
        if (const Status s =
                Bed::create(owner, bed.emplace(Bed{.desc = *desc.bed,
                                                   .downscale = desc.shading.bedDownscale,
                                                   .distortion = double{refraction->distortion}}));
            s != Status::ok)
            return s;
    if (desc.underwater) underwater = *desc.underwater;
    if (desc.caustics && waves)
        if (const Status s = caustics.emplace().create(owner, *sea, *desc.caustics); s != Status::ok)
            return s;
    if (desc.extent.shape != ExtentShape::unbounded) outline = outlineOf(desc.extent);
    if (desc.extent.shape == ExtentShape::mesh)
        if (const Status s = hostMesh.emplace().create(owner.device, desc.extent, *outline); s != Status::ok)
            return s;
    if (desc.reflection && desc.reflection->technique != ReflectionTechnique::sky)
        if (const Status s = createReflector(desc); s != Status::ok) return s;
    return hostMesh ? Status::ok : owner.share(indices);
}

Status Body::createReflector(const BodyDesc& desc) {
    ReflectorDesc reflectorDesc;
    std::memcpy(reflectorDesc.plane, desc.plane, sizeof desc.plane);
    reflectorDesc.reflection = reflectionOf(*desc.reflection, waves.has_value());
    if (outline) {
        const double level = -plane.w, d = displacement();
        const double low[] = {outline->low.x, level - d, outline->low.y};
        const double high[] = {outline->high.x, level + d, outline->high.y};
        std::memcpy(reflectorDesc.boundsLow, low, sizeof low);
        std::memcpy(reflectorDesc.boundsHigh, high, sizeof high);
    }
    reflectionDistortion = desc.reflection->distortion;
    reflection = reflectorDesc.reflection;
    return seaglass::createReflector(*context, reflectorDesc, frame.worldFromBody, reflector);
}

Status Body::createWaves(const BodyDesc& desc) {
    SeaError error;
    std::unique_ptr<Sea, SeaDeleter> made(createSea(desc.waves, &error));
    if (!made) return context->device.fail(Status::invalidArgument, "BodyDesc.waves: %s", error.text);
    if (cascadeCount(*made) == 0) return Status::ok; // Wind 0 is a flat body, by branch.
    sea = std::move(made);
    if (isTooHighForItsDepth(*desc.waves))
        context->device.warn(
            "BodyDesc.waves: SeaDesc.depth of %.3g m slows these waves and leaves them as high as "
            "over deep water; SpectrumModel::tma lowers them too",
            double{desc.waves->depth});
    detail = WaveDetail(*sea);
    if (sea->shore)
        if (const Status s = shore.emplace().create(*context, *sea->shore); s != Status::ok) return s;
    if (const Status s = waves.emplace().create(*context, *sea, chosenBackend(context->device, desc));
        s != Status::ok)
        return s;
    keepsMotion = desc.motion;
    return keepsMotion ? waves->keepLast(context->device) : Status::ok;
}

Status Body::createFoam(const FoamDesc& desc) {
    foamDecay = double{desc.decayTime};
    if (breakingOf(*sea, desc).count == 0) return Status::ok;
    if (const Status s = foamPattern.emplace().create(*context); s != Status::ok) return s;
    return foam.emplace().create(*context, *sea, desc, *waves);
}

Status Body::simulate(VkCommandBuffer commands, double time) {
    if (!std::isfinite(time))
        return context->device.fail(Status::invalidArgument, "simulate: time is not finite");
    if (!waves) return Status::ok;
    if (recorded.simulated == context->frameNumber)
        return context->device.misused("simulate: it was called for the body in this frame before");
    if (recorded.drawn == context->frameNumber)
        return context->device.misused("simulate: the body was drawn in this frame before");
    recorded.simulated = context->frameNumber;
    if (foamPattern) foamPattern->recordUpload(context->device, commands);
    if (simulated) waves->turnOver();
    simulated = true;
    if (shore) shore->record(context->device, commands, *sea->shore, time, foamDecay);
    if (foam)
        if (const Status s = foam->record(*context, commands, *waves, time); s != Status::ok) return s;
    return waves->record(*context, commands, time);
}

Status Body::takeScene(VkCommandBuffer commands, SceneOfCall& scene) {
    if (scene.taken) return context->share(singleSamples);
    ViewGeometry geometry;
    if (const FieldError bad = readTurned(frame.fromWorld(scene.given), true, geometry))
        return context->device.fail(Status::invalidArgument, "reflect: %s", bad.text());
    if (!mayShow(geometry)) return Status::ok;
    return takeSamples(*context, commands, geometry, singleSamples, scene);
}

Status Body::bedView(const ViewDesc& view, PlanarView& out) {
    const gpu::Device& device = context->device;
    if (!bed) return device.fail(Status::invalidArgument, "bedView: the body has no BodyDesc.bed");
    ViewGeometry geometry;
    if (const FieldError bad = readTurned(frame.fromWorld(view), false, geometry))
        return device.fail(Status::invalidArgument, "bedView: %s", bad.text());
    out = {};
    out.visible = sidesSeen(geometry) != SidesSeen::below && mayShow(geometry);
    if (!out.visible) return Status::ok;
    // On a shore what shines through a film of water lies as high as the waves run up.
    const double raised = shore ? displacement() : 0;
    const glm::dvec4 highest(frame.worldFromBody[1], plane.w - raised);
    return bed->handOut(*context, view, geometry, highest, frame, out);
}

Status Body::reflect(VkCommandBuffer commands, SceneOfCall& scene) {
    if (bed)
        if (const Status s = bed->take(*context, commands, scene.given.viewIndex); s != Status::ok) return s;
    if (!isMultisampled(scene.given))
        dropSamples(*context, singleSamples.get(), scene.given.viewIndex);
    else if (refraction)
        if (const Status s = takeScene(commands, scene); s != Status::ok) return s;
    if (!reflector) return Status::ok;
    const uint32_t view = scene.given.viewIndex;
    const uint64_t now = context->frameNumber;
    if (view < maxViews && recorded.mirroring[view] == now && recorded.reflected[view] != now)
        return context->device.misused("reflect: the body was drawn in this view and frame before");
    if (const Status s = seaglass::reflect(commands, *reflector, scene); s != Status::ok) return s;
    recorded.reflected[view] = now;
    return Status::ok;
}

} // namespace seaglass
