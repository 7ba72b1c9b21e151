// What a host draws for Seaglass, as pixels from the CPU.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "host/vulkan/resources.h"
#include "seaglass/reflection.h"

namespace tests {

struct Drawn {
    std::vector<float> depth;
    std::vector<uint64_t> color; ///< RGBA16F
};

glm::dmat4 matrix(const double (&values)[16]);

/// In buffers, until the frame that draws them has finished.
struct DrawnBuffers {
    explicit DrawnBuffers(const Drawn& drawn);
    demos::Buffer color, depth;
};

/// Fills the view's images and leaves them as a host leaves its attachments.
void recordDrawing(VkCommandBuffer commands, const seaglass::PlanarView& view, const DrawnBuffers& drawn);

/// Begins rendering to the view's images, which it clears.
void beginDrawing(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view);

} // namespace tests
