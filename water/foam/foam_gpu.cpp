#include "water/foam/foam_gpu.h"

#include "shaders/shared/waves_bindings.h"
#include "spirv/foam.comp.h"
#include "water/interface/foam_layers.h"

namespace seaglass {

Status FoamKernel::create(Context& context) {
    return kernel.create(context.device, foam_comp, "foam pipeline");
}

Status ComputedFoam::create(Context& context, const Sea& sea, const FoamDesc& foam) {
    sea_ = &sea;
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
    for (int64_t i = 0; i < steps.all(); ++i) {
        const FoamStep next = steps.at(i);
        if (const Status s =
                waves.recordFirst(context, commands, maps, breaking_.count, foamStepTime(next.step));
            s != Status::ok)
            return s;
        if (const Status s = recordStep(context, commands, maps, foam, next); s != Status::ok) return s;
    }
    if (const Status s = foam.recordMips(context, commands, gpu::storageWritten); s != Status::ok) return s;
    known_ = {steps.last, steps.caughtUp};
    return Status::ok;
}

FoamBand ComputedFoam::bandOf(uint32_t c, const FoamStep& step) const {
    const Cascade& cascade = seaglass::cascade(*sea_, c);
    const FoamDrift drift = foamDriftOf(description(*sea_), cascade, foamStepTime(step.step));
    const Fading &foam = fading_[c].foam, &plume = fading_[c].plume;
    const double ahead = (plumeTap(1) - plumeTap(0)) / cascade.patch;
    FoamBand band;
    band.foam = {breaking_.threshold[c], 1 / breaking_.softness[c], foam.over(step.fadings), foam.floor};
    band.plume = {plume.over(std::max<int64_t>(step.plumeFadings, 1)), plume.floor,
                  ahead * double{breaking_.runs[c][0]}, ahead * double{breaking_.runs[c][1]}};
    band.drift = {drift.u, drift.v, 0, 0};
    return band;
}

Status ComputedFoam::recordStep(Context& context, VkCommandBuffer commands, const WaveMaps& maps,
                                const FoamImage& foam, const FoamStep& step) {
    FoamBlock block{};
    static_assert(std::size(FoamBlock{}.bands) == maxCascades);
    for (uint32_t c = 0; c < breaking_.count; ++c) block.bands[c] = bandOf(c, step);
    block.along = {breaking_.along[0], breaking_.along[1], breaking_.along[2], 0};
    block.foamAnew = step.foamAnew;
    block.plumeAnew = step.plumeAnew;
    block.plumes = step.plumeFadings > 0 ? plumeTaps : 0;
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;

    const VkSampler repeat = context.samplers.trilinearRepeat();
    const gpu::Bound resources[] = {
        {foamBinding, gpu::uniformBuffer(slice)},
        {displacementMapBinding, gpu::sampledImage(repeat, maps.images[0].view())},
        {derivativeMapBinding, gpu::sampledImage(repeat, maps.images[1].view())},
        {foamStepsBinding, gpu::storageImage(foam.image)},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel_->kernel.layout(), resources, set);
        s != Status::ok)
        return s;

    const VkImageMemoryBarrier2 barrier =
        gpu::imageBarrier(foam.image.handle(), gpu::storageWritten, gpu::storageChanged, 0, 1);
    if (!step.plumeAnew) gpu::recordBarriers(context.device, commands, &barrier, 1);
    kernel_->kernel.dispatchOver(commands, set, {maps.samples, maps.samples * breaking_.count});
    return Status::ok;
}

} // namespace seaglass
