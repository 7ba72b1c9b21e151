#include "reflection/sspr.h"

namespace seaglass {

Status SsprKernels::create(Context& context) {
    if (const Status s = scatter.create(context); s != Status::ok) return s;
    if (const Status s = tiles.create(context); s != Status::ok) return s;
    return resolve.create(context);
}

namespace {

VkDeviceSize keyBytes(VkExtent2D extent) {
    return VkDeviceSize{extent.width} * extent.height * sizeof(uint32_t);
}

} // namespace

VkDeviceSize SsprScratch::bytes(VkExtent2D extent) {
    return keyBytes(extent) + tileBufferBytes(extent);
}

Status SsprScratch::create(const gpu::Device& device, VkExtent2D extent) {
    const VkDeviceSize wanted = keyBytes(extent);
    if (wanted > device.limits().maxStorageBufferRange)
        return device.fail(Status::unsupported,
                           "reflect: %u x %u pixels need a storage buffer of %llu bytes, the device has %u",
                           extent.width, extent.height, static_cast<unsigned long long>(wanted),
                           device.limits().maxStorageBufferRange);
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                     VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (const Status s = keys.create(device, wanted, usage, "SSPR keys"); s != Status::ok) return s;
    return tiles.create(device, tileBufferBytes(extent), usage | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                        "SSPR tiles");
}

Status recordSspr(const ReflectPass& pass, const SsprKernels& kernels, const SsprScratch& scratch,
                  const OwnedReflection& images) {
    if (const Status s = recordScatter(pass, kernels.scatter, scratch.keys, scratch.tiles); s != Status::ok)
        return s;
    if (const Status s = recordTiles(pass, kernels.tiles, scratch.tiles); s != Status::ok) return s;
    return recordResolve(pass, kernels.resolve, scratch.keys, scratch.tiles, images);
}

} // namespace seaglass
