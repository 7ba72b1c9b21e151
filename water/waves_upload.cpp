#include "water/waves_upload.h"

namespace seaglass {

namespace {

constexpr gpu::Use copyWritten = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
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

VkDeviceSize UploadedWaves::bytes(const Sea& sea, uint32_t framesInFlight) {
    return stagingBytes(sea) * framesInFlight;
}

Status UploadedWaves::create(Context& context, const Sea& sea, const WavesBackend& backend) {
    backend_ = &backend;
    state_ = {backend.create(sea), BackendStateDeleter{backend.destroy}};
    if (!state_)
        return context.device.fail(Status::outOfHostMemory, "waves backend %s: out of memory", backend.name);
    for (uint32_t slot = 0; slot < context.frameCount; ++slot)
        if (const Status s = staging_[slot].createMapped(
                context.device, stagingBytes(sea), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "wave staging buffer");
            s != Status::ok)
            return s;
    return Status::ok;
}

Status UploadedWaves::record(Context& context, VkCommandBuffer commands, const WaveMaps& maps, double time) {
    const gpu::Buffer& staging = staging_[context.slot];
    const size_t layer = static_cast<size_t>(layerBytes(maps.samples)) / sizeof(float);
    for (uint32_t i = 0; i < maps.cascades; ++i) {
        const auto mapped = [&](uint32_t map) {
            return static_cast<float*>(staging.mapped()) + layer * (map * maps.cascades + i);
        };
        backend_->evaluate(state_.get(), i, time, {mapped(0), mapped(1), mapped(2)});
    }
    {
        const gpu::PassScope pass(context.device, commands, "waves_upload");
        maps.recordBegin(context.device, commands, copyWritten);
        copyToMip0(context.device, commands, staging, maps);
    }
    maps.recordMips(context.device, commands, copyWritten);
    return Status::ok;
}

} // namespace seaglass
