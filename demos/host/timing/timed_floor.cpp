#include "host/timing/timed_floor.h"

#include <algorithm>
#include <cmath>

namespace demos {

namespace {

constexpr const char* name = "floor";
constexpr double wakingMs = 5;

} // namespace

bool TimedFloor::create(Device& device, VkExtent2D extent, Error& error) {
    device_ = &device;
    return floor_.create(device, extent, error);
}

bool TimedFloor::time(double& ms, Error& error) {
    const bool stamped = device_->timesComputePasses();
    const bool ran = device_->run(
        [&](VkCommandBuffer commands, Error&) {
            // By the fence the unseen one would be seen.
            if (stamped)
                record(commands);
            else
                floor_.record(commands);
            return true;
        },
        error);
    if (!ran) return false;
    ms = device_->lastRunMs();
    if (!stamped) return true;
    std::vector<TimedPass> passes;
    if (!device_->passes().collect(passes, error)) return false;
    ms = msOf(passes, name);
    return true;
}

void TimedFloor::wake(VkCommandBuffer commands) const {
    for (uint32_t i = 0; i < copies_; ++i) floor_.record(commands);
}

void TimedFloor::record(VkCommandBuffer commands) {
    // Once unseen: what is timed is the copy, not the waking of the device or the caches of what ran before.
    floor_.record(commands);
    PassTimer& passes = device_->passes();
    passes.separate(true);
    passes.mark(commands, name, true);
    floor_.record(commands);
    passes.mark(commands, name, false);
    passes.separate(false);
}

double TimedFloor::recordedMs(const std::vector<TimedPass>& passes) {
    const double ms = msOf(passes, name);
    if (ms > 0) copies_ = static_cast<uint32_t>(std::clamp(std::ceil(wakingMs / ms), 2.0, 500.0));
    return ms;
}

} // namespace demos
