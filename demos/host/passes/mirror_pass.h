// The host's polished floor: everything it does with seaglass::reflection, which is all of Seaglass it needs.
#pragma once

#include <map>

#include "host/seaglass_context.h"
#include "host/vulkan/frame_targets.h"
#include "host/vulkan/layouts.h"
#include "host/water/floor_plane.h"

namespace demos {

struct ReflectorDeleter {
    void operator()(seaglass::Reflector* reflector) const { seaglass::destroyReflector(reflector); }
};

/// As in shaders/mirror.glsl.
struct MirrorBlock {
    glm::vec4 middle;  ///< relative to the eye; w: reflectance
    glm::vec4 across;  ///< half the width; w: repeats of the texture in that
    glm::vec4 along;   ///< half the length; w: repeats of the texture in that
    glm::vec4 normal;  ///< w: roughness
    glm::vec4 color;   ///< w: pixels a radian at the middle of the picture
    glm::vec4 picture; ///< its width and height [pixels], pixels to one of its reflection
    glm::vec4 blur;    ///< clear distance [m], scatter, distance at which the sky has taken over [m]
};

struct FloorTexture {
    Image image;
    UniqueSampler sampler;
};

/// A scene's floor on the device. Destroy it before the MirrorPass it comes from.
struct MirrorSurface {
    FloorPlane plane;
    FloorDesc desc;
    std::shared_ptr<const FloorTexture> texture; ///< of all floors that look alike
    UniqueSampler reflectionSampler;
    Buffer uniforms;
    UniqueDescriptorPool pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::unique_ptr<seaglass::Reflector, ReflectorDeleter> reflector; ///< null when only the sky is mirrored
    bool planar = false; ///< whether the scene has to be drawn for it a second time

    /// Whether the reflection is made of the picture itself.
    bool readsScene() const { return reflector && !planar; }
};

class MirrorPass {
  public:
    MirrorPass() = default;
    MirrorPass(const MirrorPass&) = delete;
    MirrorPass& operator=(const MirrorPass&) = delete;

    /// Nothing is made before the first floor is.
    void create(Device& device, const Layouts& layouts, uint32_t framesInFlight);
    /// `alike` may have the texture already, or be null.
    bool createSurface(const FloorDesc& desc, const MirrorSurface* alike, MirrorSurface& out, Error& error);

    /// What the library says that a floor's reflection holds for one view of this size.
    bool estimateReflection(const FloorDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error);

    seaglass::Context* context() const { return context_.get(); }
    bool beginFrame(Error& error) { return !context_.exists() || context_.beginFrame(error); }
    /// What to draw for a planar reflection, before reflect().
    bool planarView(const MirrorSurface& surface, const Camera& camera, const FrameTargets& targets,
                    seaglass::PlanarView& out, Error& error);
    bool reflect(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                 const FrameTargets& targets, Error& error);
    /// Draws into targets.overlay how the library understands the frame, after reflect().
    bool overlay(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                 const FrameTargets& targets, Aov aov, Error& error);
    /// Draws into targets.color, or exact, and targets.depth over the opaque scene; for anything but colour,
    /// over black.
    /// Needs set 0 bound.
    bool draw(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
              const FrameTargets& targets, Aov aov, Error& error);

  private:
    bool createOnce(Error& error);
    bool createLayout(Error& error);
    bool createReflector(MirrorSurface& out, Error& error);
    bool createSet(MirrorSurface& surface, Error& error) const;
    /// Made when it is first asked for; null on an error.
    VkPipeline pipelineOf(const MirrorSurface& surface, Aov aov, Error& error);
    void writeUniforms(const MirrorSurface& surface, const Camera& camera, VkExtent2D extent) const;

    Device* device_ = nullptr;
    const Layouts* layouts_ = nullptr;
    SeaglassContext context_;
    UniqueDescriptorSetLayout setLayout_;
    UniquePipelineLayout layout_;
    std::map<std::pair<Aov, bool>, UniquePipeline>
        pipelines_; ///< by output and whether the scene is mirrored
    uint32_t framesInFlight_ = 1;
};

} // namespace demos
