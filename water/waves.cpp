#include "water/waves.h"

#include <utility>

namespace seaglass {

VkDeviceSize Waves::bytes(const Context& context, const Sea& sea, const WavesBackend* backend) {
    return WaveMaps::bytes(cascade(sea, 0).samples, cascadeCount(sea)) +
           (backend ? UploadedWaves::bytes(sea, context.frameCount)
                    : ComputedWaves::bytes(context.device, sea));
}

Status Waves::create(Context& context, const Sea& sea, const WavesBackend* backend) {
    const VkImageUsageFlags filledBy =
        backend ? UploadedWaves::mapUsage : ComputedWaves::mapUsage(context.device);
    if (const Status s = maps_.create(context, cascade(sea, 0).samples, cascadeCount(sea), filledBy);
        s != Status::ok)
        return s;
    if (backend) return source_.emplace<UploadedWaves>().create(context, sea, *backend);
    return source_.emplace<ComputedWaves>().create(context, sea);
}

Status Waves::keepLast(const gpu::Device& device) {
    return last_.create(device, maps_.images[0].desc(), "last wave displacement map");
}

VkDeviceSize Waves::lastBytes(const Sea& sea) {
    return WaveMaps::bytes(cascade(sea, 0).samples, cascadeCount(sea)) / waveMapCount;
}

void Waves::turnOver() {
    if (!last_.handle()) return;
    std::swap(maps_.images[0], last_);
    turned_ = true;
}

VkImageView Waves::lastDisplacement() const {
    return turned_ ? last_.view() : maps_.images[0].view();
}

Status Waves::record(Context& context, VkCommandBuffer commands, double time) {
    return std::visit([&](auto& source) { return source.record(context, commands, maps_, time); }, source_);
}

} // namespace seaglass
