// A stage of a frame alone in its submission, so that its time is its own.
#pragma once

#include <span>

#include "host/frame_recorder.h"
#include "host/pass_samples.h"

namespace demos {

/// What reflections take of a frame. By submit and fence on a device without timestamps, as is all that is
/// drawn.
struct StageTimes {
    PassSamples passes;
    double mirroredMs = 0;   ///< of a Stage::mirrored that Stage::reflect has not followed yet
    double reflectionMs = 0; ///< of the stage Stage::reflect that ran last, and the Stage::mirrored before it
};

/// Runs one stage, if it is needed, and waits for it. Adds the stage and, of compute, its passes.
bool timeStage(Device& device, FrameRecorder& recorder, const StageName& stage, StageTimes& times,
               Error& error);
bool timeStages(Device& device, FrameRecorder& recorder, std::span<const StageName> stages, StageTimes& times,
                Error& error);

} // namespace demos
