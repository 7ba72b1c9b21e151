// Times of a frame: whole from submission to fence, and by stage.
#include "host/host_impl.h"
#include "host/stage_times.h"

namespace demos {

bool Host::Impl::timeFrame(const FrameDesc& frame, double& ms, Error& error) {
    if (!recorder->begin(*scene, frame, error) ||
        !device->run([&](VkCommandBuffer commands, Error& problem) { return recordFrame(commands, problem); },
                     error))
        return false;
    ms = device->lastRunMs();
    return true;
}

std::optional<double> Host::frameMs(const FrameDesc& timed, uint32_t runs, Error& error) {
    FrameDesc frame = timed;
    frame.follows = true;
    if (!impl_->ready(error)) return std::nullopt;
    if (runs == 0) {
        error.text = "measuring needs at least one run";
        return std::nullopt;
    }
    std::vector<double> ms(runs);
    for (double& one : ms)
        if (!impl_->timeFrame(frame, one, error)) return std::nullopt;
    return quantile(ms, 0.5);
}

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
        double wholeMs = 0;
        if (!impl.timeFrame(frame, wholeMs, error)) return std::nullopt;
        if (warm) {
            whole.push_back(wholeMs);
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
