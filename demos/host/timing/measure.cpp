// Times of a frame: whole, and by stage.
#include "host/host_impl.h"
#include "host/timing/stage_times.h"

namespace demos {

namespace {

/// A frame by stages, with what it is a multiple of.
class Sampler {
  public:
    explicit Sampler(Host::Impl& host) : host_(host) {}

    bool create(const FrameDesc& frame, Error& error) {
        return yardsticks_.create(*host_.device, {frame.width, frame.height}, error);
    }

    bool sample(const FrameDesc& frame, Error& error) {
        YardstickMs beside;
        if (!host_.recorder->begin(*host_.scene, frame, error) || !time(beside, error)) return false;
        gpuFrameMs_.push_back(times_.gpuFrameMs);
        floorMs_.push_back(beside.floor);
        fullScreenMs_.push_back(beside.fullScreen);
        return true;
    }

    void tell(FrameTimes& out) const {
        out.clock = host_.device->clock();
        if (out.clock == PassClock::timestamps) out.gpuFrameMs = quantile(gpuFrameMs_, 0.5);
        out.yardsticks = {summary("floor", floorMs_), summary("full_screen", fullScreenMs_)};
        out.passes = times_.passes.medians();
    }

    void forget() {
        times_ = {};
        gpuFrameMs_.clear(), floorMs_.clear(), fullScreenMs_.clear();
    }

  private:
    bool time(YardstickMs& beside, Error& error) {
        Device& device = *host_.device;
        if (device.clock() == PassClock::timestamps)
            return timeFrame(device, *host_.recorder, yardsticks_, times_, beside, error);
        const FrameTargets& targets = host_.recorder->targets();
        return timeStages(device, *host_.recorder, stages, times_, error) &&
               device.run(
                   [&](VkCommandBuffer commands, Error&) {
                       targets.copyScene(commands);
                       return true;
                   },
                   error) &&
               yardsticks_.time(targets, beside, error);
    }

    Host::Impl& host_;
    Yardsticks yardsticks_;
    StageTimes times_;
    std::vector<double> gpuFrameMs_, floorMs_, fullScreenMs_;
};

} // namespace

bool Host::Impl::timeFrame(const FrameDesc& frame, double& fenceMs, double& gpuMs, Error& error) {
    std::vector<TimedPass> passes;
    if (!recorder->begin(*scene, frame, error) ||
        !device->run([&](VkCommandBuffer commands,
                         Error& problem) { return recorder->recordFrame(commands, Heard::always, problem); },
                     error) ||
        !device->passes().collect(passes, error))
        return false;
    fenceMs = device->lastRunMs();
    gpuMs = msOf(passes, frameName);
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
    std::vector<double> ms;
    for (uint32_t i = 0; i < runs; ++i) {
        double fenceMs = 0, gpuMs = 0;
        if (!impl_->timeFrame(frame, fenceMs, gpuMs, error)) return std::nullopt;
        ms.push_back(clock() == PassClock::timestamps ? gpuMs : fenceMs);
    }
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
    Sampler sampler(impl);
    if (!sampler.create(frame, error)) return std::nullopt;
    std::vector<double> whole, simulate;
    for (uint32_t i = 0; i < Impl::warmUps + runs; ++i) {
        if (i == Impl::warmUps) {
            sampler.forget();
            whole.clear(), simulate.clear();
        }
        // Whole frames and stages alternate, so that both see the same machine.
        double fenceMs = 0, gpuMs = 0;
        if (!impl.timeFrame(frame, fenceMs, gpuMs, error)) return std::nullopt;
        whole.push_back(fenceMs);
        simulate.push_back(impl.recorder->cpuSimulateMs());
        if (!sampler.sample(frame, error)) return std::nullopt;
    }
    FrameTimes found;
    found.frameMs = quantile(whole, 0.5);
    found.cpuSimulateMs = quantile(simulate, 0.5);
    found.runs = runs;
    sampler.tell(found);
    return found;
}

} // namespace demos
