#include "reflection/depth_scan.h"

#include <vector>

#include "reflection/mirror.h"

namespace seaglass {

Status allocateDepthScan(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Buffer& found,
                         const gpu::Buffer& tiles, VkDescriptorSet& out) {
    const Image& depth = pass.view.sceneDepth;
    std::vector<gpu::Bound> resources = {
        {0, gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms))},
        {1, gpu::sampledImage(pass.context.samplers.nearestClamp(), depth.view, depth.layout)},
        {2, gpu::storageBuffer(found.handle())},
        {3, gpu::storageBuffer(tiles.handle())},
    };
    std::erase_if(resources, [&](const gpu::Bound& bound) { return !kernel.layout().has(bound.number); });
    return pass.context.frame().allocateSet(kernel.layout(), resources, out);
}

void recordScanned(const ReflectPass& pass) {
    gpu::recordBarrier(pass.context.device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
}

} // namespace seaglass
