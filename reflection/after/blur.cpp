#include "reflection/after/blur.h"

#include <algorithm>
#include <bit>

#include "shaders/shared/reflection_bindings.h"
#include "spirv/blur.comp.h"

namespace seaglass {

uint32_t blurMipLevels(VkExtent2D extent, uint32_t levels) {
    const auto whole = static_cast<uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
    return std::min(1 + levels, whole);
}

Status BlurKernel::create(Context& context) {
    return kernel.create(context.device, blur_comp, "blur pipeline");
}

Status recordBlur(Context& context, VkCommandBuffer commands, const BlurKernel* blur,
                  const gpu::OwnedImage& color) {
    const gpu::PassScope pass(context.device, commands, "reflection_blur");
    const gpu::ImageDesc& desc = color.desc();
    const VkImage image = color.handle();
    VkImageMemoryBarrier2 barriers[] = {
        gpu::imageBarrier(image, gpu::storageWritten, gpu::sampledByShaders, 0, 1),
        gpu::imageBarrier(image, gpu::discardedAfterSampling, gpu::storageWritten, 1)};
    gpu::recordBarriers(context.device, commands, barriers, desc.mipLevels > 1 ? 2 : 1);
    for (uint32_t mip = 1; mip < desc.mipLevels; ++mip) {
        const gpu::Bound resources[] = {
            {finerMipBinding, gpu::sampledImage(context.samplers.trilinearClamp(), color.mipView(mip - 1))},
            {coarserMipBinding, gpu::storageImage(color, mip)},
        };
        VkDescriptorSet set = VK_NULL_HANDLE;
        if (const Status s = context.frame().allocateSet(blur->kernel.layout(), resources, set);
            s != Status::ok)
            return s;
        const VkExtent2D halved = {std::max(desc.extent.width >> mip, 1u),
                                   std::max(desc.extent.height >> mip, 1u)};
        blur->kernel.dispatchOver(commands, set, halved);
        barriers[0] = gpu::imageBarrier(image, gpu::storageWritten, gpu::sampledByShaders, mip, 1);
        gpu::recordBarriers(context.device, commands, barriers, 1);
    }
    return Status::ok;
}

} // namespace seaglass
