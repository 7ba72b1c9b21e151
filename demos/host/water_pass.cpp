#include "host/water_pass.h"

#include <chrono>

#include "host/rendering.h"
#include "host/seaglass_view.h"
#include "host/waves.h"

namespace demos {
namespace {

seaglass::RefractionDesc refractionOf(const RefractionDesc& desc) {
    seaglass::RefractionDesc refraction;
    for (size_t i = 0; i < 3; ++i) {
        refraction.absorption[i] = static_cast<float>(desc.absorptionPerM[i]);
        refraction.backscatter[i] = static_cast<float>(desc.backscatterPerM[i]);
    }
    refraction.distortion = static_cast<float>(desc.distortion);
    return refraction;
}

seaglass::LightingDesc lightingOf(const Sky& sky) {
    seaglass::LightingDesc lighting;
    for (int i = 0; i < 3; ++i) {
        lighting.toSun[i] = sky.sun.direction[i];
        lighting.sunIrradiance[i] = static_cast<float>(sky.sun.irradiance[i]);
        lighting.skyIrradiance[i] = sky.irradianceUp[i];
    }
    lighting.skyCube = sky.cube.view.get();
    lighting.skyCubeMipLevels = sky.cube.mips;
    return lighting;
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
    if (context_) seaglass::destroyContext(context_);
}

bool WaterPass::ok(seaglass::Status status, const char* what, Error& error) {
    if (status == seaglass::Status::ok) return true;
    error.text = std::string(what) + ": " + (message_.empty() ? seaglass::toString(status) : message_);
    message_.clear();
    return false;
}

bool WaterPass::create(const Device& device, const HostDesc& hostDesc, PassTimer& timer, Error& error) {
    framesInFlight_ = hostDesc.framesInFlight;
    wavesBackend_ = hostDesc.wavesBackend ? hostDesc.wavesBackend : wavesBackend();
    seaglass::DeviceDesc desc;
    desc.instance = device.instance();
    desc.physicalDevice = device.physical();
    desc.device = device.handle();
    desc.getInstanceProcAddr = vkGetInstanceProcAddr;
    desc.framesInFlight = framesInFlight_;
    desc.message.user = &message_;
    desc.message.function = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
    desc.pass.user = &timer;
    desc.pass.function = [](void* user, VkCommandBuffer commands, const char* pass, bool begins) {
        static_cast<PassTimer*>(user)->mark(commands, pass, begins);
    };
    if (!ok(seaglass::createContext(&desc, &context_), "water", error)) return false;
    seaglass::TargetDesc target;
    target.colorFormat = FrameTargets::colorFormat;
    target.depthFormat = FrameTargets::depthFormat;
    if (!ok(seaglass::createTarget(context_, &target, &target_), "water", error)) return false;
    target.colorFormat = FrameTargets::exactFormat;
    return ok(seaglass::createTarget(context_, &target, &exactTarget_), "water", error);
}

bool WaterPass::createBody(const WaterDesc& desc, WaterBody& out, Error& error) {
    seaglass::SeaDesc sea;
    seaglass::FoamDesc foam;
    seaglass::RefractionDesc refraction;
    seaglass::ReflectionDesc reflection;
    seaglass::BodyDesc body;
    body.plane[3] = -desc.levelM;
    body.mesh.cellSize = static_cast<float>(desc.cellM);
    body.mesh.cellsPerLevel = desc.cellsPerLevel;
    if (desc.waves) {
        if (!seaOf(*desc.waves, sea, error)) return false;
        body.waves = &sea;
        body.wavesBackend = wavesBackend_;
    }
    if (desc.foam) {
        foam.threshold = static_cast<float>(desc.foam->threshold);
        foam.albedo = static_cast<float>(desc.foam->albedo);
        body.foam = &foam;
    }
    if (desc.refraction) {
        refraction = refractionOf(*desc.refraction);
        body.refraction = &refraction;
    }
    if (desc.reflection) {
        if (!reflectionOf(*desc.reflection, "water", reflection, error)) return false;
        body.reflection = &reflection;
    }
    seaglass::Body* made = nullptr;
    if (!ok(seaglass::createBody(context_, &body, &made), "water", error)) return false;
    out = WaterBody(made, body.reflection && reflection.technique == seaglass::ReflectionTechnique::planar);
    return true;
}

bool WaterPass::estimateReflection(const WaterDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error) {
    bytes = 0;
    if (!desc.reflection) return true;
    seaglass::ReflectionDesc reflection;
    seaglass::Estimate estimate;
    if (!reflectionOf(*desc.reflection, "water", reflection, error) ||
        !ok(seaglass::estimate(context_, &reflection, extent, &estimate), "water", error))
        return false;
    bytes = estimate.bytes + estimate.bytesPerView;
    return true;
}

bool WaterPass::beginFrame(Error& error) {
    slot_ = (slot_ + 1) % framesInFlight_;
    return ok(seaglass::beginFrame(context_, slot_), "water", error);
}

bool WaterPass::simulate(VkCommandBuffer commands, const WaterBody& body, double timeS, double& cpuMs,
                         Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const auto start = std::chrono::steady_clock::now();
    const seaglass::Status status = seaglass::simulate(commands, bodies, 1, timeS);
    cpuMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return ok(status, "water", error);
}

bool WaterPass::planarView(const WaterBody& body, const Camera& camera, const FrameTargets& targets,
                           seaglass::PlanarView& out, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return ok(seaglass::planarView(body.get(), &view, &out), "water", error);
}

bool WaterPass::reflect(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                        const FrameTargets& targets, Error& error) {
    seaglass::Body* const bodies[] = {body.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return ok(seaglass::reflect(commands, bodies, 1, &view), "water", error);
}

bool WaterPass::overlay(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                        const FrameTargets& targets, Aov aov, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    const seaglass::OverlayDesc desc = overlayOf(aov, targets);
    return ok(seaglass::recordOverlay(commands, body.get(), &view, &desc), "water", error);
}

bool WaterPass::draw(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                     const FrameTargets& targets, const Sky& sky, Aov aov, Error& error) {
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
        const seaglass::LightingDesc lighting = lightingOf(sky);
        status = seaglass::draw(commands, exact ? exactTarget_ : target_, bodies, 1, &view, &lighting,
                                outputOf(aov));
    }
    vkCmdEndRendering(commands);
    return ok(status, "water", error);
}

} // namespace demos
