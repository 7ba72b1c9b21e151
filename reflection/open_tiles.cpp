#include "reflection/open_tiles.h"

#include "reflection/mirror.h"
#include "spirv/open_tiles.comp.h"

namespace seaglass {

namespace {

constexpr gpu::BufferUse transferWritten = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                            VK_ACCESS_2_TRANSFER_WRITE_BIT};

void recordClear(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& open) {
    // The view's previous frame may still be dispatching from it.
    gpu::recordBarrier(
        device, commands,
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_NONE},
        transferWritten);
    device.vk().CmdFillBuffer(commands, open.handle(), 0, sizeof(TileHeader), 0);
    gpu::recordBarrier(device, commands, transferWritten,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT});
}

} // namespace

Status OpenTilesKernel::create(Context& context) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return kernel.create(context.device, open_tiles_comp, bindings, "open tiles pipeline");
}

Status recordOpenTiles(const ReflectPass& pass, const OpenTilesKernel& kernel, const gpu::Buffer& sorted,
                       const OwnedReflection& images, const gpu::Buffer& open) {
    Context& context = pass.context;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::storageBuffer(sorted.handle()),
        gpu::sampledImage(context.samplers.nearestClamp(), images.info.view()),
        gpu::storageBuffer(open.handle()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "hybrid_open_tiles");
    recordClear(context.device, pass.commands, open);
    recordTileLists(pass, kernel.kernel, set);
    return Status::ok;
}

} // namespace seaglass
