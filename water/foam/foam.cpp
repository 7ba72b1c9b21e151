#include "water/foam/foam.h"

#include "water/interface/waves_backend.h"

namespace seaglass {

namespace {

VkImageUsageFlags imageUsage(bool uploaded) {
    return uploaded ? UploadedFoam::imageUsage : ComputedFoam::imageUsage;
}

} // namespace

VkDeviceSize Foam::bytes(const Context& context, const Sea& sea, const FoamDesc& foam,
                         const WavesBackend* backend) {
    const uint32_t samples = cascade(sea, 0).samples, cascades = breakingOf(sea, foam).count;
    return FoamImage::bytes(context.device, samples, cascades, imageUsage(backend)) +
           (backend ? UploadedFoam::bytes(context, samples, cascades) : 0);
}

Status Foam::create(Context& context, const Sea& sea, const FoamDesc& foam, const WavesBackend* backend) {
    loopPeriod_ = description(sea).loopPeriod;
    albedo_ = foam.albedo;
    breaking_ = breakingOf(sea, foam);
    if (const Status s =
            image_.create(context, cascade(sea, 0).samples, breaking_.count, imageUsage(backend));
        s != Status::ok)
        return s;
    if (backend) return source_.emplace<UploadedFoam>().create(context, sea, foam);
    return source_.emplace<ComputedFoam>().create(context, sea, foam);
}

Status Foam::record(Context& context, VkCommandBuffer commands, Waves& waves, double time) {
    at_ = foamTimeOf(time, loopPeriod_);
    time_ = time;
    if (step_ == at_.step) return Status::ok;
    step_.reset();
    if (const Status s = recordSteps(context, commands, waves, at_.step); s != Status::ok) return s;
    step_ = at_.step;
    return Status::ok;
}

Status Foam::recordSteps(Context& context, VkCommandBuffer commands, Waves& waves, int64_t step) {
    if (auto* computed = std::get_if<ComputedFoam>(&source_))
        return computed->record(context, commands, *waves.computed(), waves.mapsToFill(), image_, step);
    return std::get<UploadedFoam>(source_).record(context, commands, *waves.uploaded(), image_, step);
}

} // namespace seaglass
