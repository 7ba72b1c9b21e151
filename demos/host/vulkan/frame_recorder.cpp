#include "host/vulkan/frame_recorder.h"

#include <cmath>
#include <cstring>

#include "host/passes/fog.h"
#include "host/passes/fog_uniforms.h"
#include "host/seaglass_view.h"
#include "host/water/afloat.h"
#include "host/water/exclusion_volumes.h"
#include "scene/motion/motion.h"

namespace demos {

namespace {

bool isPlanar(const SurfaceDesc& desc) {
    return std::visit(
        [](const auto& surface) {
            return surface.reflection &&
                   surface.reflection->technique == seaglass::ReflectionTechnique::planar;
        },
        desc);
}

bool hasBed(const SurfaceDesc& desc) {
    const auto* const water = std::get_if<WaterDesc>(&desc);
    return water && water->bed && water->bedDrawn;
}

std::vector<seaglass::ExclusionVolume> carriedVolumes(const MeshSet& meshes) {
    std::vector<seaglass::ExclusionVolume> volumes;
    for (const MeshInstance& instance : meshes.instances)
        addCarried(instance.placed.desc, instance.worldFromMesh, volumes);
    return volumes;
}

} // namespace

bool FrameRecorder::create(Device& device, const HostDesc& desc, Error& error) {
    device_ = &device;
    mirror_.create(device, layouts_, desc.framesInFlight);
    return createLayouts(device, layouts_, error) && shadow_.create(device, layouts_, error) &&
           opaque_.create(device, layouts_, error) && water_.create(device, desc, error);
}

bool FrameRecorder::createFrameSet(const Sky& sky, FrameSet& out, Error& error) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 5},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}};
    if (!allocateSet(*device_, layouts_.frame.get(), sizes, out.pool, out.set, error) ||
        !createBuffer(*device_, sizeof(FrameUniforms),
                      VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                      BufferPlace::upload, out.uniforms, error))
        return false;
    writeUniformBuffer(*device_, out.set, out.uniforms.buffer.get(), sizeof(FrameUniforms));
    writeTexture(*device_, out.set, 1, sky.cube.view.get(), sky.cubeSampler.get());
    writeTexture(*device_, out.set, 2, sky.image.view.get(), sky.imageSampler.get());
    writeTexture(*device_, out.set, 3, shadow_.map(), shadow_.sampler());
    writeTexture(*device_, out.set, 4, shadow_.map(), shadow_.sampler());
    return true;
}

bool FrameRecorder::load(const Scene& scene, LoadedScene& out, Error& error) {
    if (!loadSky(*device_, scene.sky, scene.sun, out.sky, error) ||
        !loadMeshes(*device_, layouts_, scene.meshes, scene.water ? scene.water->levelM : 0, out.meshes,
                    error) ||
        !opaque_.prepare(*device_, layouts_, out.meshes, error) ||
        !shadow_.prepare(*device_, layouts_, out.meshes, error) || !createFrameSet(out.sky, out.frame, error))
        return false;
    if (scene.fog && !fogOf(*scene.fog, out.fog.emplace(), error)) return false;
    const std::optional<SurfaceDesc> surface = surfaceOf(scene);
    return !surface || addSurface(*surface, out, error);
}

bool FrameRecorder::move(LoadedScene& scene, double timeS, Error& error) {
    const WaterBody* const water = this->water();
    const bool hasWater = water && *water;
    const WaterAt heights(hasWater ? seaglass::sea(water->get()) : nullptr, timeS);
    if (!placeMeshes(scene.meshes, timeS, heights, error)) return false;
    const std::vector<seaglass::ExclusionVolume> volumes = carriedVolumes(scene.meshes);
    return !hasWater || volumes.empty() || water_.exclude(*water, volumes, error);
}

bool FrameRecorder::createSurface(const WaterDesc& desc, LoadedScene& scene, Error& error) {
    WaterBody body;
    if (!water_.createBody(desc, body, error)) return false;
    BentSun sun;
    const seaglass::Sea* const sea = seaglass::sea(body.get());
    BendingWaves waves;
    if (sea)
        waves = {seaglass::resolvedSlopeVariance(*sea) + seaglass::unresolvedSlopeVariance(*sea),
                 seaglass::significantWaveHeight(*sea)};
    if (!bentSunOf(desc, scene.sky.sun.direction, waves, sun, error)) return false;
    const std::vector<seaglass::ExclusionVolume> volumes = carriedVolumes(scene.meshes);
    if (!volumes.empty() && !water_.exclude(body, volumes, error)) return false;
    WetSand sand;
    if (!sand.create(*device_, sea, error)) return false;
    scene.surfaces.push_back({std::move(body), sun, std::move(sand)});
    return true;
}

bool FrameRecorder::createSurface(const FloorDesc& desc, LoadedScene& scene, Error& error) {
    const MirrorSurface* const first =
        scene.surfaces.empty() ? nullptr : std::get_if<MirrorSurface>(&scene.surfaces.front().body);
    MirrorSurface surface;
    if (!mirror_.createSurface(desc, first, surface, error)) return false;
    scene.surfaces.push_back({std::move(surface), {}, {}});
    return true;
}

bool FrameRecorder::addSurface(const SurfaceDesc& desc, LoadedScene& scene, Error& error) {
    if (!scene.mirrored.set && isPlanar(desc) && !createFrameSet(scene.sky, scene.mirrored, error))
        return false;
    if (!scene.bed.set && hasBed(desc) && !createFrameSet(scene.sky, scene.bed, error)) return false;
    return std::visit([&](const auto& surface) { return createSurface(surface, scene, error); }, desc);
}

bool FrameRecorder::hasSurface(uint32_t index, const LoadedScene& scene, Error& error) {
    if (index < scene.surfaces.size()) return true;
    error.text = "the scene has no surface " + std::to_string(index);
    return false;
}

bool FrameRecorder::estimateReflection(const SurfaceDesc& desc, VkExtent2D extent, uint64_t& bytes,
                                       Error& error) {
    if (const auto* const floor = std::get_if<FloorDesc>(&desc))
        return mirror_.estimateReflection(*floor, extent, bytes, error);
    return water_.estimateReflection(std::get<WaterDesc>(desc), extent, bytes, error);
}

uint64_t FrameRecorder::hostBytes() const {
    uint64_t bytes = 0;
    if (needed(Stage::copy)) bytes += targets_.sceneColor.bytes + targets_.sceneDepth.bytes;
    if (needed(Stage::bed)) bytes += scene_->bed.uniforms.size;
    if (needed(Stage::mirrored)) bytes += scene_->mirrored.uniforms.size;
    return bytes;
}

const WaterBody* FrameRecorder::water() const {
    return std::get_if<WaterBody>(&surface_->body);
}

const MirrorSurface* FrameRecorder::floor() const {
    return std::get_if<MirrorSurface>(&surface_->body);
}

bool FrameRecorder::begin(LoadedScene& scene, const FrameDesc& frame, Error& error) {
    scene_ = &scene;
    frame_ = frame;
    if (!std::isfinite(frame.timeS)) {
        error.text = "the time of a frame must be finite";
        return false;
    }
    if (frame.surface > 0 && !hasSurface(frame.surface, scene, error)) return false;
    static const Surface none;
    surface_ = scene.surfaces.empty() ? &none : &scene.surfaces[frame.surface];
    cpuSimulateMs_ = 0;
    const VkExtent2D extent = {frame.width, frame.height};
    if (extent.width != targets_.extent.width || extent.height != targets_.extent.height) {
        targets_ = {}; // the old ones go first: both may not fit
        bloom_.drop();
        temporal_.drop();
        FrameTargets made;
        if (!createFrameTargets(*device_, extent, made, error)) return false;
        targets_ = std::move(made);
    }
    if (isOverlay(frame.aov) && !needed(Stage::reflect)) {
        error.text = "nothing in the scene mirrors it, and overlays show how it is mirrored";
        return false;
    }
    if (needsExact(frame.aov) && !createExactTarget(*device_, targets_, error)) return false;
    if (isOverlay(frame.aov) && !createOverlayTarget(*device_, targets_, error)) return false;
    if (frame.bloom && !bloom_.fit(*device_, targets_, error)) return false;
    if (!frame.temporal) temporal_.forget();
    if (frame.temporal && !temporal_.fit(*device_, targets_, error)) return false;
    if (!makeCamera(cameraAt(frame.camera, frame.timeS), static_cast<double>(extent.width) / extent.height,
                    camera_, error) ||
        !move(scene, frame.timeS, error))
        return false;
    sight_ = {frame.camera, frame.timeS, camera_.eye, camera_.projection * camera_.rotation};
    camera_.jitterPx = {frame.jitterPx[0], frame.jitterPx[1]};
    camera_.follows = frame.follows;
    const glm::dvec2 moved = 2.0 * camera_.jitterPx / glm::dvec2(extent.width, extent.height);
    // From there clip coordinates are divided by the distance, or by 1.
    glm::dvec4& column = camera_.projection[camera_.parallel() ? 3 : 2];
    column.x = camera_.parallel() ? moved.x : -moved.x;
    column.y = camera_.parallel() ? moved.y : -moved.y;
    camera_.toldProjection = mistaken(camera_.projection, frame.mistake);
    shadowFits_ = fitShadows(worldBounds(scene.meshes), camera_, scene.sky.sun.direction, surface_->sun);
    lighting_ = lightingOf(scene.sky);
    lighting_.fog = scene.fog ? &*scene.fog : nullptr;
    if (sunShadowOf(shadow_, shadowFits_, camera_.eye, sunShadow_)) lighting_.shadow = &sunShadow_;
    writeUniforms();
    return water_.beginFrame(error) && mirror_.beginFrame(error);
}

void FrameRecorder::writeUniforms() {
    uniforms_ = {};
    setClip(camera_.projection * camera_.rotation, uniforms_);
    setSkyUniforms(scene_->sky, frame_.skyDetail, camera_, targets_.extent, uniforms_);
    setShadowUniforms(shadowFits_, uniforms_);
    setBentUniforms(surface_->sun, camera_.eye, uniforms_);
    wetSand();
    if (scene_->fog) {
        const bool hasWater = water() && *water();
        setFogUniforms(*scene_->fog, camera_, hasWater ? &surface_->sun : nullptr, uniforms_);
    }
    std::memcpy(scene_->frame.uniforms.mapped, &uniforms_, sizeof(uniforms_));
}

void FrameRecorder::wetSand() {
    const WetSand& sand = surface_->sand;
    if (sand) sand.set(frame_.timeS, surface_->sun, camera_.eye, uniforms_);
    for (const FrameSet* const drawn : {&scene_->frame, &scene_->mirrored, &scene_->bed}) {
        if (!drawn->set) continue;
        if (sand) {
            sand.write(*device_, drawn->set);
            continue;
        }
        // Without a shore these are there and never read.
        writeTexture(*device_, drawn->set, 5, scene_->sky.image.view.get(), scene_->sky.imageSampler.get());
        writeStorageBuffer(*device_, drawn->set, 6, drawn->uniforms.buffer.get(), sizeof(FrameUniforms));
    }
}

bool FrameRecorder::needed(Stage stage) const {
    if (frame_.aov == Aov::scene) return stage == Stage::shadow || stage == Stage::opaque;
    const WaterBody* const water = this->water();
    const MirrorSurface* const floor = this->floor();
    const bool hasWater = water && *water, overlay = isOverlay(frame_.aov);
    switch (stage) {
    case Stage::simulate:
        return hasWater;
    case Stage::caustics:
        return hasWater && water->parts().caustics;
    case Stage::copy:
        return hasWater || (floor && (overlay || floor->readsScene()));
    case Stage::mirrored:
        return floor ? floor->planar : water->parts().planar;
    case Stage::bed:
        return hasWater && water->parts().bed;
    case Stage::reflect:
        return hasWater || (floor && floor->reflector);
    case Stage::shade:
        return hasWater && !overlay;
    case Stage::overlay:
        return overlay;
    case Stage::lens:
        return frame_.aov == Aov::color && (frame_.bloom || frame_.temporal);
    // Without a surface the other outputs are black.
    case Stage::water:
        return !overlay && (hasWater || (water && frame_.aov != Aov::color && frame_.aov != Aov::depth));
    case Stage::mirror:
        return !overlay && floor;
    default:
        return true;
    }
}

void FrameRecorder::bindFrameSet(VkCommandBuffer commands, const FrameSet& frame) const {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layouts_.pipeline.get(), 0, 1,
                            &frame.set, 0, nullptr);
}

bool FrameRecorder::recordMirrored(VkCommandBuffer commands, Error& error) {
    seaglass::PlanarView view;
    const bool known = floor() ? mirror_.planarView(*floor(), camera_, targets_, view, error)
                               : water_.planarView(*water(), camera_, targets_, view, error);
    if (!known) return false;
    if (view.visible)
        recordAgain(floor() ? mirror_.context() : water_.context(), commands, scene_->mirrored, view);
    return true;
}

bool FrameRecorder::recordBed(VkCommandBuffer commands, Error& error) {
    seaglass::PlanarView view;
    if (!water_.bedView(*water(), camera_, targets_, view, error)) return false;
    if (!view.visible) return true;
    recordAgain(water_.context(), commands, scene_->bed, view);
    return !water()->parts().caustics || water_.drawCaustics(commands, *water(), view, lighting_, error);
}

void FrameRecorder::recordAgain(seaglass::Context* context, VkCommandBuffer commands, const FrameSet& frame,
                                const seaglass::PlanarView& view) {
    const OtherEye eye = otherEye(view);
    const FrameUniforms uniforms = otherUniforms(uniforms_, camera_, eye);
    std::memcpy(frame.uniforms.mapped, &uniforms, sizeof(uniforms));
    bindFrameSet(commands, frame);
    recordSceneAgain(context, commands, layouts_, scene_->meshes, opaque_, eye, view);
}

bool FrameRecorder::recordOverlay(VkCommandBuffer commands, Error& error) {
    targets_.beginOverlay(commands);
    const bool drawn = floor() ? mirror_.overlay(commands, *floor(), camera_, targets_, frame_.aov, error)
                               : water_.overlay(commands, *water(), camera_, targets_, frame_.aov, error);
    targets_.endOverlay(commands);
    return drawn;
}

void FrameRecorder::recordLens(VkCommandBuffer commands) {
    if (frame_.temporal) temporal_.record(commands, targets_, sight_, frame_.follows);
    if (frame_.bloom) bloom_.record(commands, targets_);
}

bool FrameRecorder::record(VkCommandBuffer commands, const StageName& stage, Heard heard, Error& error) {
    PassTimer& passes = device_->passes();
    passes.separate(heard == Heard::timed && stage.compute);
    passes.mark(commands, stage.name, true);
    const bool recorded = recordCommands(commands, stage.stage, error);
    passes.mark(commands, stage.name, false);
    passes.separate(false);
    return recorded;
}

bool FrameRecorder::recordFrame(VkCommandBuffer commands, Heard heard, Error& error) {
    PassTimer& passes = device_->passes();
    passes.mark(commands, frameName, true);
    for (const StageName& stage : stages)
        if (needed(stage.stage) && !record(commands, stage, heard, error)) return false;
    passes.mark(commands, frameName, false);
    return true;
}

bool FrameRecorder::recordCommands(VkCommandBuffer commands, Stage stage, Error& error) {
    switch (stage) {
    case Stage::simulate:
        return water_.simulate(commands, *water(), frame_.timeS, cpuSimulateMs_, error);
    case Stage::shadow:
        bindFrameSet(commands, scene_->frame);
        shadow_.record(commands, layouts_, scene_->meshes, camera_.eye, shadowFits_, surface_->sun);
        return true;
    case Stage::opaque:
        bindFrameSet(commands, scene_->frame);
        opaque_.record(commands, layouts_, scene_->meshes, camera_, targets_);
        return true;
    case Stage::caustics:
        targets_.copyDepth(commands);
        return water_.drawCaustics(commands, *water(), camera_, targets_, lighting_, error);
    case Stage::copy:
        if (!needed(Stage::caustics)) targets_.copyDepth(commands);
        targets_.copyColor(commands);
        return true;
    case Stage::mirrored:
        return recordMirrored(commands, error);
    case Stage::bed:
        return recordBed(commands, error);
    case Stage::reflect:
        if (floor()) return mirror_.reflect(commands, *floor(), camera_, targets_, error);
        return water_.reflect(commands, *water(), camera_, targets_, error);
    case Stage::shade:
        return water_.shade(commands, *water(), camera_, targets_, lighting_, frame_.aov, error);
    case Stage::overlay:
        return recordOverlay(commands, error);
    case Stage::lens:
        recordLens(commands);
        return true;
    case Stage::water:
        if (!needed(Stage::copy)) targets_.betweenPasses(commands);
        return water_.draw(commands, *water(), camera_, targets_, lighting_, frame_.aov, error);
    case Stage::mirror:
        if (!needed(Stage::copy)) targets_.betweenPasses(commands);
        bindFrameSet(commands, scene_->frame);
        return mirror_.draw(commands, *floor(), camera_, targets_, frame_.aov, error);
    }
    return false;
}

} // namespace demos
