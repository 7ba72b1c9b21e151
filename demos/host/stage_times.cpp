#include "host/stage_times.h"

#include <utility>

namespace demos {

bool timeStage(Device& device, FrameRecorder& recorder, const StageName& stage, StageTimes& times,
               Error& error) {
    if (!recorder.needed(stage.stage)) return true;
    PassTimer& timer = recorder.timer();
    const bool ran = device.run(
        [&](VkCommandBuffer commands, Error& problem) {
            if (stage.compute) timer.listen(commands);
            const bool recorded = recorder.record(commands, stage.stage, problem);
            timer.stop();
            return recorded;
        },
        error);
    if (!ran) return false;
    times.passes.add(stage.name, device.lastRunMs());
    if (stage.stage == Stage::mirrored) times.mirroredMs = device.lastRunMs();
    if (!stage.compute) return true;
    double passesMs = 0;
    for (const PassTime& pass : timer.collect()) {
        times.passes.add(pass.name, pass.ms);
        passesMs += pass.ms;
    }
    if (stage.stage == Stage::reflect)
        times.reflectionMs =
            std::exchange(times.mirroredMs, 0.0) + (device.timestampNs() > 0 ? passesMs : device.lastRunMs());
    return true;
}

bool timeStages(Device& device, FrameRecorder& recorder, std::span<const StageName> stages, StageTimes& times,
                Error& error) {
    for (const StageName& stage : stages)
        if (!timeStage(device, recorder, stage, times, error)) return false;
    return true;
}

} // namespace demos
