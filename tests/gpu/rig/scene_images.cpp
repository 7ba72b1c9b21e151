#include "tests/gpu/rig/scene_images.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec4.hpp>

#include "tests/gpu/rig/rig.h"

namespace tests {

namespace {

using Bytes = std::vector<std::byte>;

template<typename T>
void append(Bytes& bytes, T value) {
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
}

uint32_t unorm(float value, uint32_t most) {
    return static_cast<uint32_t>(std::lround(std::clamp(double{value}, 0.0, 1.0) * most));
}

void appendDepth(VkFormat format, float depth, Bytes& bytes) {
    switch (format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_R16_UNORM:
        return append(bytes, static_cast<uint16_t>(unorm(depth, 0xffff)));
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D24_UNORM_S8_UINT:
        return append(bytes, unorm(depth, 0xffffff));
    default:
        return append(bytes, depth);
    }
}

bool isSrgb(VkFormat format) {
    return format == VK_FORMAT_R8G8B8A8_SRGB || format == VK_FORMAT_B8G8R8A8_SRGB;
}

void appendColor(VkFormat format, glm::vec4 rgba, Bytes& bytes) {
    if (isSrgb(format)) rgba = glm::convertLinearToSRGB(rgba);
    switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return append(bytes, glm::packHalf4x16(rgba));
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
        return append(bytes, glm::packF2x11_1x10(glm::vec3(rgba)));
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_SRGB:
        std::swap(rgba.r, rgba.b);
        [[fallthrough]];
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB:
        return append(bytes, glm::packUnorm<uint8_t>(rgba));
    default:
        return append(bytes, rgba);
    }
}

demos::Image upload(VkFormat format, VkExtent2D extent, const Bytes& bytes, VkImageUsageFlags usage = 0) {
    demos::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.usage = usage;
    const std::span<const std::byte> level = bytes;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device(), desc, {&level, 1}, image, error)) << error.text;
    return image;
}

} // namespace

bool canSample(VkFormat format) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device().physical(), format, &properties);
    constexpr VkFormatFeatureFlags needed =
        VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
    return (properties.optimalTilingFeatures & needed) == needed;
}

demos::Image uploadDepth(VkFormat format, VkExtent2D extent, const std::vector<float>& depth,
                         VkImageUsageFlags usage) {
    Bytes bytes;
    for (const float value : depth) appendDepth(format, value, bytes);
    return upload(format, extent, bytes, usage);
}

demos::Image uploadColor(VkFormat format, VkExtent2D extent, const std::vector<float>& rgba) {
    Bytes bytes;
    for (size_t i = 0; i < rgba.size(); i += 4)
        appendColor(format, {rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]}, bytes);
    return upload(format, extent, bytes);
}

float colorError(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return 0x1p-11f;
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
        return 0x1p-6f; // ten bits of blue keep five of the mantissa, and packing may cut instead of round
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_UNORM:
        // Vulkan prefers the nearest of the two values around, and takes either.
        return static_cast<float>(limitOnDriver(0.5, 1)) / 255;
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_B8G8R8A8_SRGB:
        return 2.3f * 0.5f / 255; // the curve is steepest at white
    default:
        return 0;
    }
}

} // namespace tests
