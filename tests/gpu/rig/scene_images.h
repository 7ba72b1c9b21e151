// The scene's colour and depth in whatever format a host may have them.
#pragma once

#include <vector>

#include "host/vulkan/resources.h"

namespace tests {

/// Whether the device can sample such images, made as the host here makes them.
bool canSample(VkFormat format);

/// Of one float a pixel, rounded as rasterisers round. Sampled in SHADER_READ_ONLY_OPTIMAL.
demos::Image uploadDepth(VkFormat format, VkExtent2D extent, const std::vector<float>& depth,
                         VkImageUsageFlags usage = 0);

/// Of four floats a pixel, linear.
demos::Image uploadColor(VkFormat format, VkExtent2D extent, const std::vector<float>& rgba);

/// The most that a linear value in 0..1 is off in this format.
float colorError(VkFormat format);

} // namespace tests
