// A multisampled scene, each of its samples traced where it lies in its pixel.
#pragma once

#include "host/vulkan/resources.h"
#include "tests/gpu/rig/traced_scene.h"

namespace tests {

bool canMultisample(VkSampleCountFlagBits samples);

struct MultisampledScene {
    demos::Image color;           ///< RGBA32F; tells where the sample lies
    demos::Image depth;           ///< D32
    demos::Image resolved;        ///< the samples' mean colour, RGBA32F
    std::vector<uint32_t> things; ///< of each pixel's samples, how many show anything
};

/// In place of places.
struct Radiances {
    float things = 1, nothing = 0;
};

MultisampledScene drawMultisampled(const Camera& camera, const std::vector<Box>& boxes,
                                   VkSampleCountFlagBits samples, const Radiances* radiances = nullptr);

} // namespace tests
