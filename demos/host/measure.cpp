// Times of a frame: whole from submission to fence, and by stage.
#include "host/host_impl.h"
#include "host/stage_times.h"

namespace demos {

std::optional<FrameTimes> Host::measure(const FrameDesc& measured, uint32_t runs, Error& error) {
    FrameDesc frame = measured;
    frame.follows = true;
    Impl& impl = *impl_;
    if (!impl.ready(error)) return std::nullopt;
    if (runs == 0) {
        error.text = "measuring needs at least one run";
        return std::nullopt;
    }
    std::vector<double> whole, simulate;
    StageTimes times, ignored;
    for (uint32_t i = 0; i < Impl::warmUps + runs; ++i) {
        const bool warm = i >= Impl::warmUps;
        // Whole frames and stages alternate, so that both see the same machine.
        if (!impl.recorder->begin(*impl.scene, frame, error) ||
            !impl.device->run(
                [&](VkCommandBuffer commands, Error& problem) { return impl.recordFrame(commands, problem); },
                error))
            return std::nullopt;
        if (warm) {
            whole.push_back(impl.device->lastRunMs());
            simulate.push_back(impl.recorder->cpuSimulateMs());
        }
        if (!impl.recorder->begin(*impl.scene, frame, error) ||
            !timeStages(*impl.device, *impl.recorder, stages, warm ? times : ignored, error))
            return std::nullopt;
    }
    FrameTimes found;
    found.frameMs = quantile(whole, 0.5);
    found.cpuSimulateMs = quantile(simulate, 0.5);
    found.runs = runs;
    found.passes = times.passes.medians();
    return found;
}

} // namespace demos
