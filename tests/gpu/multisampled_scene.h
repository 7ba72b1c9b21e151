// A multisampled scene, each of its samples traced where it lies in its pixel.
#pragma once

#include "host/resources.h"
#include "tests/gpu/traced_scene.h"

namespace tests {

bool canMultisample(VkSampleCountFlagBits samples);

struct MultisampledScene {
    demos::Image color;    ///< RGBA32F; tells where the sample lies
    demos::Image depth;    ///< D32
    demos::Image resolved; ///< the samples' mean colour, RGBA32F
};

MultisampledScene drawMultisampled(const Camera& camera, const std::vector<Box>& boxes,
                                   VkSampleCountFlagBits samples);

} // namespace tests
