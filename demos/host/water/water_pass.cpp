#include "host/water/water_pass.h"

#include <algorithm>
#include <chrono>

#include "host/scene_again.h"
#include "host/seaglass_view.h"
#include "host/vulkan/rendering.h"
#include "host/water/exclusion_volumes.h"
#include "host/water/extent.h"
#include "host/water/shore.h"
#include "host/water/waves.h"

namespace demos {
namespace {

seaglass::RefractionDesc refractionOf(const RefractionDesc& desc) {
    seaglass::RefractionDesc refraction;
    const seaglass::WaterCoefficients water = coefficientsOf(desc);
    std::ranges::copy(water.absorption, refraction.absorption);
    std::ranges::copy(water.backscatter, refraction.backscatter);
    refraction.distortion = static_cast<float>(desc.distortion);
    refraction.scattering = static_cast<float>(desc.scatteringPerM);
    return refraction;
}

seaglass::SurfaceOutput outputOf(Aov aov) {
    switch (aov) {
    case Aov::reflection:
        return seaglass::SurfaceOutput::reflection;
    case Aov::reflectionClass:
        return seaglass::SurfaceOutput::reflectionClass;
    case Aov::height:
        return seaglass::SurfaceOutput::height;
    case Aov::normal:
        return seaglass::SurfaceOutput::normal;
    case Aov::foam:
        return seaglass::SurfaceOutput::foam;
    case Aov::reflectionSource:
        return seaglass::SurfaceOutput::reflectionSource;
    default:
        return seaglass::SurfaceOutput::shaded;
    }
}

} // namespace

WaterPass::~WaterPass() {
    for (seaglass::Target* const target : {target_, exactTarget_})
        if (target) seaglass::destroyTarget(target);
}

bool WaterPass::create(Device& device, const HostDesc& hostDesc, Error& error) {
    wavesBackend_ = hostDesc.wavesBackend ? hostDesc.wavesBackend : wavesBackend();
    if (!context_.create(device, hostDesc.framesInFlight, "water", error)) return false;
    seaglass::TargetDesc target;
    target.colorFormat = FrameTargets::colorFormat;
    target.depthFormat = FrameTargets::depthFormat;
    if (!context_.ok(seaglass::createTarget(context_.get(), &target, &target_), error)) return false;
    target.colorFormat = FrameTargets::exactFormat;
    return context_.ok(seaglass::createTarget(context_.get(), &target, &exactTarget_), error);
}

bool WaterPass::createBody(const WaterDesc& desc, WaterBody& out, Error& error) {
    SceneExtent extent;
    SceneSea sea;
    SceneShore shore;
    seaglass::RefractionDesc refraction;
    seaglass::BodyDesc body;
    const Plane plane = waterPlane(desc);
    std::ranges::copy(plane, body.plane);
    body.mesh = desc.mesh;
    body.shading = desc.shading;
    body.extent.planetRadius = desc.planetRadiusM;
    if (desc.extent) {
        if (!extentOf(*desc.extent, extent, error)) return false;
        body.extent = extent.desc;
    }
    if (desc.waves) {
        if (!seaOf(*desc.waves, sea, error) || !wavesOnOf(*desc.waves, body.wavesOn, error)) return false;
        if (desc.shore && !shoreOf(*desc.shore, plane, shore, error)) return false;
        if (desc.shore) sea.desc.shore = &shore.desc;
        body.waves = &sea.desc;
        body.wavesBackend = wavesBackend_;
    }
    if (desc.foam) body.foam = &*desc.foam;
    if (desc.refraction) {
        refraction = refractionOf(*desc.refraction);
        body.refraction = &refraction;
    }
    if (desc.reflection) body.reflection = &*desc.reflection;
    if (desc.underwater) body.underwater = &*desc.underwater;
    if (desc.caustics) body.caustics = &*desc.caustics;
    if (desc.spray) body.spray = &*desc.spray;
    if (desc.bed && desc.bedDrawn) body.bed = &*desc.bed;
    std::vector<seaglass::ExclusionVolume> volumes;
    if (!exclusionVolumesOf(desc.exclusionVolumes, "water.exclusion_volumes", volumes, error)) return false;
    seaglass::Body* made = nullptr;
    if (!context_.ok(seaglass::createBody(context_.get(), &body, &made), error)) return false;
    const bool planar =
        body.reflection && body.reflection->technique == seaglass::ReflectionTechnique::planar;
    out = WaterBody(made, {planar, body.caustics != nullptr, body.bed != nullptr, std::move(volumes)});
    return exclude(out, {}, error);
}

bool WaterPass::exclude(const WaterBody& body, const std::vector<seaglass::ExclusionVolume>& carried,
                        Error& error) {
    std::vector<seaglass::ExclusionVolume> all = body.parts().volumes;
    all.insert(all.end(), carried.begin(), carried.end());
    return context_.ok(
        seaglass::setExclusionVolumes(body.get(), all.data(), static_cast<uint32_t>(all.size())), error);
}

bool WaterPass::estimateReflection(const WaterDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error) {
    bytes = 0;
    return !desc.reflection || context_.estimate(*desc.reflection, extent, bytes, error);
}

bool WaterPass::simulate(VkCommandBuffer commands, const WaterBody& body, double timeS, double& cpuMs,
                         Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const auto start = std::chrono::steady_clock::now();
    const seaglass::Status status = seaglass::simulate(commands, bodies, 1, timeS);
    cpuMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return context_.ok(status, error);
}

bool WaterPass::planarView(const WaterBody& body, const Camera& camera, const FrameTargets& targets,
                           seaglass::PlanarView& out, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::planarView(body.get(), &view, &out), error);
}

bool WaterPass::bedView(const WaterBody& body, const Camera& camera, const FrameTargets& targets,
                        seaglass::PlanarView& out, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::bedView(body.get(), &view, &out), error);
}

bool WaterPass::reflect(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                        const FrameTargets& targets, Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::reflect(commands, bodies, 1, &view), error);
}

bool WaterPass::shade(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                      const FrameTargets& targets, const seaglass::LightingDesc& lighting, Aov aov,
                      Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::shade(commands, bodies, 1, &view, &lighting, outputOf(aov)), error);
}

bool WaterPass::overlay(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                        const FrameTargets& targets, Aov aov, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    const seaglass::OverlayDesc desc = overlayOf(aov, targets);
    return context_.ok(seaglass::recordOverlay(commands, body.get(), &view, &desc), error);
}

bool WaterPass::drawCaustics(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                             const FrameTargets& targets, const seaglass::LightingDesc& lighting,
                             Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    if (!context_.ok(seaglass::castCaustics(commands, bodies, 1, &view, &lighting), error)) return false;
    beginRendering(commands, targets.extent, &targets.color, VK_ATTACHMENT_LOAD_OP_LOAD, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    const seaglass::Status status = seaglass::drawCaustics(commands, target_, bodies, 1, &view, &lighting);
    vkCmdEndRendering(commands);
    return context_.ok(status, error);
}

bool WaterPass::drawCaustics(VkCommandBuffer commands, const WaterBody& body, const seaglass::PlanarView& bed,
                             const seaglass::LightingDesc& lighting, Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const seaglass::ViewDesc view = viewOf(bed);
    readBedDepth(context_.get(), commands, bed);
    if (!context_.ok(seaglass::castCaustics(commands, bodies, 1, &view, &lighting), error)) return false;
    beginOverBed(commands, bed);
    const seaglass::Status status = seaglass::drawCaustics(commands, target_, bodies, 1, &view, &lighting);
    endOverBed(context_.get(), commands, bed);
    return context_.ok(status, error);
}

bool WaterPass::draw(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                     const FrameTargets& targets, const seaglass::LightingDesc& lighting, Aov aov,
                     Error& error) {
    const bool overScene = aov == Aov::color || aov == Aov::depth;
    const bool exact = needsExact(aov);
    if (exact) targets.exactToAttachment(commands);
    beginRendering(commands, targets.extent, exact ? &targets.exact : &targets.color,
                   overScene ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    seaglass::Status status = seaglass::Status::ok;
    if (body) {
        seaglass::Body* const bodies[] = {body.get()};
        const seaglass::ViewDesc view = viewOf(camera, targets);
        status = seaglass::draw(commands, exact ? exactTarget_ : target_, bodies, 1, &view, &lighting,
                                outputOf(aov));
    }
    vkCmdEndRendering(commands);
    return context_.ok(status, error);
}

} // namespace demos
