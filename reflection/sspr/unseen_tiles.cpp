#include "reflection/sspr/unseen_tiles.h"

#include "reflection/core/mirror.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/unseen_tiles.comp.h"

namespace seaglass {

namespace {

void recordCleared(const gpu::Device& device, VkCommandBuffer commands, const OwnedReflection& images) {
    constexpr gpu::Use cleared = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_GENERAL};
    images.recordDiscarded(device, commands, cleared);
    const VkClearColorValue zero{};
    const VkImageSubresourceRange mip0 = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    const VkImage handles[] = {images.color.handle(), images.info.handle()};
    VkImageMemoryBarrier2 after[2];
    for (int i = 0; i < 2; ++i) {
        device.vk().CmdClearColorImage(commands, handles[i], VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &mip0);
        after[i] = gpu::imageBarrier(handles[i], cleared, gpu::storageWritten, 0, 1);
    }
    gpu::recordBarriers(device, commands, after, 2);
}

} // namespace

Status UnseenTilesKernel::create(Context& context) {
    return kernel.create(context.device, unseen_tiles_comp, "unseen tiles pipeline");
}

Status shareUnseenTiles(Context& context, std::shared_ptr<UnseenTilesKernel>& out) {
    return context.device.isCpu() ? Status::ok : context.share(out);
}

uint32_t unseenTilesDispatches(const gpu::Device& device) {
    return device.isCpu() ? 0 : 1;
}

Status recordUnseenTiles(const ReflectPass& pass, const UnseenTilesKernel* kernel, const gpu::Buffer& tiles,
                         const OwnedReflection& images) {
    Context& context = pass.context;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_clear");
    if (!kernel) {
        recordCleared(context.device, pass.commands, images);
        return Status::ok;
    }
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel->kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    images.recordDiscarded(context.device, pass.commands, gpu::storageWritten);
    const VkExtent2D extent = images.color.desc().extent;
    kernel->kernel.dispatchAlong(pass.commands, set, extent.width, (extent.height + tileEdge - 1) / tileEdge);
    return Status::ok;
}

} // namespace seaglass
