// What the stages of a frame take: each alone in its submission, or all in one that is recorded whole.
#pragma once

#include <span>

#include "host/timing/pass_samples.h"
#include "host/timing/yardsticks.h"
#include "host/vulkan/frame_recorder.h"

namespace demos {

/// What reflections take of a frame.
struct StageTimes {
    PassSamples passes;
    double mirroredMs = 0;   ///< of a Stage::mirrored that Stage::reflect has not followed yet
    double reflectionMs = 0; ///< of the stage Stage::reflect that ran last, and the Stage::mirrored before it
    double gpuFrameMs = 0;   ///< of the frame that timeFrame() timed last
};

/// Runs one stage, if it is needed, and waits for it: from submission to fence. Adds the stage and, of
/// compute, its passes by timestamps.
bool timeStage(Device& device, FrameRecorder& recorder, const StageName& stage, StageTimes& times,
               Error& error);
bool timeStages(Device& device, FrameRecorder& recorder, std::span<const StageName> stages, StageTimes& times,
                Error& error);

/// Records all stages that are needed into one submission, once the device is awake, and the yardsticks
/// behind them, and waits. Adds the stages and all their passes, by timestamps.
bool timeFrame(Device& device, FrameRecorder& recorder, Yardsticks& yardsticks, StageTimes& times,
               YardstickMs& beside, Error& error);

} // namespace demos
