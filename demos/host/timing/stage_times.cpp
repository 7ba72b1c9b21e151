#include "host/timing/stage_times.h"

#include <algorithm>
#include <utility>

namespace demos {

namespace {

/// One sample for each name: some run in two stages.
void addByName(const std::vector<TimedPass>& passes, PassSamples& samples) {
    std::vector<std::pair<std::string, double>> sums;
    for (const TimedPass& pass : passes) {
        const auto known =
            std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == pass.name; });
        if (known == sums.end())
            sums.emplace_back(pass.name, pass.ms);
        else
            known->second += pass.ms;
    }
    for (const auto& [name, ms] : sums) samples.add(name, ms);
}

} // namespace

bool timeStage(Device& device, FrameRecorder& recorder, const StageName& stage, StageTimes& times,
               Error& error) {
    if (!recorder.needed(stage.stage)) return true;
    const bool ran =
        device.run([&](VkCommandBuffer commands,
                       Error& problem) { return recorder.record(commands, stage, Heard::timed, problem); },
                   error);
    if (!ran) return false;
    times.passes.add(stage.name, device.lastRunMs());
    if (stage.stage == Stage::mirrored) times.mirroredMs = device.lastRunMs();
    if (!stage.compute) return true;
    double passesMs = device.lastRunMs();
    if (device.timesComputePasses()) {
        std::vector<TimedPass> passes;
        if (!device.passes().collect(passes, error)) return false;
        passesMs = sumWithin(passes, stage.name);
        for (const TimedPass& pass : passes)
            if (pass.within == stage.name) times.passes.add(pass.name, pass.ms);
    }
    if (stage.stage == Stage::reflect) times.reflectionMs = std::exchange(times.mirroredMs, 0.0) + passesMs;
    return true;
}

bool timeStages(Device& device, FrameRecorder& recorder, std::span<const StageName> stages, StageTimes& times,
                Error& error) {
    for (const StageName& stage : stages)
        if (!timeStage(device, recorder, stage, times, error)) return false;
    return true;
}

bool timeFrame(Device& device, FrameRecorder& recorder, Yardsticks& yardsticks, StageTimes& times,
               YardstickMs& beside, Error& error) {
    PassTimer& timer = device.passes();
    const bool ran = device.run(
        [&](VkCommandBuffer commands, Error& problem) {
            yardsticks.wake(commands);
            if (!recorder.recordFrame(commands, Heard::timed, problem)) return false;
            yardsticks.record(commands, recorder.targets());
            return true;
        },
        error);
    std::vector<TimedPass> passes;
    if (!ran || !timer.collect(passes, error)) return false;
    beside = yardsticks.recorded(passes);
    times.gpuFrameMs = msOf(passes, frameName);
    times.reflectionMs = msOf(passes, nameOf(Stage::mirrored), frameName);
    // As much of it as no pass has is waiting between them.
    if (sumWithin(passes, nameOf(Stage::reflect)) > 0)
        times.reflectionMs += msOf(passes, nameOf(Stage::reflect), frameName);
    std::erase_if(passes, [](const TimedPass& pass) { return pass.within.empty(); });
    addByName(passes, times.passes);
    return true;
}

} // namespace demos
