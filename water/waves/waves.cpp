#include "water/waves/waves.h"

#include "water/interface/waves_backend.h"

#include <utility>

namespace seaglass {

namespace {

VkImageUsageFlags mapUsage(const gpu::Device& device, const WavesBackend* backend) {
    return backend ? UploadedWaves::mapUsage : ComputedWaves::mapUsage(device);
}

VkDeviceSize mapBytes(const gpu::Device& device, const Sea& sea, const WavesBackend* backend) {
    return WaveMaps::bytes(device, cascade(sea, 0).samples, cascadeCount(sea), mapUsage(device, backend));
}

} // namespace

VkDeviceSize Waves::bytes(const Context& context, const Sea& sea, const WavesBackend* backend) {
    return mapBytes(context.device, sea, backend) +
           (backend ? UploadedWaves::bytes(context, sea) : ComputedWaves::bytes(context.device, sea));
}

Status Waves::create(Context& context, const Sea& sea, const WavesBackend* backend) {
    if (const Status s = maps_.create(context, cascade(sea, 0).samples, cascadeCount(sea),
                                      mapUsage(context.device, backend));
        s != Status::ok)
        return s;
    if (backend) return source_.emplace<UploadedWaves>().create(context, sea, *backend);
    return source_.emplace<ComputedWaves>().create(context, sea);
}

Status Waves::keepLast(const gpu::Device& device) {
    return last_.create(device, maps_.images[0].desc(), "last wave displacement map");
}

VkDeviceSize Waves::lastBytes(const gpu::Device& device, const Sea& sea, const WavesBackend* backend) {
    return mapBytes(device, sea, backend) / waveMapCount;
}

const WaveMaps& Waves::mapsToFill() {
    if (std::exchange(recorded_, false) && last_.handle()) {
        std::swap(maps_.images[0], last_);
        turned_ = true;
    }
    return maps_;
}

VkImageView Waves::lastDisplacement() const {
    return turned_ ? last_.view() : maps_.images[0].view();
}

Status Waves::record(Context& context, VkCommandBuffer commands, double time) {
    const WaveMaps& maps = mapsToFill();
    recorded_ = true;
    return std::visit([&](auto& source) { return source.record(context, commands, maps, time); }, source_);
}

} // namespace seaglass
