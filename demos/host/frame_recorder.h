// A frame of the host as stages that can be recorded into one command buffer or into one each.
#pragma once

#include "host/opaque.h"
#include "host/shadow.h"
#include "host/water_pass.h"

namespace demos {

/// A scene as it lies on the device.
struct LoadedScene {
    Sky sky;
    MeshSet meshes;
    std::vector<Box> bounds;
    UniqueDescriptorPool pool;
    Buffer uniforms;
    VkDescriptorSet frameSet = VK_NULL_HANDLE;
    std::vector<WaterBody> waters; ///< of which a frame draws one
};

enum class Stage { simulate, shadow, opaque, copy, reflect, water };

struct StageName {
    Stage stage;
    const char* name;
    bool compute; ///< its passes can be timed by timestamps
};

constexpr StageName stages[] = {
    {Stage::simulate, "simulate", true},   {Stage::shadow, "host_shadow", false},
    {Stage::opaque, "host_opaque", false}, {Stage::copy, "host_copy", false},
    {Stage::reflect, "reflect", true},     {Stage::water, "water_draw", false},
};

class FrameRecorder {
  public:
    bool create(Device& device, uint32_t framesInFlight, Error& error);
    bool load(const Scene& scene, LoadedScene& out, Error& error);
    bool addWater(const WaterDesc& water, LoadedScene& scene, Error& error);

    /// Checks the frame and readies everything for recording it; the frame before has finished.
    bool begin(const LoadedScene& scene, const FrameDesc& frame, Error& error);
    /// Whether a stage has anything to record.
    bool needed(Stage stage) const;
    bool record(VkCommandBuffer commands, Stage stage, Error& error);

    const FrameTargets& targets() const { return targets_; }
    const Camera& camera() const { return camera_; }
    PassTimer& timer() { return timer_; }
    double cpuSimulateMs() const { return cpuSimulateMs_; }

  private:
    bool createFrameSet(LoadedScene& scene, Error& error);
    void bindFrameSet(VkCommandBuffer commands) const;
    void writeUniforms();
    /// The frame's; one without a body where the scene has none.
    const WaterBody& water() const;

    Device* device_ = nullptr;
    Layouts layouts_;
    ShadowPass shadow_;
    OpaquePass opaque_;
    PassTimer timer_;
    WaterPass water_;
    FrameTargets targets_;

    const LoadedScene* scene_ = nullptr;
    FrameDesc frame_;
    Camera camera_;
    ShadowFits shadowFits_;
    double cpuSimulateMs_ = 0;
};

} // namespace demos
