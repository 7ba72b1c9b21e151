#include "reflection/blur.h"

#include <algorithm>
#include <bit>

#include "gpu/mip_chain.h"

namespace seaglass {

uint32_t blurMipLevels(VkExtent2D extent, uint32_t levels) {
    const auto whole = static_cast<uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
    return std::min(1 + levels, whole);
}

void recordBlur(Context& context, VkCommandBuffer commands, const gpu::OwnedImage& color) {
    const gpu::PassScope pass(context.device, commands, "sspr_blur");
    const gpu::OwnedImage* const images[] = {&color};
    gpu::recordMipChain(context.device, commands, images, gpu::storageWritten);
}

} // namespace seaglass
