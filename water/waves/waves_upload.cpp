#include "water/waves/waves_upload.h"

#include "water/interface/waves_backend.h"

namespace seaglass {

namespace {

VkDeviceSize stagingBytes(const Sea& sea) {
    return WaveMaps::mip0Bytes(cascade(sea, 0).samples, cascadeCount(sea));
}

constexpr VkBufferUsageFlags uploadUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

} // namespace

VkDeviceSize UploadedWaves::bytes(const Context& context, const Sea& sea) {
    return gpu::heldBytes(context.device, stagingBytes(sea), uploadUsage) * context.frameCount;
}

Status UploadedWaves::create(Context& context, const Sea& sea, const WavesBackend& backend) {
    backend_ = &backend;
    state_ = {backend.create(sea), BackendStateDeleter{backend.destroy}};
    if (!state_)
        return context.device.fail(Status::outOfHostMemory, "waves backend %s: out of memory", backend.name);
    for (uint32_t slot = 0; slot < context.frameCount; ++slot)
        if (const Status s = staging_[slot].createMapped(context.device, stagingBytes(sea), uploadUsage,
                                                         "wave staging buffer");
            s != Status::ok)
            return s;
    return Status::ok;
}

Status UploadedWaves::record(Context& context, VkCommandBuffer commands, const WaveMaps& maps, double time) {
    const gpu::Buffer& staging = staging_[context.slot];
    const size_t layer = size_t{4} * maps.samples * maps.samples;
    for (uint32_t i = 0; i < maps.cascades; ++i) {
        const auto mapped = [&](uint32_t map) {
            return static_cast<float*>(staging.mapped()) + layer * (map * maps.cascades + i);
        };
        backend_->evaluate(state_.get(), i, time, {mapped(0), mapped(1), mapped(2)});
    }
    {
        const gpu::PassScope pass(context.device, commands, "waves_upload");
        maps.recordBegin(context.device, commands, gpu::copyWritten);
        maps.recordCopy(context.device, commands, staging.handle(), maps.cascades);
    }
    return maps.recordMips(context, commands, gpu::copyWritten);
}

} // namespace seaglass
