// The floor as a pass that is timed, and as what wakes a device.
#pragma once

#include "host/passes/floor_pass.h"
#include "host/timing/pass_timer.h"

namespace demos {

class TimedFloor {
  public:
    /// Of frames of this size.
    bool create(Device& device, VkExtent2D extent, Error& error);
    /// Alone in its submission.
    bool time(double& ms, Error& error);
    /// Copies that nobody times, for some milliseconds: a device that slept is awake then, at full speed.
    void wake(VkCommandBuffer commands) const;
    /// As a pass among others.
    void record(VkCommandBuffer commands);
    /// Of what record() recorded, among all passes of its submission.
    double recordedMs(const std::vector<TimedPass>& passes);

  private:
    Device* device_ = nullptr;
    FloorPass floor_;
    uint32_t copies_ = 8; ///< of wake()
};

} // namespace demos
