#include "gpu/view/scene_formats.h"

namespace seaglass {

bool holdsColor(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
    case VK_FORMAT_R32G32B32A32_SFLOAT:
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_SRGB:
    case VK_FORMAT_A8B8G8R8_UNORM_PACK32:
    case VK_FORMAT_A8B8G8R8_SRGB_PACK32:
        return true;
    default:
        return false;
    }
}

bool holdsDepth(VkFormat format) {
    switch (format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
    case VK_FORMAT_R16_UNORM:
    case VK_FORMAT_R32_SFLOAT:
        return true;
    default:
        return false;
    }
}

bool holdsNormals(VkFormat format) {
    return format == VK_FORMAT_R16G16B16A16_SFLOAT || format == VK_FORMAT_R32G32B32A32_SFLOAT ||
           format == VK_FORMAT_R8G8B8A8_SNORM;
}

bool holdsStencil(VkFormat format) {
    return format == VK_FORMAT_D16_UNORM_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT ||
           format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

bool sampledIn(VkImageLayout layout, bool depth) {
    switch (layout) {
    case VK_IMAGE_LAYOUT_GENERAL:
    case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
    case VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL:
        return true;
    case VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL:
    case VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL:
    case VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_STENCIL_ATTACHMENT_OPTIMAL:
        return depth;
    default:
        return false;
    }
}

bool hasSamplePlace(VkSampleCountFlagBits samples) {
    return samples == VK_SAMPLE_COUNT_1_BIT || samples == VK_SAMPLE_COUNT_2_BIT ||
           samples == VK_SAMPLE_COUNT_4_BIT || samples == VK_SAMPLE_COUNT_8_BIT ||
           samples == VK_SAMPLE_COUNT_16_BIT;
}

glm::dvec2 samplePlace(VkSampleCountFlagBits samples) {
    switch (samples) {
    case VK_SAMPLE_COUNT_2_BIT:
        return {0.75, 0.75};
    case VK_SAMPLE_COUNT_4_BIT:
        return {0.375, 0.125};
    case VK_SAMPLE_COUNT_8_BIT:
        return {0.5625, 0.3125};
    case VK_SAMPLE_COUNT_16_BIT:
        return {0.5625, 0.5625};
    default:
        return {0.5, 0.5};
    }
}

double depthStep(VkFormat format, bool reversedDepth) {
    switch (format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_R16_UNORM:
        return 1.0 / 0xffff;
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D24_UNORM_S8_UINT:
        return 1.0 / 0xffffff;
    default:
        return reversedDepth ? 0 : 0x1p-24;
    }
}

} // namespace seaglass
