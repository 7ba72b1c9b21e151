// What a body draws in a view: its surface, and the passes over the view of what lies in the water.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "gpu/view/encoding.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/lighting.h"
#include "water/body/target.h"
#include "water/sea/sea.h"

namespace seaglass {

namespace {

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
    out = gpu::storageBuffer(slice);
    return Status::ok;
}

/// As pixelWidth() of shaders/water/body/body.glsl has it, amid the picture [rad]; of parallel lines
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

bool Body::mayShow(const ViewGeometry& geometry) {
    if (sidesSeen(geometry) != SidesSeen::above) return true;
    const MeshView view = meshView(geometry);
    if (outline) return inSight(view, outline->boxFrom(view.eye));
    selectPatches(view, double{mesh.cellSize}, mesh.cellsPerLevel, patches);
    return !patches.empty();
}

const char* Body::needsScene() const {
    if (underwater) return "BodyDesc.underwater";
    return bed ? "BodyDesc.bed" : nullptr;
}

SurfaceVariant Body::surfaceVariant(const SurfaceDraw& drawn, const LightingDesc& lighting) const {
    const bool motion = drawn.output == SurfaceOutput::motion;
    SurfaceVariant v;
    v.surfaceOutput = static_cast<uint32_t>(drawn.output);
    v.forMotion = motion;
    v.hasWaves = waves.has_value();
    v.hasShore = shore.has_value();
    const SurfaceShape formed = hostMesh  ? SurfaceShape::hostMesh
                                : outline ? SurfaceShape::outlined
                                          : SurfaceShape::plane;
    v.shape = static_cast<uint32_t>(formed);
    v.cascades = waves ? static_cast<int>(cascadeCount(*sea)) : 0;
    v.exclusionVolumes = volumesPacked(exclusionVolumes);
    v.onGlobe = !globe.flat();
    if (motion) return v;
    v.sidesSeen = static_cast<uint32_t>(drawn.sides);
    v.hasFoam = foam.has_value();
    v.foamCascades = foam ? static_cast<int>(foam->cascades()) : 0;
    // Without a scene the water is endlessly deep: its colour is in the uniforms.
    v.hasRefraction = refraction && drawn.seesScene;
    v.sceneIsEncoded = v.hasRefraction && drawn.sceneIsEncoded;
    v.manySamples = v.hasRefraction && drawn.manySamples;
    v.bedDownscale =
        bed && v.hasRefraction && drawn.sides != SidesSeen::below ? static_cast<int>(bed->downscale) : 0;
    v.hasReflection = drawn.reflectionDownscale > 0;
    if (!waves && reflector && reflection.blurLevels == 0)
        v.sharpDownscale = static_cast<int>(drawn.reflectionDownscale);
    v.hasSubsurfaceScattering = waves && refraction && refraction->scattering > 0;
    if (v.hasRefraction || v.hasSubsurfaceScattering)
        v.refractionSamples = static_cast<int>(shading.refractionSamples);
    if (waves) {
        v.reflectionSamples = static_cast<int>(shading.reflectionSamples);
        v.slopeSamples = static_cast<int>(shading.slopeSamples);
        v.waveShadowSteps = static_cast<int>(shading.waveShadowSteps);
        v.hasParallax = !shore && shading.parallax;
    }
    v.bySchlick = shading.fresnel == Fresnel::schlick;
    v.tilted = frame.tilted;
    v.hasSunShadow = lighting.shadow != nullptr;
    v.skyHasColors = lighting.skyCube == VK_NULL_HANDLE;
    v.fogKind = seaglass::fogKind(lighting.fog);
    return v;
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
    view.globe = globe;
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

FieldError Body::readTurned(const ViewDesc& turned, bool seesScene, ViewGeometry& out) const {
    if (const FieldError bad = seesScene ? readView(turned, out) : readCamera(turned, out)) return bad;
    placeEye(out, -plane.w);
    return {};
}

Status Body::readForDraw(const ViewDesc& view, const LightingDesc& lighting, ViewGeometry& out,
                         ViewDesc& read, const char* wanted) {
    const gpu::Device& device = context->device;
    const ViewDesc turned = frame.fromWorld(view);
    const bool seesScene = refraction && hasScene(view);
    if (const FieldError bad = readTurned(turned, seesScene, out))
        return device.fail(Status::invalidArgument, "draw: %s", bad.text());
    if (wanted && !seesScene)
        return device.fail(Status::invalidArgument,
                           "draw: ViewDesc.sceneColor.view and sceneDepth.view are null, and %s reads them",
                           wanted);
    if (const FieldError bad = badField(lighting))
        return device.fail(Status::invalidArgument, "draw: %s", bad.text());
    if (waves && !simulated)
        return device.misused("draw: the body has waves but simulate() was never called");
    recorded.drawn = context->frameNumber;
    if (refraction) tellUnspecified(*context, view.sceneColor);
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
    if (isExcluded(exclusionVolumes, start.middle)) return SidesSeen::above;
    const double height = heightOf(start.middle);
    const double reach = displacement() + start.reach;
    if (height > reach) return SidesSeen::above;
    return height < -reach ? SidesSeen::below : SidesSeen::either;
}

Status Body::drawUnderwater(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                            const LightingDesc& lighting, UnderwaterPass pass) {
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read, needsScene()); s != Status::ok) return s;
    const SidesSeen sides = sidesSeen(geometry);
    const bool straddles = sides == SidesSeen::either;
    const bool wanted =
        pass == UnderwaterPass::water ? sides != SidesSeen::above : straddles && underwater->meniscus > 0;
    if (!wanted) return Status::ok;
    return recordOverView(commands, target, read, lighting, geometry,
                          {.pass = pass,
                           .straddles = straddles,
                           .hasWaves = straddles && waves,
                           .hasShore = straddles && shore,
                           .sceneIsEncoded = pass == UnderwaterPass::water && isEncoded(view.sceneColor)});
}

Status Body::castCaustics(VkCommandBuffer commands, const ViewDesc& view, const LightingDesc& lighting) {
    if (!caustics) return Status::ok;
    if (isMultisampled(view))
        return context->device.fail(
            Status::unsupported,
            "castCaustics: ViewDesc.sceneDepth.samples is not 1: nothing has taken one sample of each yet");
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read, "BodyDesc.caustics"); s != Status::ok)
        return s;
    if (toSun(lighting).y <= 0) return Status::ok;
    CausticInputs inputs;
    inputs.view = &read;
    inputs.shadow = lighting.shadow;
    inputs.region = geometry.regionSize;
    inputs.grid = causticGrid(shading, geometry, heightOf(geometry.eye));
    for (size_t i = 0; i < inputs.waveMaps.size(); ++i) inputs.waveMaps[i] = waves->maps().images[i].view();
    if (const Status s = shoreInputs(false, inputs.shoreMap, inputs.shoreRows); s != Status::ok) return s;
    const BodyBlock uniforms = bodyBlock(*this, geometry, lighting);
    if (const Status s = context->frame().upload(uniforms, inputs.uniforms); s != Status::ok) return s;
    return caustics->record(*context, commands, inputs);
}

Status Body::drawCaustics(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                          const LightingDesc& lighting) {
    if (!caustics) return Status::ok;
    const gpu::Device& device = context->device;
    if (!holdsFloats(target.desc.colorFormat) && target.desc.encoding != Encoding::srgb)
        return device.fail(
            Status::invalidArgument,
            "drawCaustics: TargetDesc.colorFormat holds no floats, and light that is gathered exceeds 1");
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read, "BodyDesc.caustics"); s != Status::ok)
        return s;
    if (toSun(lighting).y <= 0) return Status::ok;
    if (!caustics->lightOf(*context, view.viewIndex, geometry.regionSize))
        return device.misused(
            "drawCaustics: castCaustics() was not called for this view before, or for another since");
    UnderwaterVariant variant = {UnderwaterPass::caustics};
    variant.exclusionVolumes = volumesPacked(exclusionVolumes);
    return recordOverView(commands, target, read, lighting, geometry, variant);
}

Status Body::shoreInputs(bool moves, VkImageView& map, gpu::Resource& rows) {
    if (!shore) return Status::ok;
    map = shore->view();
    if (shoreRows.frame != context->frameNumber || (moves && !shoreRows.moves)) {
        const auto& now = shore->signal().rows;
        const Status s = moves ? upload(*context, shoreRows.rows, now, shore->last().rows)
                               : upload(*context, shoreRows.rows, now);
        if (s != Status::ok) return s;
        shoreRows.frame = context->frameNumber;
        shoreRows.moves = moves;
    }
    rows = shoreRows.rows;
    return Status::ok;
}

Status Body::recordOverView(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                            const LightingDesc& lighting, const ViewGeometry& geometry,
                            const UnderwaterVariant& variant) {
    const BodyBlock uniforms = bodyBlock(*this, geometry, lighting);
    UnderwaterInputs inputs;
    inputs.view = &view;
    if (const Status s = context->frame().upload(uniforms, inputs.uniforms); s != Status::ok) return s;
    if (variant.hasWaves) inputs.waveMap = waves->maps().images[0].view();
    if (variant.pass == UnderwaterPass::caustics)
        inputs.light = caustics->lightOf(*context, view.viewIndex, geometry.regionSize);
    if (variant.hasShore)
        if (const Status s = shoreInputs(false, inputs.shoreMap, inputs.shoreRows); s != Status::ok) return s;
    setViewport(context->device, commands, view, geometry);
    return recordUnderwater(*context, commands, target.underwater, variant, inputs);
}

Status Body::checkEye(const ViewDesc& view, const ViewGeometry& geometry) {
    if (underwater || geometry.parallel) return Status::ok;
    const glm::dvec3& eye = geometry.eye;
    const double depth = -heightOf(eye);
    const bool isOver = !outline || outline->contains({eye.x, eye.z});
    if (depth <= displacement() || !isOver || isExcluded(exclusionVolumes, eye)) return Status::ok;
    // In a camera-to-world matrix the camera stands in the last column, and most often its right is level.
    // The inverse, taken for it, looks rolled and, where it stands over the water, lies under it. Along the x
    // axis a rolled camera would look the same.
    const double(&m)[16] = view.view;
    const glm::dvec3 other = frame.fromWorld(glm::dvec3(m[12], m[13], m[14]));
    const bool isRolled = std::abs(m[4]) > 1e-3;
    const bool otherIsNot = std::abs(m[1]) < 1e-6 && std::abs(m[0]) > 1e-6 && m[5] > 0;
    if (heightOf(other) > 0 && isRolled && otherIsNot)
        return context->device.fail(
            Status::invalidArgument,
            "draw: ViewDesc.view takes the camera to the world, expected world to view: its inverse");
    if (std::exchange(warnedOfEye, true)) return Status::ok;
    context->device.warn(
        "draw: the eye is %.3g m under a body without BodyDesc.underwater, which is made to be "
        "seen from above; is ViewDesc.view world to view, of a world with y up?",
        depth);
    return Status::ok;
}

Status Body::draw(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                  const LightingDesc& lighting, SurfaceOutput output) {
    const gpu::Device& device = context->device;
    ViewGeometry geometry;
    ViewDesc read;
    if (const Status s = readForDraw(view, lighting, geometry, read, needsScene()); s != Status::ok) return s;
    if (const Status s = checkEye(view, geometry); s != Status::ok) return s;
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

    BodyBlock uniforms = bodyBlock(*this, geometry, lighting);
    if (motion) uniforms.relativeFromPixel = lastPixel;
    SurfaceInputs inputs;
    MeshView asMeshed = meshView(geometry);
    asMeshed.farthestFirst = !target.desc.depthWrite;
    if (asMeshed.parallel) uniforms.within.w = static_cast<float>(asMeshed.parallel->distance);
    if (const Status s = place(asMeshed, inputs); s != Status::ok) return s;
    if (inputs.instanceCount == 0) return Status::ok;

    SurfaceDraw drawn = {.output = output,
                         .sides = motion ? SidesSeen::above : sidesSeen(geometry),
                         .seesScene = hasScene(view),
                         .sceneIsEncoded = isEncoded(view.sceneColor),
                         .manySamples = isMultisampled(view)};
    if (reflector && !motion) {
        inputs.reflection = reflectionImages(reflector.get(), view.viewIndex);
        recorded.mirroring[view.viewIndex] = context->frameNumber;
        if (inputs.reflection.color) drawn.reflectionDownscale = inputs.reflection.downscale;
    }
    if (inputs.reflection.bent) uniforms.reflectionDistortion = 0;
    const SurfaceVariant wanted = surfaceVariant(drawn, lighting);
    if (wanted.bedDownscale != 0) {
        inputs.bed = bed->of(*context, view.viewIndex);
        if (!inputs.bed)
            return device.misused("draw: BodyDesc.bed is set, and bedView() and reflect() were not called "
                                  "for this view before");
        setBed(uniforms, *inputs.bed, geometry.eye);
    }
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = target.pipelines.get(wanted, pipeline); s != Status::ok) return s;
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
    return recordSurface(*context, commands, *pipeline, inputs);
}

} // namespace seaglass
