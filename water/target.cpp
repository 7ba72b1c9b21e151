#include "water/target.h"

#include "gpu/guard.h"

namespace seaglass {

namespace {

const char* badField(const TargetDesc& desc) {
    if (desc.colorFormat == VK_FORMAT_UNDEFINED) return "TargetDesc.colorFormat is undefined";
    if (desc.depthFormat == VK_FORMAT_UNDEFINED) return "TargetDesc.depthFormat is undefined";
    const auto samples = static_cast<uint32_t>(desc.samples);
    if (samples == 0 || samples > 64 || (samples & (samples - 1)) != 0)
        return "TargetDesc.samples is no sample count";
    return nullptr;
}

} // namespace

Status createTarget(Context* context, const TargetDesc* desc, Target** out) {
    if (!context || !desc || !out) return Status::invalidArgument;
    *out = nullptr;
    if (const char* bad = badField(*desc)) return context->device.fail(Status::invalidArgument, "%s", bad);
    return gpu::guarded([&] {
        auto target = std::make_unique<Target>();
        target->context = context;
        target->pipelines.init(context->device, *desc);
        target->underwater.init(context->device, *desc);
        *out = target.release();
        return Status::ok;
    });
}

void destroyTarget(Target* target) {
    if (!target) return;
    target->context->frame().retire(std::unique_ptr<Target>(target));
}

} // namespace seaglass
