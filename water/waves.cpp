#include "water/waves.h"

namespace seaglass {

VkDeviceSize Waves::bytes(const Context& context, const Sea& sea, const WavesBackend* backend) {
    return WaveMaps::bytes(cascade(sea, 0).samples, cascadeCount(sea)) +
           (backend ? UploadedWaves::bytes(sea, context.frameCount)
                    : ComputedWaves::bytes(context.device, sea));
}

Status Waves::create(Context& context, const Sea& sea, const WavesBackend* backend) {
    const VkImageUsageFlags filledBy =
        backend ? UploadedWaves::mapUsage : ComputedWaves::mapUsage(context.device);
    if (const Status s = maps_.create(context.device, cascade(sea, 0).samples, cascadeCount(sea), filledBy);
        s != Status::ok)
        return s;
    if (backend) return source_.emplace<UploadedWaves>().create(context, sea, *backend);
    return source_.emplace<ComputedWaves>().create(context, sea);
}

Status Waves::record(Context& context, VkCommandBuffer commands, double time) {
    return std::visit([&](auto& source) { return source.record(context, commands, maps_, time); }, source_);
}

} // namespace seaglass
