#include "gpu/view/encoding.h"

#include <utility>

namespace seaglass {

bool appliesSrgb(VkFormat format) {
    return format == VK_FORMAT_R8G8B8A8_SRGB || format == VK_FORMAT_B8G8R8A8_SRGB ||
           format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

bool isDisplayFormat(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_A8B8G8R8_UNORM_PACK32:
    case VK_FORMAT_A2R10G10B10_UNORM_PACK32:
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32:
        return true;
    default:
        return false;
    }
}

void tellUnspecified(Context& context, const Image& sceneColor) {
    if (sceneColor.encoding != Encoding::unspecified || !isDisplayFormat(sceneColor.format)) return;
    if (std::exchange(context.toldOfEncoding, true)) return;
    static_cast<void>(context.device.fail(
        Status::ok, "ViewDesc.sceneColor.format is UNORM, and taken for linear, expected "
                    "ViewDesc.sceneColor.encoding to be linear, or srgb where it holds what displays take"));
}

} // namespace seaglass
