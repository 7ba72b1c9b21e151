// The sand of a scene that waves wet: what its material's shader reads of the shore.
#pragma once

#include <vector>

#include "host/vulkan/layouts.h"
#include "host/water/bent_sun.h"
#include "seaglass/sea.h"

namespace demos {

class WetSand {
  public:
    /// Nothing of a sea without a shore, or of none.
    bool create(Device& device, const seaglass::Sea* sea, Error& error);
    explicit operator bool() const { return sea_ != nullptr; }
    /// At a time, of the plane that `sun` knows; the frame before has finished.
    void set(double timeS, const BentSun& sun, const glm::dvec3& eye, FrameUniforms& uniforms) const;
    /// Into set 0.
    void write(const Device& device, VkDescriptorSet frame) const;

  private:
    const seaglass::Sea* sea_ = nullptr;
    Image map_;
    UniqueSampler sampler_;
    Buffer rows_;
};

/// For another eye, `step` from the one that they are of.
void moveShoreUniforms(const glm::dvec3& step, FrameUniforms& uniforms);

} // namespace demos
