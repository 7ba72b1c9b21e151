#include "reflection/sspr.h"

#include "reflection/mirror.h"

namespace seaglass {

namespace {

VkDeviceSize keyBytes(VkExtent2D extent, const ReflectionDesc& desc) {
    const VkExtent2D grid = scaledDown(extent, keyScale(desc));
    return VkDeviceSize{grid.width} * grid.height * sizeof(uint32_t);
}

VkDeviceSize tileBytes(VkExtent2D extent, const ReflectionDesc& desc) {
    return tileBufferBytes(scaledDown(extent, desc.downscale));
}

Status shareScatter(Context& context, const ReflectionDesc& desc, std::shared_ptr<ScatterKernel>& out) {
    if (keyScale(desc) == 1) return context.share(out);
    std::shared_ptr<CoarseScatterKernel> coarse;
    if (const Status s = context.share(coarse); s != Status::ok) return s;
    out = std::shared_ptr<ScatterKernel>(coarse, &coarse->scatter);
    return Status::ok;
}

} // namespace

Status SsprKernels::create(Context& context, const ReflectionDesc& desc) {
    if (const Status s = shareScatter(context, desc, scatter); s != Status::ok) return s;
    if (const Status s = context.share(tiles); s != Status::ok) return s;
    return context.share(resolve);
}

VkDeviceSize SsprScratch::bytes(VkExtent2D extent, const ReflectionDesc& desc) {
    return keyBytes(extent, desc) + tileBytes(extent, desc);
}

Status SsprScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    const VkDeviceSize wanted = keyBytes(extent, desc);
    if (wanted > device.limits().maxStorageBufferRange)
        return device.fail(Status::unsupported,
                           "reflect: %u x %u pixels need a storage buffer of %llu bytes, the device has %u",
                           extent.width, extent.height, static_cast<unsigned long long>(wanted),
                           device.limits().maxStorageBufferRange);
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                     VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (const Status s = keys.create(device, wanted, usage, "SSPR keys"); s != Status::ok) return s;
    return tiles.create(device, tileBytes(extent, desc), tileBufferUsage, "SSPR tiles");
}

Status recordSspr(const ReflectPass& pass, const SsprKernels& kernels, const SsprScratch& scratch,
                  const OwnedReflection& images) {
    if (const Status s = recordScatter(pass, *kernels.scatter, scratch.keys, scratch.tiles); s != Status::ok)
        return s;
    if (const Status s = recordTiles(pass, *kernels.tiles, scratch.tiles); s != Status::ok) return s;
    return recordResolve(pass, *kernels.resolve, scratch.keys, scratch.tiles, images);
}

} // namespace seaglass
