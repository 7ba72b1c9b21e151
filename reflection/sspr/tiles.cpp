#include "reflection/sspr/tiles.h"

#include "reflection/core/depth_scan.h"
#include "reflection/core/reflection_images.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/tiles.comp.h"
#include "spirv/tiles_overhangs.comp.h"

namespace seaglass {

namespace {

uint32_t tileCount(VkExtent2D extent) {
    return ((extent.width + tileEdge - 1) / tileEdge) * ((extent.height + tileEdge - 1) / tileEdge);
}

constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                     VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;

VkDeviceSize bytesOf(VkExtent2D extent) {
    return sizeof(TileHeader) + VkDeviceSize{tileCount(extent)} * 2 * sizeof(uint32_t);
}

} // namespace

Status createTiles(const gpu::Device& device, VkExtent2D extent, const char* what, gpu::Buffer& out) {
    return out.create(device, bytesOf(extent), usage, what);
}

VkDeviceSize heldByTiles(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, bytesOf(extent), usage);
}

void recordAllSeen(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& tiles) {
    gpu::recordBuffersFilled(device, commands, {tiles.handle()}, VK_WHOLE_SIZE, tileSeesPlane);
}

Status TilesKernel::create(Context& context) {
    return kernel.create(context.device, tiles_comp, "tiles pipeline");
}

Status OverhangsTilesKernel::create(Context& context) {
    return tiles.kernel.create(context.device, tiles_overhangs_comp, "tiles pipeline");
}

void recordTileLists(const ReflectPass& pass, const gpu::Kernel& kernel, VkDescriptorSet set) {
    const uint32_t count = tileCount(scaledDown(pass.extent(), pass.desc));
    kernel.dispatchAlong(pass.commands, set, count);
    gpu::recordBarrier(pass.context.device, pass.commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT});
}

Status recordTiles(const ReflectPass& pass, const TilesKernel& kernel, const gpu::Buffer& keys,
                   const gpu::Buffer& tiles) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = allocateDepthScan(pass, kernel.kernel,
                                           {keysBinding, gpu::storageBuffer(keys.handle())}, tiles, set);
        s != Status::ok)
        return s;
    const gpu::PassScope scope(pass.context.device, pass.commands, "sspr_tiles");
    recordTileLists(pass, kernel.kernel, set);
    return Status::ok;
}

} // namespace seaglass
