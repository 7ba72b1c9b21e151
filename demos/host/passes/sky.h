// The sky and the sun on the device, and the background they make.
#pragma once

#include "host/camera.h"
#include "host/vulkan/layouts.h"
#include "host/water/sun.h"

namespace demos {

struct Sky {
    Image cube;
    Image image; ///< lat-long, for a background as sharp as the file
    UniqueSampler cubeSampler, imageSampler;
    std::array<glm::vec3, 9> irradianceSh{};
    glm::vec3 irradianceUp{0};
    double rotationDeg = 0, intensity = 1, detail = 0;
    Sun sun;
};

bool loadSky(Device& device, const SkyDesc& sky, const SunDesc& sun, Sky& out, Error& error);

/// Fills in what the shaders need of sky, sun and camera. `detailed`: FrameDesc::skyDetail.
void setSkyUniforms(const Sky& sky, bool detailed, const Camera& camera, VkExtent2D extent,
                    FrameUniforms& uniforms);

class SkyPass {
  public:
    bool create(const Device& device, const Layouts& layouts, VkFormat color, VkFormat depth, Error& error);
    /// Inside the opaque pass, after it, with set 0 bound.
    void draw(VkCommandBuffer commands) const;

  private:
    UniquePipeline pipeline_;
};

} // namespace demos
