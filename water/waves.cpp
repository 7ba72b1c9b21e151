#include "water/waves.h"

namespace seaglass {

namespace {

constexpr VkDeviceSize texelBytes = 4 * sizeof(float);

VkDeviceSize layerBytes(uint32_t samples) {
    return texelBytes * samples * samples;
}

VkDeviceSize stagingBytes(const Sea& sea) {
    return layerBytes(cascade(sea, 0).samples) * cascadeCount(sea) * waveMapCount;
}

void copyToMip0(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& staging,
                const WaveMaps& maps) {
    for (uint32_t map = 0; map < waveMapCount; ++map) {
        VkBufferImageCopy region{};
        region.bufferOffset = layerBytes(maps.samples) * maps.cascades * map;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, maps.cascades};
        region.imageExtent = {maps.samples, maps.samples, 1};
        device.vk().CmdCopyBufferToImage(commands, staging.handle(), maps.images[map].handle(),
                                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    }
}

} // namespace

VkDeviceSize Waves::bytes(const Sea& sea, uint32_t framesInFlight) {
    return WaveMaps::bytes(cascade(sea, 0).samples, cascadeCount(sea)) + stagingBytes(sea) * framesInFlight;
}

Status Waves::create(Context& context, const Sea& sea, const WavesBackend& backend) {
    backend_ = &backend;
    state_ = {backend.create(sea), BackendStateDeleter{backend.destroy}};
    if (!state_)
        return context.device.fail(Status::outOfHostMemory, "waves backend %s: out of memory", backend.name);
    const uint32_t count = cascadeCount(sea);
    if (const Status s = maps_.create(context.device, cascade(sea, 0).samples, count); s != Status::ok)
        return s;
    for (uint32_t slot = 0; slot < context.frameCount; ++slot)
        if (const Status s = staging_[slot].createMapped(
                context.device, stagingBytes(sea), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "wave staging buffer");
            s != Status::ok)
            return s;
    return Status::ok;
}

Status Waves::record(Context& context, VkCommandBuffer commands, double time) {
    const gpu::Buffer& staging = staging_[context.slot];
    const size_t layer = static_cast<size_t>(layerBytes(maps_.samples)) / sizeof(float);
    for (uint32_t i = 0; i < maps_.cascades; ++i) {
        const auto mapped = [&](uint32_t map) {
            return static_cast<float*>(staging.mapped()) + layer * (map * maps_.cascades + i);
        };
        backend_->evaluate(state_.get(), i, time, {mapped(0), mapped(1), mapped(2)});
    }
    const gpu::PassScope pass(context.device, commands, "waves_upload");
    maps_.recordBeginUpload(context.device, commands);
    copyToMip0(context.device, commands, staging, maps_);
    maps_.recordMips(context.device, commands);
    return Status::ok;
}

} // namespace seaglass
