// Shadow maps of the sun: cascades of growing reach, each fitted to what is opaque and in view.
#pragma once

#include <array>

#include "host/camera.h"
#include "host/mesh.h"

namespace demos {

/// Where a shadow map lies. Disabled when nothing there can be in shadow.
struct ShadowFit {
    bool enabled = false;
    glm::mat4 clipFromEye{
        1}; ///< eye-relative metres to the map's clip space, depth growing away from the sun
    double texelM = 0;
};

using ShadowFits = std::array<ShadowFit, shadowCascades>;

ShadowFits fitShadows(const std::vector<Box>& boxes, const Camera& camera, const glm::dvec3& toSun,
                      const BentSun& bent);

class ShadowPass {
  public:
    static constexpr uint32_t cascadeSize = 2048;

    bool create(const Device& device, const Layouts& layouts, Error& error);
    /// Makes what the materials of a scene want.
    bool prepare(const Device& device, const Layouts& layouts, const MeshSet& meshes, Error& error);
    VkImageView map() const { return map_.view.get(); }
    /// The same, as an array of one layer.
    VkImageView mapAsArray() const { return arrayView_.get(); }
    VkFormat format() const { return map_.format; }
    VkExtent2D extent() const { return map_.extent; }
    VkSampler sampler() const { return sampler_.get(); }
    /// Leaves the map readable by fragment shaders. Needs set 0 bound.
    void record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                const glm::dvec3& eye, const ShadowFits& fits, const BentSun& bent) const;

  private:
    Image map_;
    UniqueImageView arrayView_;
    UniqueSampler sampler_;
    FeaturePipelines pipelines_{maskedFeature | ditheredFeature, {}};
    UniquePipeline cut_;
};

void setShadowUniforms(const ShadowFits& fits, FrameUniforms& uniforms);

} // namespace demos
