// The host's water: everything it does with Seaglass, through the public headers alone.
#pragma once

#include "host/camera.h"
#include "host/seaglass_context.h"
#include "host/vulkan/frame_targets.h"
#include "scene/scene.h"
#include "seaglass/water.h"

namespace demos {

/// What the host has to do for a water besides drawing it.
struct WaterParts {
    bool planar = false; ///< to draw what it mirrors
    bool caustics = false;
    bool bed = false;                               ///< to draw what lies below it
    std::vector<seaglass::ExclusionVolume> volumes; ///< that stay where they are
};

/// One water body of a scene. Destroy it before the WaterPass it comes from.
class WaterBody {
  public:
    WaterBody() = default;
    WaterBody(seaglass::Body* body, WaterParts parts) : body_(body), parts_(std::move(parts)) {}
    WaterBody(WaterBody&& other) noexcept
        : body_(std::exchange(other.body_, nullptr)), parts_(std::move(other.parts_)) {}
    WaterBody& operator=(WaterBody&& other) noexcept {
        std::swap(body_, other.body_);
        std::swap(parts_, other.parts_);
        return *this;
    }
    ~WaterBody() {
        if (body_) seaglass::destroyBody(body_);
    }
    seaglass::Body* get() const { return body_; }
    explicit operator bool() const { return body_ != nullptr; }
    const WaterParts& parts() const { return parts_; }

  private:
    seaglass::Body* body_ = nullptr;
    WaterParts parts_;
};

class WaterPass {
  public:
    WaterPass() = default;
    WaterPass(const WaterPass&) = delete;
    WaterPass& operator=(const WaterPass&) = delete;
    ~WaterPass();

    bool create(Device& device, const HostDesc& desc, Error& error);
    bool createBody(const WaterDesc& desc, WaterBody& out, Error& error);

    /// What the library says that a water's reflection holds for one view of this size.
    bool estimateReflection(const WaterDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error);

    /// Keeps it out of those that meshes carry along, too.
    bool exclude(const WaterBody& body, const std::vector<seaglass::ExclusionVolume>& carried, Error& error);

    seaglass::Context* context() const { return context_.get(); }
    bool beginFrame(Error& error) { return context_.beginFrame(error); }
    /// Milliseconds on the CPU go to `cpuMs`.
    bool simulate(VkCommandBuffer commands, const WaterBody& body, double timeS, double& cpuMs, Error& error);
    /// What to draw for a planar reflection, before reflect().
    bool planarView(const WaterBody& body, const Camera& camera, const FrameTargets& targets,
                    seaglass::PlanarView& out, Error& error);
    /// What to draw for its refraction, before reflect().
    bool bedView(const WaterBody& body, const Camera& camera, const FrameTargets& targets,
                 seaglass::PlanarView& out, Error& error);
    bool reflect(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                 const FrameTargets& targets, Error& error);
    /// Before draw() of the same, after reflect().
    bool shade(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
               const FrameTargets& targets, const seaglass::LightingDesc& lighting, Aov aov, Error& error);
    /// Draws into targets.overlay how the library understands the frame, after reflect().
    bool overlay(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                 const FrameTargets& targets, Aov aov, Error& error);
    /// Over targets.color, with the scene's depth copied before.
    bool drawCaustics(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
                      const FrameTargets& targets, const seaglass::LightingDesc& lighting, Error& error);
    /// Over the bed's picture, drawn before.
    bool drawCaustics(VkCommandBuffer commands, const WaterBody& body, const seaglass::PlanarView& bed,
                      const seaglass::LightingDesc& lighting, Error& error);
    /// Draws into targets.color, or exact, over the opaque depth; for anything but colour, over black.
    bool draw(VkCommandBuffer commands, const WaterBody& body, const Camera& camera,
              const FrameTargets& targets, const seaglass::LightingDesc& lighting, Aov aov, Error& error);

  private:
    SeaglassContext context_;
    seaglass::Target* target_ = nullptr;
    const seaglass::WavesBackend* wavesBackend_ = nullptr;
    seaglass::Target* exactTarget_ = nullptr;
};

} // namespace demos
