#include "host/frame_recorder.h"

#include <cmath>
#include <cstring>

#include "host/seaglass_view.h"

namespace demos {

bool FrameRecorder::create(Device& device, const HostDesc& desc, Error& error) {
    device_ = &device;
    mirror_.create(device, layouts_, desc.framesInFlight, timer_);
    return createLayouts(device, layouts_, error) && shadow_.create(device, layouts_, error) &&
           opaque_.create(device, layouts_, error) && timer_.create(device, error) &&
           water_.create(device, desc, timer_, error);
}

bool FrameRecorder::createFrameSet(const Sky& sky, FrameSet& out, Error& error) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3}};
    if (!allocateSet(*device_, layouts_.frame.get(), sizes, out.pool, out.set, error) ||
        !createBuffer(*device_, sizeof(FrameUniforms), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                      BufferPlace::upload, out.uniforms, error))
        return false;
    writeUniformBuffer(*device_, out.set, out.uniforms.buffer.get(), sizeof(FrameUniforms));
    writeTexture(*device_, out.set, 1, sky.cube.view.get(), sky.cubeSampler.get());
    writeTexture(*device_, out.set, 2, sky.image.view.get(), sky.imageSampler.get());
    writeTexture(*device_, out.set, 3, shadow_.map(), shadow_.sampler());
    return true;
}

bool FrameRecorder::load(const Scene& scene, LoadedScene& out, Error& error) {
    if (!loadSky(*device_, scene.sky, scene.sun, out.sky, error) ||
        !loadMeshes(*device_, layouts_, scene.meshes, out.meshes, error) ||
        !createFrameSet(out.sky, out.frame, error))
        return false;
    out.bounds = worldBounds(out.meshes);
    if (scene.floor) return addFloor(*scene.floor, out, error);
    return !scene.water || addWater(*scene.water, out, error);
}

bool FrameRecorder::addFloor(const FloorDesc& floor, LoadedScene& scene, Error& error) {
    return mirror_.createSurface(floor, scene.mirror, error) &&
           (!scene.mirror.planar || createFrameSet(scene.sky, scene.mirrored, error));
}

bool FrameRecorder::addWater(const WaterDesc& water, LoadedScene& scene, Error& error) {
    WaterBody body;
    if (!water_.createBody(water, body, error)) return false;
    if (body.planar() && !scene.mirrored.set && !createFrameSet(scene.sky, scene.mirrored, error))
        return false;
    scene.waters.push_back(std::move(body));
    return true;
}

const WaterBody& FrameRecorder::water() const {
    static const WaterBody none;
    return scene_->waters.empty() ? none : scene_->waters[frame_.water];
}

bool FrameRecorder::begin(const LoadedScene& scene, const FrameDesc& frame, Error& error) {
    scene_ = &scene;
    frame_ = frame;
    if (!std::isfinite(frame.timeS)) {
        error.text = "the time of a frame must be finite";
        return false;
    }
    if (frame.water > 0 && frame.water >= scene.waters.size()) {
        error.text = "the scene has no water " + std::to_string(frame.water);
        return false;
    }
    const VkExtent2D extent = {frame.width, frame.height};
    if (extent.width != targets_.extent.width || extent.height != targets_.extent.height) {
        targets_ = {}; // the old ones go first: both may not fit
        FrameTargets made;
        if (!createFrameTargets(*device_, extent, made, error)) return false;
        targets_ = std::move(made);
    }
    if (needsExact(frame.aov) && scene.mirror.exists()) {
        error.text = "a floor does not say where its reflection is taken from";
        return false;
    }
    if (isOverlay(frame.aov) && scene.waters.empty() && !scene.mirror.reflector) {
        error.text = "nothing in the scene mirrors it, and overlays show how it is mirrored";
        return false;
    }
    if (needsExact(frame.aov) && !createExactTarget(*device_, targets_, error)) return false;
    if (isOverlay(frame.aov) && !createOverlayTarget(*device_, targets_, error)) return false;
    if (!makeCamera(frame.camera, static_cast<double>(extent.width) / extent.height, camera_, error))
        return false;
    camera_.toldProjection = mistaken(camera_.projection, frame.mistake);
    shadowFits_ = fitShadows(scene.bounds, camera_, scene.sky.sun.direction);
    writeUniforms();
    return water_.beginFrame(error) && mirror_.beginFrame(error);
}

void FrameRecorder::writeUniforms() {
    uniforms_ = {};
    uniforms_.clipFromEye = glm::mat4(camera_.projection * camera_.rotation);
    setSkyUniforms(scene_->sky, camera_, targets_.extent, uniforms_);
    setShadowUniforms(shadowFits_, uniforms_);
    std::memcpy(scene_->frame.uniforms.mapped, &uniforms_, sizeof(uniforms_));
}

bool FrameRecorder::needed(Stage stage) const {
    if (frame_.aov == Aov::scene) return stage == Stage::shadow || stage == Stage::opaque;
    const bool hasWater = static_cast<bool>(water()), hasFloor = scene_->mirror.exists();
    switch (stage) {
    case Stage::simulate:
        return hasWater;
    case Stage::copy:
    case Stage::reflect:
        return hasWater || scene_->mirror.reflector;
    case Stage::mirrored:
        return water().planar() || scene_->mirror.planar;
    case Stage::overlay:
        return isOverlay(frame_.aov);
    // Without a surface the other outputs are black.
    case Stage::water:
        return !isOverlay(frame_.aov) &&
               (hasWater || (!hasFloor && frame_.aov != Aov::color && frame_.aov != Aov::depth));
    case Stage::mirror:
        return !isOverlay(frame_.aov) && hasFloor;
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
    const bool known = scene_->mirror.planar
                           ? mirror_.planarView(scene_->mirror, camera_, targets_, view, error)
                           : water_.planarView(water(), camera_, targets_, view, error);
    if (!known) return false;
    const MirroredEye eye = mirroredEye(view);
    const FrameUniforms uniforms = mirroredUniforms(uniforms_, camera_, eye);
    std::memcpy(scene_->mirrored.uniforms.mapped, &uniforms, sizeof(uniforms));
    bindFrameSet(commands, scene_->mirrored);
    recordMirroredScene(commands, layouts_, scene_->meshes, opaque_, eye, view);
    return true;
}

bool FrameRecorder::recordOverlay(VkCommandBuffer commands, Error& error) {
    targets_.beginOverlay(commands);
    const bool drawn = scene_->mirror.reflector
                           ? mirror_.overlay(commands, scene_->mirror, camera_, targets_, frame_.aov, error)
                           : water_.overlay(commands, water(), camera_, targets_, frame_.aov, error);
    targets_.endOverlay(commands);
    return drawn;
}

bool FrameRecorder::record(VkCommandBuffer commands, Stage stage, Error& error) {
    switch (stage) {
    case Stage::simulate:
        return water_.simulate(commands, water(), frame_.timeS, cpuSimulateMs_, error);
    case Stage::shadow:
        bindFrameSet(commands, scene_->frame);
        shadow_.record(commands, layouts_, scene_->meshes, camera_.eye, shadowFits_);
        return true;
    case Stage::opaque:
        bindFrameSet(commands, scene_->frame);
        opaque_.record(commands, layouts_, scene_->meshes, camera_, targets_);
        return true;
    case Stage::copy:
        targets_.copyScene(commands);
        return true;
    case Stage::mirrored:
        return recordMirrored(commands, error);
    case Stage::reflect:
        if (scene_->mirror.reflector)
            return mirror_.reflect(commands, scene_->mirror, camera_, targets_, error);
        return water_.reflect(commands, water(), camera_, targets_, error);
    case Stage::overlay:
        return recordOverlay(commands, error);
    case Stage::water:
        if (!water()) targets_.betweenPasses(commands);
        return water_.draw(commands, water(), camera_, targets_, scene_->sky, frame_.aov, error);
    case Stage::mirror:
        if (!needed(Stage::copy)) targets_.betweenPasses(commands);
        bindFrameSet(commands, scene_->frame);
        mirror_.draw(commands, scene_->mirror, camera_, targets_, frame_.aov);
        return true;
    }
    return false;
}

} // namespace demos
