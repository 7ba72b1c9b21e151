#include "reflection/scatter.h"

#include "reflection/mirror.h"
#include "spirv/scatter.comp.h"

namespace seaglass {

namespace {

constexpr uint32_t groupWidth = 64;
constexpr uint32_t rowsPerInvocation = 4;

void barrier(const gpu::Device& device, VkCommandBuffer commands, VkPipelineStageFlags2 srcStage,
             VkAccessFlags2 srcAccess, VkPipelineStageFlags2 dstStage, VkAccessFlags2 dstAccess) {
    VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    memory.srcStageMask = srcStage;
    memory.srcAccessMask = srcAccess;
    memory.dstStageMask = dstStage;
    memory.dstAccessMask = dstAccess;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    device.vk().CmdPipelineBarrier2(commands, &dependency);
}

} // namespace

Status ScatterKernel::create(Context& context) {
    constexpr VkDescriptorType bindings[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                             VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                             VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return kernel.create(context.device, scatter_comp, bindings, "scatter pipeline");
}

Status recordScatter(const ReflectPass& pass, const ScatterKernel& scatter, const gpu::Buffer& keys) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const Image& depth = pass.view.sceneDepth;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(context.samplers.nearestClamp(), depth.view, depth.layout),
        gpu::storageBuffer(keys.handle()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(scatter.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    {
        // The view's previous frame may still be resolving from these keys.
        const gpu::PassScope scope(device, commands, "sspr_clear");
        barrier(device, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE,
                VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
        device.vk().CmdFillBuffer(commands, keys.handle(), 0, VK_WHOLE_SIZE, 0);
        barrier(device, commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    }
    {
        const gpu::PassScope scope(device, commands, "sspr_scatter");
        const auto width = static_cast<uint32_t>(pass.geometry.regionSize.x);
        const auto height = static_cast<uint32_t>(pass.geometry.regionSize.y);
        const uint32_t rows = (height + rowsPerInvocation - 1) / rowsPerInvocation;
        scatter.kernel.dispatch(commands, set, (width + groupWidth - 1) / groupWidth, rows);
        barrier(device, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
    }
    return Status::ok;
}

} // namespace seaglass
