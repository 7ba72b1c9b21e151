// Times of a frame: whole from submission to fence, and by stage.
#include <algorithm>
#include <cmath>

#include "host/floor_pass.h"
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

PassTime summary(const std::string& name, const std::vector<double>& ms) {
    return {name, quantile(ms, 0.5), quantile(ms, 0.75) - quantile(ms, 0.25)};
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
        for (const auto& [name, ms] : samples_) times.push_back(summary(name, ms));
        return times;
    }

  private:
    std::vector<std::pair<std::string, std::vector<double>>> samples_;
};

/// Runs the frame stage by stage, each waited for, so that a stage's time is its own. `reflectionMs` is what
/// the passes of reflections take together.
bool measureStages(Device& device, FrameRecorder& recorder, PassSamples& samples, double& reflectionMs,
                   Error& error) {
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
        double passesMs = 0;
        for (const PassTime& pass : timer.collect()) {
            samples.add(pass.name, pass.ms);
            passesMs += pass.ms;
        }
        if (stage.stage == Stage::reflect)
            reflectionMs = device.timestampNs() > 0 ? passesMs : device.lastRunMs();
    }
    return true;
}

bool measureFloor(Device& device, PassTimer& timer, const FloorPass& floor, std::vector<double>& ms,
                  Error& error) {
    const bool ran = device.run(
        [&](VkCommandBuffer commands, Error&) {
            timer.listen(commands);
            // Once unseen: what is timed is the copy, not the waking of the device.
            floor.record(commands);
            timer.mark(commands, "floor", true);
            floor.record(commands);
            timer.mark(commands, "floor", false);
            timer.stop();
            return true;
        },
        error);
    if (!ran) return false;
    const std::vector<PassTime> timed = timer.collect();
    ms.push_back(timed.empty() ? device.lastRunMs() : timed.front().ms);
    return true;
}

} // namespace

std::optional<FrameTimes> Host::measure(const FrameDesc& frame, uint32_t runs, Error& error, bool withFloor) {
    Impl& impl = *impl_;
    if (!impl.ready(error)) return std::nullopt;
    if (runs == 0) {
        error.text = "measuring needs at least one run";
        return std::nullopt;
    }
    constexpr uint32_t warmUps = 2; // the first compiles pipelines on some drivers, the second settles memory
    FloorPass floor;
    if (withFloor && !floor.create(*impl.device, {frame.width, frame.height}, error)) return std::nullopt;
    std::vector<double> whole, simulate, reflection, floorMs;
    PassSamples samples;
    for (uint32_t i = 0; i < warmUps + runs; ++i) {
        const bool warm = i >= warmUps;
        PassSamples ignored;
        double reflectionMs = 0;
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
            !measureStages(*impl.device, impl.recorder, warm ? samples : ignored, reflectionMs, error))
            return std::nullopt;
        if (warm) reflection.push_back(reflectionMs);
        std::vector<double> first;
        if (withFloor &&
            !measureFloor(*impl.device, impl.recorder.timer(), floor, warm ? floorMs : first, error))
            return std::nullopt;
    }
    FrameTimes times;
    times.frameMs = quantile(whole, 0.5);
    times.cpuSimulateMs = impl.scene->water ? quantile(simulate, 0.5) : 0;
    times.runs = runs;
    times.passes = samples.medians();
    times.reflection = summary("reflection", reflection);
    if (withFloor) times.floor = summary("floor", floorMs);
    return times;
}

} // namespace demos
