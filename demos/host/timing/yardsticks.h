// What costs are given as multiples of: the floor and a trivial pass.
#pragma once

#include "host/passes/full_screen_pass.h"
#include "host/timing/timed_floor.h"

namespace demos {

/// Milliseconds of one round.
struct YardstickMs {
    double floor = 0, fullScreen = 0;
};

class Yardsticks {
  public:
    /// For frames of this size.
    bool create(Device& device, VkExtent2D extent, Error& error);
    /// Each alone in its submission. The targets are as copyScene() leaves them.
    bool time(const FrameTargets& targets, YardstickMs& out, Error& error);

    void wake(VkCommandBuffer commands) const { floor_.wake(commands); }
    /// Both as passes, behind a frame in the same submission, of which they copy the picture.
    void record(VkCommandBuffer commands, const FrameTargets& targets);
    /// Of what record() recorded, among all passes of its submission.
    YardstickMs recorded(const std::vector<TimedPass>& passes);

  private:
    Device* device_ = nullptr;
    TimedFloor floor_;
    FullScreenPass fullScreen_;
};

} // namespace demos
