#include "reflection/core/depth_scan.h"

#include "reflection/core/mirror.h"
#include "shaders/shared/reflection_bindings.h"

namespace seaglass {

Status allocateDepthScan(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Bound& found,
                         const gpu::Buffer& tiles, VkDescriptorSet& out) {
    const Image& depth = pass.view.sceneDepth;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {sceneDepthBinding,
         gpu::sampledImage(pass.context.samplers.nearestClamp(), depth.view, depth.layout)},
        found,
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
    };
    return pass.context.frame().allocateSet(kernel.layout(), resources, out);
}

void recordScanned(const ReflectPass& pass) {
    gpu::recordBarrier(pass.context.device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
}

} // namespace seaglass
