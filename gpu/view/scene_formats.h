// Which of a host's images can be read as the scene, and how exactly they tell depth and place.
#pragma once

#include <glm/vec2.hpp>
#include <vulkan/vulkan_core.h>

namespace seaglass {

bool holdsColor(VkFormat format);
bool holdsDepth(VkFormat format);
bool holdsNormals(VkFormat format);
/// Beside a depth.
bool holdsStencil(VkFormat format);

/// What is said of a format that holdsDepth() refuses, behind its name.
constexpr const char* holdsNoDepth =
    " holds no depth that can be read, expected D16_UNORM, X8_D24_UNORM_PACK32 or D32_SFLOAT, with stencil "
    "or without, R16_UNORM or R32_SFLOAT";

/// Whether images, of depth or of colour, are sampled in this layout.
bool sampledIn(VkImageLayout layout, bool depth);

/// Where in a pixel sample 0 lies: the standard locations of Vulkan 1.3, 28.3.
bool hasSamplePlace(VkSampleCountFlagBits samples);
glm::dvec2 samplePlace(VkSampleCountFlagBits samples);

/// Two depths closer than this may be held as one. Of floats, where they are coarsest while still telling
/// things apart: near 1 with forward depth; with reversed depth what is far stands near 0, and nothing is
/// lost.
double depthStep(VkFormat format, bool reversedDepth);

} // namespace seaglass
