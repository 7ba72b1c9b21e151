// Times of a frame: whole from submission to fence, and by stage.
#include <algorithm>
#include <cmath>

#include "host/host_impl.h"

namespace demos {
namespace {

/// Interpolated quantile of samples.
double quantile(std::vector<double> samples, double q) {
    if (samples.empty()) return 0;
    std::sort(samples.begin(), samples.end());
    const double at = q * static_cast<double>(samples.size() - 1);
    const auto below = static_cast<size_t>(at);
    const size_t above = std::min(below + 1, samples.size() - 1);
    return samples[below] + (at - std::floor(at)) * (samples[above] - samples[below]);
}

/// Samples by pass, in the order the passes were first seen.
class PassSamples {
  public:
    void add(const std::string& name, double ms) {
        const auto known = std::find_if(samples_.begin(), samples_.end(),
                                        [&](const auto& entry) { return entry.first == name; });
        if (known == samples_.end())
            samples_.push_back({name, {ms}});
        else
            known->second.push_back(ms);
    }
    std::vector<PassTime> medians() const {
        std::vector<PassTime> times;
        for (const auto& [name, ms] : samples_)
            times.push_back({name, quantile(ms, 0.5), quantile(ms, 0.75) - quantile(ms, 0.25)});
        return times;
    }

  private:
    std::vector<std::pair<std::string, std::vector<double>>> samples_;
};

/// Runs the frame stage by stage, each waited for, so that a stage's time is its own.
bool measureStages(Device& device, FrameRecorder& recorder, PassSamples& samples, Error& error) {
    PassTimer& timer = recorder.timer();
    for (const StageName& stage : stages) {
        if (!recorder.needed(stage.stage)) continue;
        const bool ran = device.run(
            [&](VkCommandBuffer commands, Error& problem) {
                if (stage.compute) timer.listen(commands);
                const bool recorded = recorder.record(commands, stage.stage, problem);
                timer.stop();
                return recorded;
            },
            error);
        if (!ran) return false;
        samples.add(stage.name, device.lastRunMs());
        if (!stage.compute) continue;
        for (const PassTime& pass : timer.collect()) samples.add(pass.name, pass.ms);
    }
    return true;
}

} // namespace

std::optional<FrameTimes> Host::measure(const FrameDesc& frame, uint32_t runs, Error& error) {
    Impl& impl = *impl_;
    if (!impl.ready(error)) return std::nullopt;
    if (runs == 0) {
        error.text = "measuring needs at least one run";
        return std::nullopt;
    }
    constexpr uint32_t warmUps = 2; // the first compiles pipelines on some drivers, the second settles memory
    std::vector<double> whole, simulate;
    PassSamples samples;
    for (uint32_t i = 0; i < warmUps + runs; ++i) {
        const bool warm = i >= warmUps;
        PassSamples ignored;
        // Whole frames and stages alternate, so that both see the same machine.
        if (!impl.recorder.begin(*impl.scene, frame, error) ||
            !impl.device->run(
                [&](VkCommandBuffer commands, Error& problem) { return impl.recordFrame(commands, problem); },
                error))
            return std::nullopt;
        if (warm) {
            whole.push_back(impl.device->lastRunMs());
            simulate.push_back(impl.recorder.cpuSimulateMs());
        }
        if (!impl.recorder.begin(*impl.scene, frame, error) ||
            !measureStages(*impl.device, impl.recorder, warm ? samples : ignored, error))
            return std::nullopt;
    }
    FrameTimes times;
    times.frameMs = quantile(whole, 0.5);
    times.cpuSimulateMs = impl.scene->water ? quantile(simulate, 0.5) : 0;
    times.runs = runs;
    times.passes = samples.medians();
    return times;
}

} // namespace demos
