#include "water/foam/foam_gpu.h"

#include "shaders/shared/foam/foam_block.h"
#include "shaders/shared/waves_bindings.h"
#include "spirv/foam.comp.h"

namespace seaglass {

Status FoamKernel::create(Context& context) {
    return kernel.create(context.device, foam_comp, "foam pipeline");
}

Status ComputedFoam::create(Context& context, const Sea& sea, const FoamDesc& foam) {
    breaking_ = breakingOf(sea, foam);
    fading_ = fadingsOf(foam, breaking_);
    return context.share(kernel_);
}

Status ComputedFoam::record(Context& context, VkCommandBuffer commands, ComputedWaves& waves,
                            const WaveMaps& maps, const FoamImage& foam, int64_t step) {
    const FoamSteps steps = stepsUntil(known_, step, fading_[0]);
    known_ = {}; // until all of it is recorded
    const gpu::PassScope pass(context.device, commands, "foam");
    const VkImage image = foam.image.handle();
    const VkImageMemoryBarrier2 before = gpu::imageBarrier(
        image, steps.anew ? gpu::discardedAfterSampling : gpu::sampledByShaders, gpu::storageChanged, 0, 1);
    gpu::recordBarriers(context.device, commands, &before, 1);
    for (int64_t i = 1; i <= steps.count; ++i) {
        if (const Status s =
                waves.recordFirst(context, commands, maps, breaking_.count, foamStepTime(steps.at(i)));
            s != Status::ok)
            return s;
        if (const Status s =
                recordStep(context, commands, maps, foam, steps.fadings(i), steps.anew && i == 1);
            s != Status::ok)
            return s;
    }
    if (const Status s = foam.recordMips(context, commands, gpu::storageWritten); s != Status::ok) return s;
    known_ = {steps.last, steps.caughtUp};
    return Status::ok;
}

Status ComputedFoam::recordStep(Context& context, VkCommandBuffer commands, const WaveMaps& maps,
                                const FoamImage& foam, int64_t fadings, bool anew) {
    FoamBlock block{};
    static_assert(std::size(FoamBlock{}.bands) == maxCascades);
    for (uint32_t c = 0; c < breaking_.count; ++c)
        block.bands[c] = {breaking_.threshold[c], 1 / breaking_.softness[c], fading_[c].over(fadings),
                          fading_[c].floor};
    block.along = {breaking_.along[0], breaking_.along[1], breaking_.along[2], 0};
    block.anew = anew;
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;

    const VkSampler nearest = context.samplers.nearestClamp();
    const gpu::Bound resources[] = {
        {foamBinding, gpu::uniformBuffer(slice)},
        {displacementMapBinding, gpu::sampledImage(nearest, maps.images[0].view())},
        {derivativeMapBinding, gpu::sampledImage(nearest, maps.images[1].view())},
        {foamStepsBinding, gpu::storageImage(foam.image.firstMipView())},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel_->kernel.layout(), resources, set);
        s != Status::ok)
        return s;

    const VkImageMemoryBarrier2 barrier =
        gpu::imageBarrier(foam.image.handle(), gpu::storageWritten, gpu::storageChanged, 0, 1);
    if (!anew) gpu::recordBarriers(context.device, commands, &barrier, 1);
    kernel_->kernel.dispatchOver(commands, set, {maps.samples, maps.samples * breaking_.count});
    return Status::ok;
}

} // namespace seaglass
