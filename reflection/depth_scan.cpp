#include "reflection/depth_scan.h"

#include "reflection/mirror.h"

namespace seaglass {

Status createDepthScan(Context& context, std::span<const uint32_t> spirv, const char* what,
                       gpu::Kernel& out) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return out.create(context.device, spirv, bindings, what);
}

Status allocateDepthScan(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Buffer& found,
                         const gpu::Buffer& tiles, VkDescriptorSet& out) {
    const Image& depth = pass.view.sceneDepth;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(pass.context.samplers.nearestClamp(), depth.view, depth.layout),
        gpu::storageBuffer(found.handle()),
        gpu::storageBuffer(tiles.handle()),
    };
    return pass.context.frame().allocateSet(kernel.layout(), resources, out);
}

void recordScanned(const ReflectPass& pass) {
    gpu::recordBarrier(pass.context.device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
}

} // namespace seaglass
