#include "water/deferred/shaded_surface.h"

#include "shaders/shared/found_tiles_block.h"
#include "shaders/shared/water_bindings.h"
#include "spirv/shaded_surface.comp.h"
#include "spirv/surface_tiles.comp.h"

namespace seaglass {

namespace {

gpu::ImageDesc colorDesc(VkExtent2D extent) {
    return {.format = VK_FORMAT_R16G16B16A16_SFLOAT,
            .extent = extent,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
}

constexpr VkBufferUsageFlags tilesUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                          VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                          VK_BUFFER_USAGE_TRANSFER_DST_BIT;

uint32_t tileCount(VkExtent2D extent) {
    return (extent.width + 7) / 8 * ((extent.height + 7) / 8);
}

VkDeviceSize tilesBytes(VkExtent2D extent) {
    return sizeof(FoundTilesHeader) + VkDeviceSize{tileCount(extent)} * sizeof(uint32_t);
}

} // namespace

Status SurfaceTilesKernel::create(Context& context) {
    return kernel.create(context.device, surface_tiles_comp, "surface tiles");
}

Status ShadingKernels::get(const SurfaceVariant& variant, const gpu::Kernel*& out) {
    return kernels_.get(
        variant,
        [&](gpu::Kernel& kernel) {
            SurfaceVariant made = variant;
            // A barrier of the whole group costs CPU devices most: all that is alive goes to memory. Of those
            // that there are, subgroups are full, and of four or eight.
            made.quadsInStep = device_->isCpu();
            return kernel.create(*device_, shaded_surface_comp, "shaded surface", made.constants());
        },
        out);
}

SurfaceVariant shadingVariant(const SurfaceVariant& all) {
    SurfaceVariant v = all;
    v.shape = 0;
    v.exclusionVolumes = 0;
    return v;
}

Status ShadedSurface::create(const gpu::Device& device, VkExtent2D extent) {
    if (const Status s = color.create(device, colorDesc(extent), "shaded surface"); s != Status::ok) return s;
    return tiles.create(device, tilesBytes(extent), tilesUsage, "surface tiles");
}

VkDeviceSize ShadedSurface::bytes(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, colorDesc(extent)) + gpu::heldBytes(device, tilesBytes(extent), tilesUsage);
}

Status ShadedSurface::record(Context& context, VkCommandBuffer commands, const SurfaceTilesKernel& list,
                             const gpu::Kernel& shading, const FoundSurface& found, Resources resources,
                             VkExtent2D region) const {
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    resources.push_back({foundDepthBinding, gpu::sampledImage(nearest, found.depth())});
    resources.push_back({foundAsideBinding, gpu::sampledImage(nearest, found.aside())});
    resources.push_back({foundTilesBinding, gpu::storageBuffer(tiles.handle())});
    resources.push_back({shadedBinding, gpu::storageImage(color.view())});
    VkDescriptorSet listSet = VK_NULL_HANDLE, shadingSet = VK_NULL_HANDLE;
    gpu::Frame& frame = context.frame();
    if (const Status s = frame.allocateSet(list.kernel.layout(), resources, listSet); s != Status::ok)
        return s;
    if (const Status s = frame.allocateSet(shading.layout(), resources, shadingSet); s != Status::ok)
        return s;
    const gpu::PassScope pass(device, commands, "shaded_surface");
    gpu::recordBuffersCleared(device, commands, {tiles.handle()}, sizeof(FoundTilesHeader));
    list.kernel.dispatchAlong(commands, listSet, tileCount(region));
    gpu::recordBarrier(device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT});
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(color.handle(), gpu::discardedAfterSampling, gpu::storageWritten);
    gpu::recordBarriers(device, commands, &before, 1);
    shading.dispatchIndirect(commands, shadingSet, tiles.handle(), offsetof(FoundTilesHeader, groups));
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(color.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

} // namespace seaglass
