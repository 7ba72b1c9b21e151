#include "water/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "gpu/guard.h"
#include "reflection/mirror.h"
#include "water/body_desc.h"
#include "water/lighting.h"
#include "water/sea.h"
#include "water/surface_uniforms.h"
#include "water/target.h"

namespace seaglass {

namespace {

/// Null: compute shaders.
const WavesBackend* chosenBackend(const gpu::Device& device, const BodyDesc& desc) {
    const bool onCpu = desc.wavesOn == WavesOn::cpu ||
                       (desc.wavesOn == WavesOn::automatic && device.type() == VK_PHYSICAL_DEVICE_TYPE_CPU);
    return onCpu ? desc.wavesBackend : nullptr;
}

/// Where lines of sight begin, within `reach` metres of a place.
struct SightStart {
    glm::dvec3 middle{0};
    double reach = 0;
};

/// At the eye, as far as the corners of the near plane; of parallel lines on that plane, as far as those
/// stand above its middle.
SightStart sightStart(const ViewGeometry& geometry) {
    const double depth = geometry.reversedDepth ? 1 : 0;
    const auto onNearPlane = [&](double x, double y) {
        const glm::dvec2 at = glm::dvec2(x, y) * glm::dvec2(geometry.regionSize);
        const glm::dvec4 p = geometry.relativeFromPixel * glm::dvec4(at, depth, 1);
        return glm::dvec3(p) / std::abs(p.w);
    };
    const glm::dvec3 middle = geometry.parallel ? onNearPlane(0.5, 0.5) : glm::dvec3(0);
    SightStart start{geometry.eye + middle, 0};
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 corner = onNearPlane(i & 1, i >> 1) - middle;
        start.reach = std::max(start.reach, geometry.parallel ? std::abs(corner.y) : glm::length(corner));
    }
    return start;
}

/// Blocks that follow on each other in one buffer.
template<typename... Blocks>
Status upload(Context& context, gpu::Resource& out, const Blocks&... blocks) {
    gpu::Slice slice;
    const size_t bytes = (std::as_bytes(std::span(blocks)).size() + ...);
    if (const Status s = context.frame().allocate(bytes, slice); s != Status::ok) return s;
    auto* data = static_cast<std::byte*>(slice.data);
    ((data = std::ranges::copy(std::as_bytes(std::span(blocks)), data).out), ...);
    out = gpu::storageBuffer(slice.buffer, slice.offset, bytes);
    return Status::ok;
}

/// As pixelWidth() of shaders/common/surface_uniforms.glsl has it, amid the picture [rad]; of parallel lines
/// of sight [m].
double pixelStep(const ViewGeometry& geometry) {
    const glm::dmat4 rows = glm::transpose(geometry.pixelFromRelative);
    const glm::dvec2 middle = glm::dvec2(geometry.regionSize) / 2.0;
    const glm::dvec3 ahead(rows[3]), right = glm::dvec3(rows[0]) - middle.x * ahead,
                                     down = glm::dvec3(rows[1]) - middle.y * ahead;
    return 1 / std::sqrt(glm::length(glm::cross(right, down)));
}

void setViewport(const gpu::Device& device, VkCommandBuffer commands, const ViewDesc& view,
                 const ViewGeometry& geometry) {
    device.vk().CmdSetViewport(commands, 0, 1, &view.viewport);
    const VkRect2D scissor = {
        {geometry.regionOrigin.x, geometry.regionOrigin.y},
        {static_cast<uint32_t>(geometry.regionSize.x), static_cast<uint32_t>(geometry.regionSize.y)}};
    device.vk().CmdSetScissor(commands, 0, 1, &scissor);
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
    if (const char* bad = badField(desc)) return owner.device.fail(Status::invalidArgument, "%s", bad);
    if (const char* bad = readPlane(desc.plane, plane))
        return owner.device.fail(Status::invalidArgument, "%s", bad);
    frame = BodyFrame::of(glm::dvec3(plane));
    plane = {0, 1, 0, plane.w};
    mesh = desc.mesh;
    shading = desc.shading;
    if (desc.waves)
        if (const Status s = createWaves(desc); s != Status::ok) return s;
    if (desc.foam && waves)
        if (const Status s = createFoam(*desc.foam); s != Status::ok) return s;
    if (desc.refraction) refraction = *desc.refraction;
    if (desc.bed) bed.emplace(Bed{*desc.bed, double{desc.refraction->distortion}, {}});
    if (desc.underwater) underwater = *desc.underwater;
    if (desc.caustics && waves) {
        caustics = *desc.caustics;
        causticBlur = causticBlurOf(*sea);
    }
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
    reflectorDesc.reflection = *desc.reflection;
    if (!waves) reflectorDesc.reflection.distortion = 0; // nothing bends it
    if (outline) {
        const double level = -plane.w, d = displacement();
        const double low[] = {outline->low.x, level - d, outline->low.y};
        const double high[] = {outline->high.x, level + d, outline->high.y};
        std::memcpy(reflectorDesc.boundsLow, low, sizeof low);
        std::memcpy(reflectorDesc.boundsHigh, high, sizeof high);
    }
    reflector = std::make_unique<Reflector>();
    reflectionDistortion = desc.reflection->distortion;
    if (const Status s = reflector->create(*context, reflectorDesc); s != Status::ok) return s;
    reflector->bounds.axes = frame.worldFromBody;
    return Status::ok;
}

Status Body::createWaves(const BodyDesc& desc) {
    SeaError error;
    std::unique_ptr<Sea, SeaDeleter> made(createSea(desc.waves, &error));
    if (!made) return context->device.fail(Status::invalidArgument, "BodyDesc.waves: %s", error.text);
    if (cascadeCount(*made) == 0) return Status::ok; // Wind 0 is a flat body, by branch.
    sea = std::move(made);
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
    if (const char* bad = readTurned(frame.fromWorld(scene.given), true, geometry))
        return context->device.fail(Status::invalidArgument, "reflect: %s", bad);
    if (!mayShow(geometry)) return Status::ok;
    const ReflectionDesc desc;
    gpu::Slice mirror;
    if (const Status s = context->frame().upload(
            mirrorUniforms(geometry, plane, desc, {0, 0, geometry.regionSize}), mirror);
        s != Status::ok)
        return s;
    return takeSamples({*context, commands, scene.read, geometry, desc, mirror}, singleSamples, scene);
}

bool Body::mayShow(const ViewGeometry& geometry) {
    if (sidesSeen(geometry) != SidesSeen::above) return true;
    const MeshView view = meshView(geometry);
    if (outline) return inSight(view, outline->boxFrom(view.eye));
    selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, patches);
    return !patches.empty();
}

Status Body::bedView(const ViewDesc& view, PlanarView& out) {
    const gpu::Device& device = context->device;
    if (!bed) return device.fail(Status::invalidArgument, "bedView: the body has no BodyDesc.bed");
    ViewGeometry geometry;
    if (const char* bad = readTurned(frame.fromWorld(view), false, geometry))
        return device.fail(Status::invalidArgument, "bedView: %s", bad);
    out = {};
    out.visible = sidesSeen(geometry) != SidesSeen::below && mayShow(geometry);
    if (!out.visible) return Status::ok;
    // On a shore what shines through a film of water lies as high as the waves run up.
    const double raised = shore ? displacement() : 0;
    const glm::dvec4 highest(frame.worldFromBody[1], plane.w - raised);
    return bed->handOut(*context, view, geometry, highest, frame, out);
}

Status Body::reflect(VkCommandBuffer commands, SceneOfCall& scene) {
    if (bed) bed->take(*context, commands, scene.given.viewIndex);
    if (!isMultisampled(scene.given))
        dropSamples(*context, singleSamples.get(), scene.given.viewIndex);
    else if (refraction)
        if (const Status s = takeScene(commands, scene); s != Status::ok) return s;
    if (!reflector) return Status::ok;
    const uint32_t view = scene.given.viewIndex;
    const uint64_t now = context->frameNumber;
    if (view < maxViews && recorded.mirroring[view] == now && recorded.reflected[view] != now)
        return context->device.misused("reflect: the body was drawn in this view and frame before");
    if (const Status s = reflector->record(commands, scene); s != Status::ok) return s;
    recorded.reflected[view] = now;
    return Status::ok;
}

SurfaceFeatures Body::features(const ReflectionImages& images, const LightingDesc& lighting) const {
    const SurfaceShape shape = hostMesh  ? SurfaceShape::hostMesh
                               : outline ? SurfaceShape::outlined
                                         : SurfaceShape::plane;
    return {waves.has_value(),
            foam.has_value(),
            refraction.has_value(),
            images.color != VK_NULL_HANDLE,
            shore.has_value(),
            shape,
            waves ? waves->maps().cascades : 0,
            foam ? foam->cascades() : 0,
            waves && refraction && refraction->scattering > 0,
            roomsPacked(dryRooms),
            waves ? shading.mirrorLooks : 0,
            refraction ? shading.refractionLooks : 0,
            waves ? shading.slopeLooks : 0,
            waves ? shading.waveShadowSteps : 0,
            waves && !shore && shading.relief,
            lighting.shadow != nullptr,
            frame.tilted,
            bed.has_value(),
            shading.fresnel == Fresnel::schlick};
}

SurfaceFeatures Body::motionFeatures() const {
    SurfaceFeatures wanted;
    wanted.waves = waves.has_value();
    wanted.shore = shore.has_value();
    wanted.shape = features({}, {}).shape;
    wanted.cascades = waves ? waves->maps().cascades : 0;
    wanted.dryRooms = roomsPacked(dryRooms);
    wanted.motion = true;
    return wanted;
}

glm::mat4 Body::lastPixelFromRelative(const ViewDesc& view, const ViewGeometry& geometry) {
    const LastView now{geometry.pixelFromRelative, geometry.eye, geometry.jitter};
    const auto [entry, fresh] = lastViews.try_emplace(view.viewIndex, now);
    const LastView last = std::exchange(entry->second, now);
    if (fresh || view.cut) return glm::mat4(now.pixelFromRelative);
    glm::dmat4 moved(1), steadied(1);
    moved[3] = glm::dvec4(geometry.eye - last.eye, 1);
    steadied[3] = glm::dvec4(now.jitter - last.jitter, 0, 1);
    return glm::mat4(steadied * last.pixelFromRelative * moved);
}

Status Body::place(const MeshView& view, SurfaceInputs& inputs) {
    inputs.instanceCount = 0;
    if (hostMesh) return placeHostMesh(view, inputs);
    inputs.indices = indices->buffer.handle();
    return outline ? placeOutlined(view, inputs) : placePatches(view, inputs);
}

MeshView Body::meshView(const ViewGeometry& geometry) const {
    MeshView view;
    view.eye = {geometry.eye.x, geometry.eye.z};
    view.eyeHeight = heightOf(geometry.eye);
    view.displacement = displacement();
    view.waves = &detail;
    view.pixel = pixelStep(geometry);
    view.parallel = parallelLines(geometry, view.eyeHeight, view.displacement);
    if (view.parallel) view.pixel /= view.parallel->distance;
    // Patches are tested around the eye's foot on the calm plane.
    glm::dmat4 relativeFromFoot(1);
    relativeFromFoot[3].y = -view.eyeHeight;
    view.frustum = frustumPlanes(geometry.clipFromRelative * relativeFromFoot, geometry.reversedDepth);
    return view;
}

void Body::placeCells(uint32_t across, SurfaceInputs& inputs) const {
    inputs.firstIndex = firstPatchIndex(across);
    inputs.indexCount = across * across * 6;
}

Status Body::placePatches(const MeshView& view, SurfaceInputs& inputs) {
    placeCells(selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, patches), inputs);
    inputs.instanceCount = static_cast<uint32_t>(patches.size());
    if (patches.empty()) return Status::ok;
    return upload(*context, inputs.patches, patches);
}

Status Body::placeOutlined(const MeshView& view, SurfaceInputs& inputs) {
    placeCells(selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, *outline,
                             pinnedWithin(displacement()), outlined),
               inputs);
    inputs.instanceCount = static_cast<uint32_t>(outlined.patches.size());
    if (outlined.patches.empty()) return Status::ok;
    if (const Status s = upload(*context, inputs.patches, outlined.patches); s != Status::ok) return s;
    const std::array box = {outline->boxFrom(view.eye).packed()};
    return upload(*context, inputs.extent, box, outlined.edges);
}

Status Body::placeHostMesh(const MeshView& view, SurfaceInputs& inputs) {
    if (!inSight(view, outline->boxFrom(view.eye))) return Status::ok;
    inputs.patches = gpu::storageBuffer(hostMesh->vertices.handle());
    inputs.indices = hostMesh->indices.handle();
    inputs.indexType = VK_INDEX_TYPE_UINT32;
    inputs.indexCount = hostMesh->indexCount;
    inputs.instanceCount = 1;
    return Status::ok;
}

const char* Body::readTurned(const ViewDesc& turned, bool seesScene, ViewGeometry& out) const {
    if (const char* bad = seesScene ? readView(turned, out) : readCamera(turned, out)) return bad;
    placeEye(out, -plane.w);
    return nullptr;
}

Status Body::readForDraw(const ViewDesc& view, const LightingDesc& lighting, ViewGeometry& out,
                         ViewDesc& read) {
    const gpu::Device& device = context->device;
    const ViewDesc turned = frame.fromWorld(view);
    if (const char* bad = readTurned(turned, refraction.has_value(), out))
        return device.fail(Status::invalidArgument, "draw: %s", bad);
    if (const char* bad = badField(lighting)) return device.fail(Status::invalidArgument, "draw: %s", bad);
    if (waves && !simulated)
        return device.misused("draw: the body has waves but simulate() was never called");
    recorded.drawn = context->frameNumber;
    read = view;
    if (!refraction || !isMultisampled(view)) return Status::ok;
    if (!mayShow(out)) return Status::ok; // nothing was taken, and nothing will be drawn
    if (!singleSamples || !singleSamples->views[view.viewIndex].fits(view))
        return device.misused(
            "draw: ViewDesc.sceneDepth.samples is not 1, and reflect() was not called for this view before");
    singleSamples->views[view.viewIndex].standIn(read);
    return Status::ok;
}

SidesSeen Body::sidesSeen(const ViewGeometry& geometry) const {
    if (!underwater) return SidesSeen::above;
    const SightStart start = sightStart(geometry);
    if (outline && !outline->contains({start.middle.x, start.middle.z})) return SidesSeen::above;
    if (isDry(dryRooms, start.middle)) return SidesSeen::above;
    const double height = heightOf(start.middle);
    const double reach = displacement() + start.reach;
    if (height > reach) return SidesSeen::above;
    return height < -reach ? SidesSeen::below : SidesSeen::either;
}

Status Body::drawUnderwater(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                            const LightingDesc& lighting, UnderwaterPass pass) {
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read); s != Status::ok) return s;
    const SidesSeen sides = sidesSeen(geometry);
    const bool straddles = sides == SidesSeen::either;
    const bool wanted =
        pass == UnderwaterPass::water ? sides != SidesSeen::above : straddles && underwater->meniscus > 0;
    if (!wanted) return Status::ok;
    return recordOverView(
        commands, target, read, lighting, geometry,
        {.pass = pass, .straddles = straddles, .waves = straddles && waves, .shore = straddles && shore});
}

Status Body::drawCaustics(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                          const LightingDesc& lighting) {
    if (!caustics) return Status::ok;
    if (!holdsFloats(target.desc.colorFormat))
        return context->device.fail(
            Status::invalidArgument,
            "drawCaustics: TargetDesc.colorFormat holds no floats, and light that is gathered exceeds 1");
    if (isMultisampled(view))
        return context->device.fail(
            Status::unsupported,
            "drawCaustics: ViewDesc.sceneDepth.samples is not 1: nothing has taken one sample of each yet");
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read); s != Status::ok) return s;
    if (toSun(lighting).y <= 0) return Status::ok;
    UnderwaterVariant variant = {UnderwaterPass::caustics};
    variant.waves = true;
    variant.sunShadow = lighting.shadow != nullptr;
    variant.searchSteps = shading.refractionLooks < 4 ? 1 : 2;
    variant.shore = shore.has_value();
    variant.dryRooms = roomsPacked(dryRooms);
    return recordOverView(commands, target, read, lighting, geometry, variant);
}

Status Body::shoreInputs(bool moves, VkImageView& map, gpu::Resource& rows) {
    if (!shore) return Status::ok;
    map = shore->view();
    if (moves) return upload(*context, rows, shore->signal().rows, shore->last().rows);
    return upload(*context, rows, shore->signal().rows);
}

Status Body::recordOverView(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                            const LightingDesc& lighting, const ViewGeometry& geometry,
                            const UnderwaterVariant& variant) {
    const SurfaceUniforms uniforms = surfaceUniforms(*this, geometry, lighting);
    UnderwaterInputs inputs;
    inputs.view = &view;
    inputs.shadow = lighting.shadow;
    if (const Status s = context->frame().upload(uniforms, inputs.uniforms); s != Status::ok) return s;
    const size_t map = variant.pass == UnderwaterPass::caustics ? 1 : 0;
    if (variant.waves) inputs.waveMap = waves->maps().images[map].view();
    if (variant.shore)
        if (const Status s = shoreInputs(false, inputs.shoreMap, inputs.shoreRows); s != Status::ok) return s;
    setViewport(context->device, commands, view, geometry);
    return recordUnderwater(*context, commands, target.underwater, variant, inputs);
}

Status Body::draw(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                  const LightingDesc& lighting, SurfaceOutput output) {
    const gpu::Device& device = context->device;
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read); s != Status::ok) return s;
    if (geometry.reversedDepth != target.desc.reversedDepth)
        return device.fail(
            Status::invalidArgument,
            "draw: ViewDesc.projection makes what is nearer %s, expected TargetDesc.reversedDepth to be %s",
            geometry.reversedDepth ? "greater" : "less", geometry.reversedDepth ? "true" : "false");
    const bool motion = output == SurfaceOutput::motion;
    if (motion && waves && !keepsMotion)
        return device.fail(Status::invalidArgument, "draw: SurfaceOutput::motion needs BodyDesc.motion");
    const glm::mat4 lastPixel = motion ? lastPixelFromRelative(view, geometry) : glm::mat4(1);
    if (outline && !mayShow(geometry)) return Status::ok;

    SurfaceUniforms uniforms = surfaceUniforms(*this, geometry, lighting);
    if (motion) uniforms.relativeFromPixel = lastPixel;
    SurfaceInputs inputs;
    MeshView asMeshed = meshView(geometry);
    asMeshed.farthestFirst = !target.desc.depthWrite;
    if (asMeshed.parallel) uniforms.within.w = static_cast<float>(asMeshed.parallel->distance);
    if (const Status s = place(asMeshed, inputs); s != Status::ok) return s;
    if (inputs.instanceCount == 0) return Status::ok;

    if (reflector && !motion) {
        inputs.reflection = reflector->images(view.viewIndex);
        recorded.mirroring[view.viewIndex] = context->frameNumber;
    }
    if (inputs.reflection.bent) uniforms.reflectionDistortion = 0;
    SurfaceFeatures wanted = motion ? motionFeatures() : features(inputs.reflection, lighting);
    const SidesSeen sides = motion ? SidesSeen::above : sidesSeen(geometry);
    wanted.bed = wanted.bed && sides != SidesSeen::below;
    if (wanted.bed) {
        inputs.bed = bed->of(*context, view.viewIndex);
        if (!inputs.bed)
            return device.misused("draw: BodyDesc.bed is set, and bedView() and reflect() were not called "
                                  "for this view before");
        setBed(uniforms, *inputs.bed, geometry.eye);
    }
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = target.pipelines.get({wanted, output, sides}, pipeline); s != Status::ok) return s;
    if (const Status s = context->frame().upload(uniforms, inputs.uniforms); s != Status::ok) return s;
    inputs.lighting = &lighting;
    inputs.view = &read;
    if (waves)
        for (uint32_t i = 0; i < waveMapCount; ++i) inputs.waveMaps[i] = waves->maps().images[i].view();
    if (motion && waves) inputs.lastDisplacement = waves->lastDisplacement();
    if (foamPattern) inputs.foamPattern = foamPattern->view();
    if (foam) inputs.foamHistory = foam->view();
    if (const Status s = shoreInputs(motion, inputs.shoreMap, inputs.shoreRows); s != Status::ok) return s;
    setViewport(device, commands, view, geometry);
    return recordSurface(*context, commands, *pipeline, wanted, inputs);
}

Status createBody(Context* context, const BodyDesc* desc, Body** out) {
    if (out) *out = nullptr;
    if (const Status s =
            gpu::refuseNull(context, "createBody", {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    return gpu::guarded([&] {
        auto body = std::make_unique<Body>();
        if (const Status s = body->create(*context, *desc); s != Status::ok) return s;
        *out = body.release();
        ++context->inUse;
        return Status::ok;
    });
}

namespace {

Status addWaves(Context& context, const BodyDesc& desc, Estimate& out) {
    SeaError error;
    const std::unique_ptr<Sea, SeaDeleter> sea(createSea(desc.waves, &error));
    if (!sea) return context.device.fail(Status::invalidArgument, "BodyDesc.waves: %s", error.text);
    if (cascadeCount(*sea) == 0) return Status::ok;
    const WavesBackend* backend = chosenBackend(context.device, desc);
    out.bytes += Waves::bytes(context, *sea, backend) + (desc.motion ? Waves::lastBytes(*sea) : 0);
    if (sea->shore) out.bytes += ShoreMap::bytes(*sea->shore);
    if (desc.foam && breakingOf(*sea, *desc.foam).count > 0)
        out.bytes += FoamPattern::bytes() + Foam::bytes(*sea, *desc.foam, backend, context.frameCount);
    return Status::ok;
}

} // namespace

Status estimate(Context* context, const BodyDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples) {
    if (const Status s =
            gpu::refuseNull(context, "estimate", {{"context", !context}, {"desc", !desc}, {"out", !out}});
        s != Status::ok)
        return s;
    *out = {};
    if (const char* bad = badField(*desc)) return context->device.fail(Status::invalidArgument, "%s", bad);
    if (const char* bad = badField(samples)) return context->device.fail(Status::invalidArgument, "%s", bad);
    return gpu::guarded([&] {
        Estimate sum;
        if (desc->reflection)
            if (const Status s = estimate(context, desc->reflection, extent, &sum, samples); s != Status::ok)
                return s;
        if (desc->refraction) {
            sum.bytesPerSharedView = SingleSampledScene::bytes(extent, samples);
            sum.dispatchesPerSharedView = SingleSampledScene::dispatches(samples);
        }
        if (desc->bed) sum.bytesPerView += Bed::bytes(*desc->bed, extent);
        if (desc->waves)
            if (const Status s = addWaves(*context, *desc, sum); s != Status::ok) return s;
        sum.bytes += HostMesh::bytes(desc->extent);
        *out = sum;
        return Status::ok;
    });
}

void destroyBody(Body* body) {
    destroyHeld(body, "destroyBody");
}

Status setDryRooms(Body* body, const DryRoom* rooms, uint32_t count) {
    if (!body) return Status::invalidArgument;
    return gpu::guarded([&] {
        if (const char* bad = readDryRooms(rooms, count, body->dryRooms))
            return body->context->device.fail(Status::invalidArgument, "%s", bad);
        for (DryPlanes& room : body->dryRooms) room = body->frame.fromWorld(room);
        return Status::ok;
    });
}

namespace {

template<typename Each>
Status forEach(Body* const* bodies, uint32_t count, Each&& each) {
    return gpu::guarded([&] {
        for (uint32_t i = 0; i < count; ++i)
            if (const Status s = each(*bodies[i]); s != Status::ok) return s;
        return Status::ok;
    });
}

/// What calls that record for bodies are handed. `context`: where there may be one and no body.
Status refuseUnusable(const char* call, const Context* context, VkCommandBuffer commands, Body* const* bodies,
                      uint32_t count, std::initializer_list<gpu::Argument> more) {
    if (!context) context = gpu::contextOf(bodies, count);
    if (const Status s =
            gpu::refuseNull(context, call, {{"commands", !commands}, {"bodies", count && !bodies}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseNull(context, call, more); s != Status::ok) return s;
    return gpu::refuseUnusable(call, "bodies", bodies, count);
}

/// What calls that draw are handed.
Status refuseDraw(const char* call, VkCommandBuffer commands, const Target* target, Body* const* bodies,
                  uint32_t count, const ViewDesc* view, const LightingDesc* lighting) {
    if (const Status s = refuseUnusable(call, target ? target->context : nullptr, commands, bodies, count,
                                        {{"target", !target}, {"view", !view}, {"lighting", !lighting}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed(call, "target", *target); s != Status::ok) return s;
    const gpu::Device& device = target->context->device;
    for (uint32_t i = 0; i < count; ++i)
        if (bodies[i]->context != target->context)
            return device.fail(Status::invalidArgument,
                               "%s: bodies[%u] and the target are of different contexts", call, i);
    const uint32_t mask = target->desc.viewMask;
    if (mask && !(view->viewIndex < maxViews && (mask >> view->viewIndex & 1u)))
        return device.fail(Status::invalidArgument,
                           "%s: ViewDesc.viewIndex is %u, which is none of "
                           "TargetDesc.viewMask",
                           call, view->viewIndex);
    return gpu::refuseOutsideFrame(target->context, call);
}

} // namespace

Status simulate(VkCommandBuffer commands, Body* const* bodies, uint32_t count, double time) {
    if (const Status s = refuseUnusable("simulate", nullptr, commands, bodies, count, {}); s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), "simulate"); s != Status::ok)
        return s;
    return forEach(bodies, count, [&](Body& body) { return body.simulate(commands, time); });
}

Status planarView(Body* body, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&body, 1), "planarView",
                                         {{"body", !body}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("planarView", "body", *body); s != Status::ok) return s;
    if (!body->reflector)
        return body->context->device.fail(Status::invalidArgument,
                                          "planarView: the body's reflection is the sky alone");
    return planarView(body->reflector.get(), view, out);
}

Status recordOverlay(VkCommandBuffer commands, Body* body, const ViewDesc* view, const OverlayDesc* desc) {
    if (const Status s =
            gpu::refuseNull(gpu::contextOf(&body, 1), "recordOverlay",
                            {{"commands", !commands}, {"body", !body}, {"view", !view}, {"desc", !desc}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("recordOverlay", "body", *body); s != Status::ok) return s;
    if (!body->reflector)
        return body->context->device.fail(Status::invalidArgument,
                                          "recordOverlay: the body's reflection is the sky alone");
    return recordOverlay(commands, body->reflector.get(), view, desc);
}

Status bedView(Body* body, const ViewDesc* view, PlanarView* out) {
    if (const Status s = gpu::refuseNull(gpu::contextOf(&body, 1), "bedView",
                                         {{"body", !body}, {"view", !view}, {"out", !out}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseDestroyed("bedView", "body", *body); s != Status::ok) return s;
    return gpu::guarded([&] { return body->bedView(*view, *out); });
}

Status reflect(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view) {
    if (const Status s = refuseUnusable("reflect", nullptr, commands, bodies, count, {{"view", !view}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseOutsideFrame(gpu::contextOf(bodies, count), "reflect"); s != Status::ok)
        return s;
    SceneOfCall scene(*view);
    return forEach(bodies, count, [&](Body& body) { return body.reflect(commands, scene); });
}

Status draw(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
            const ViewDesc* view, const LightingDesc* lighting, SurfaceOutput output) {
    if (const Status s = refuseDraw("draw", commands, target, bodies, count, view, lighting); s != Status::ok)
        return s;
    const auto underwater = [&](UnderwaterPass pass) {
        if (output != SurfaceOutput::shaded) return Status::ok;
        return forEach(bodies, count, [&](Body& body) {
            return body.underwater ? body.drawUnderwater(commands, *target, *view, *lighting, pass)
                                   : Status::ok;
        });
    };
    if (const Status s = underwater(UnderwaterPass::water); s != Status::ok) return s;
    const Status surfaces = forEach(
        bodies, count, [&](Body& body) { return body.draw(commands, *target, *view, *lighting, output); });
    return surfaces == Status::ok ? underwater(UnderwaterPass::waterline) : surfaces;
}

Status drawCaustics(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
                    const ViewDesc* view, const LightingDesc* lighting) {
    if (const Status s = refuseDraw("drawCaustics", commands, target, bodies, count, view, lighting);
        s != Status::ok)
        return s;
    return forEach(bodies, count,
                   [&](Body& body) { return body.drawCaustics(commands, *target, *view, *lighting); });
}

ReflectionImages reflectionImages(const Body* body, uint32_t viewIndex) {
    return body && body->reflector ? body->reflector->images(viewIndex) : ReflectionImages{};
}

const Sea* sea(const Body* body) {
    return body ? body->sea.get() : nullptr;
}

} // namespace seaglass
