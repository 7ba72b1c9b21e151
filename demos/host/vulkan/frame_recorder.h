// A frame of the host as stages that can be recorded into one command buffer or into one each.
#pragma once

#include <variant>

#include "host/lens/bloom.h"
#include "host/lens/temporal.h"
#include "host/passes/mirror_pass.h"
#include "host/passes/opaque.h"
#include "host/passes/shadow.h"
#include "host/scene_again.h"
#include "host/water/water_pass.h"
#include "host/water/wet_sand.h"
#include "scene/scene.h"

namespace demos {

/// Set 0 of one of the host's views.
struct FrameSet {
    UniqueDescriptorPool pool;
    Buffer uniforms;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

/// What mirrors, and what it makes of the sun.
struct Surface {
    std::variant<WaterBody, MirrorSurface> body;
    BentSun sun;
    WetSand sand;
};

/// A scene as it lies on the device.
struct LoadedScene {
    Sky sky;
    std::optional<seaglass::FogDesc> fog;
    MeshSet meshes;
    FrameSet frame;
    FrameSet mirrored;             ///< only where a reflection is planar
    FrameSet bed;                  ///< only where a water has one
    std::vector<Surface> surfaces; ///< of which a frame draws one
};

enum class Stage {
    simulate,
    shadow,
    opaque,
    caustics,
    copy,
    mirrored,
    bed,
    reflect,
    shade,
    water,
    mirror,
    overlay,
    lens
};

struct StageName {
    Stage stage;
    const char* name;
    bool compute; ///< it is in no rendering, so that its passes can be timed on any device
};

constexpr StageName stages[] = {
    {Stage::simulate, "simulate", true},   {Stage::shadow, "host_shadow", false},
    {Stage::opaque, "host_opaque", false}, {Stage::caustics, "caustics", false},
    {Stage::copy, "host_copy", false},     {Stage::mirrored, "host_mirrored", false},
    {Stage::bed, "host_bed", false},       {Stage::reflect, "reflect", true},
    {Stage::shade, "water_shade", false},  {Stage::water, "water_draw", false},
    {Stage::mirror, "mirror_draw", false}, {Stage::overlay, "overlay", true},
    {Stage::lens, "host_lens", false},
};

constexpr const char* nameOf(Stage stage) {
    for (const StageName& named : stages)
        if (named.stage == stage) return named.name;
    return "";
}

/// The pass around all stages of a frame.
constexpr const char* frameName = "frame";

/// How passes are marked: such that those of compute stages can be timed on a device that takes timestamps
/// late, or without anything of a frame being changed.
enum class Heard { timed, always };

class FrameRecorder {
  public:
    bool create(Device& device, const HostDesc& desc, Error& error);
    bool load(const Scene& scene, LoadedScene& out, Error& error);
    bool addSurface(const SurfaceDesc& desc, LoadedScene& scene, Error& error);
    /// False with `error` set where the scene has no such surface.
    static bool hasSurface(uint32_t index, const LoadedScene& scene, Error& error);
    /// What the library says that a surface's reflection holds for one view of this size.
    bool estimateReflection(const SurfaceDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error);

    /// Checks the frame, moves what moves to where it is then, and readies everything for recording it; the
    /// frame before has finished.
    bool begin(LoadedScene& scene, const FrameDesc& frame, Error& error);
    /// Whether a stage has anything to record.
    bool needed(Stage stage) const;
    /// As a pass by its name, around those of the library.
    bool record(VkCommandBuffer commands, const StageName& stage, Heard heard, Error& error);
    /// All stages that are needed.
    bool recordFrame(VkCommandBuffer commands, Heard heard, Error& error);

    /// What the host itself holds on the device for the frame's surface to mirror the scene.
    uint64_t hostBytes() const;

    const FrameTargets& targets() const { return targets_; }
    const Camera& camera() const { return camera_; }
    double cpuSimulateMs() const { return cpuSimulateMs_; }

  private:
    bool createFrameSet(const Sky& sky, FrameSet& out, Error& error);
    void bindFrameSet(VkCommandBuffer commands, const FrameSet& frame) const;
    /// To where things are at a time, on the frame's surface.
    bool move(LoadedScene& scene, double timeS, Error& error);
    void writeUniforms();
    void wetSand();
    bool createSurface(const WaterDesc& desc, LoadedScene& scene, Error& error);
    bool createSurface(const FloorDesc& desc, LoadedScene& scene, Error& error);
    /// With a frame set of its own.
    void recordAgain(seaglass::Context* context, VkCommandBuffer commands, const FrameSet& frame,
                     const seaglass::PlanarView& view);
    bool recordMirrored(VkCommandBuffer commands, Error& error);
    bool recordBed(VkCommandBuffer commands, Error& error);
    bool recordCommands(VkCommandBuffer commands, Stage stage, Error& error);
    bool recordOverlay(VkCommandBuffer commands, Error& error);
    void recordLens(VkCommandBuffer commands);
    /// The frame's, or null; a water without a body where the scene has no surface.
    const WaterBody* water() const;
    const MirrorSurface* floor() const;

    Device* device_ = nullptr;
    Layouts layouts_;
    ShadowPass shadow_;
    OpaquePass opaque_;
    WaterPass water_;
    MirrorPass mirror_;
    FrameTargets targets_;
    Bloom bloom_;
    Temporal temporal_;

    const LoadedScene* scene_ = nullptr;
    const Surface* surface_ = nullptr;
    FrameDesc frame_;
    Camera camera_;
    Sight sight_;
    ShadowFits shadowFits_;
    seaglass::SunShadow sunShadow_;
    seaglass::LightingDesc lighting_;
    FrameUniforms uniforms_;
    double cpuSimulateMs_ = 0;
};

} // namespace demos
