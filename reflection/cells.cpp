#include "reflection/cells.h"

#include "reflection/mirror.h"
#include "reflection/tiles.h"
#include "spirv/cells.comp.h"

namespace seaglass {

namespace {

constexpr uint32_t groupWidth = 64;
constexpr uint32_t cellEdge = 8;
constexpr uint32_t blockEdge = 64;

uint32_t countOf(VkExtent2D extent, uint32_t edge) {
    return ((extent.width + edge - 1) / edge) * ((extent.height + edge - 1) / edge);
}

} // namespace

VkDeviceSize cellBufferBytes(VkExtent2D extent) {
    return (VkDeviceSize{countOf(extent, cellEdge)} + countOf(extent, blockEdge)) * sizeof(uint32_t);
}

Status CellsKernel::create(Context& context) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return kernel.create(context.device, cells_comp, bindings, "cells pipeline");
}

Status recordCells(const ReflectPass& pass, const CellsKernel& kernel, const gpu::Buffer& cells,
                   const gpu::Buffer& tiles) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const Image& depth = pass.view.sceneDepth;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(context.samplers.nearestClamp(), depth.view, depth.layout),
        gpu::storageBuffer(cells.handle()),
        gpu::storageBuffer(tiles.handle()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(device, pass.commands, "ssr_cells");
    recordBuffersCleared(device, pass.commands, {cells.handle()});
    const uint32_t count = countOf(pass.extent(), cellEdge);
    kernel.kernel.dispatch(pass.commands, set, (count + groupWidth - 1) / groupWidth, 1);
    gpu::recordBarrier(device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
    return Status::ok;
}

} // namespace seaglass
