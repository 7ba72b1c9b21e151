#include "reflection/march/cells.h"

#include "reflection/core/depth_scan.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/cells.comp.h"

namespace seaglass {

namespace {

constexpr uint32_t cellEdge = 8;
constexpr uint32_t blockEdge = 64;

uint32_t countOf(VkExtent2D extent, uint32_t edge) {
    return ((extent.width + edge - 1) / edge) * ((extent.height + edge - 1) / edge);
}

constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;

VkDeviceSize bytesOf(VkExtent2D extent) {
    return (VkDeviceSize{countOf(extent, cellEdge)} + countOf(extent, blockEdge)) * sizeof(uint32_t);
}

} // namespace

Status createCells(const gpu::Device& device, VkExtent2D extent, const char* what, gpu::Buffer& out) {
    return out.create(device, bytesOf(extent), usage, what);
}

VkDeviceSize heldByCells(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, bytesOf(extent), usage);
}

Status CellsKernel::create(Context& context) {
    return kernel.create(context.device, cells_comp, "cells pipeline");
}

Status recordCells(const ReflectPass& pass, const CellsKernel& kernel, const gpu::Buffer& cells,
                   const gpu::Buffer& tiles) {
    const gpu::Device& device = pass.context.device;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = allocateDepthScan(pass, kernel.kernel,
                                           {cellsBinding, gpu::storageBuffer(cells.handle())}, tiles, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(device, pass.commands, "ssr_cells");
    gpu::recordBuffersCleared(device, pass.commands, {cells.handle()});
    kernel.kernel.dispatchAlong(pass.commands, set, countOf(pass.extent(), cellEdge));
    recordScanned(pass);
    return Status::ok;
}

} // namespace seaglass
