#include "reflection/scatter.h"

#include <algorithm>

#include "reflection/mirror.h"
#include "reflection/reflection_images.h"
#include "reflection/tiles.h"
#include "spirv/scatter.comp.h"
#include "spirv/scatter_coarse.comp.h"

namespace seaglass {

namespace {

constexpr uint32_t groupWidth = 64;

void recordClear(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& keys,
                 const gpu::Buffer& tiles) {
    const gpu::PassScope scope(device, commands, "sspr_clear");
    recordBuffersCleared(device, commands, {keys.handle(), tiles.handle()});
}

Status createKernel(Context& context, std::span<const uint32_t> spirv, gpu::Kernel& out) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return out.create(context.device, spirv, bindings, "scatter pipeline");
}

} // namespace

Status ScatterKernel::create(Context& context) {
    return createKernel(context, scatter_comp, kernel);
}

Status CoarseScatterKernel::create(Context& context) {
    return createKernel(context, scatter_coarse_comp, scatter.kernel);
}

Status recordScatter(const ReflectPass& pass, const ScatterKernel& scatter, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const Image& depth = pass.view.sceneDepth;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(context.samplers.nearestClamp(), depth.view, depth.layout),
        gpu::storageBuffer(keys.handle()),
        gpu::storageBuffer(tiles.handle()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(scatter.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;
    recordClear(device, pass.commands, keys, tiles);

    const gpu::PassScope scope(device, pass.commands, "sspr_scatter");
    const VkExtent2D grid = scaledDown(pass.extent(), std::max(keyScale(pass.desc), 2u));
    const uint32_t tileRows =
        (scaledDown(pass.extent(), pass.desc.downscale).height + tileEdge - 1) / tileEdge;
    scatter.kernel.dispatch(pass.commands, set, (grid.width + groupWidth - 1) / groupWidth, tileRows);
    gpu::recordBarrier(device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
    return Status::ok;
}

} // namespace seaglass
