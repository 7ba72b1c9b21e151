#include "host/timing/yardsticks.h"

namespace demos {

namespace {

constexpr const char* fullScreenName = "full_screen";

} // namespace

bool Yardsticks::create(Device& device, VkExtent2D extent, Error& error) {
    device_ = &device;
    return floor_.create(device, extent, error) && fullScreen_.create(device, error);
}

bool Yardsticks::time(const FrameTargets& targets, YardstickMs& out, Error& error) {
    if (!floor_.time(out.floor, error)) return false;
    const bool ran = device_->run(
        [&](VkCommandBuffer commands, Error&) {
            fullScreen_.record(*device_, commands, targets);
            return true;
        },
        error);
    out.fullScreen = device_->lastRunMs();
    return ran;
}

void Yardsticks::record(VkCommandBuffer commands, const FrameTargets& targets) {
    PassTimer& passes = device_->passes();
    targets.copyScene(commands);
    passes.mark(commands, fullScreenName, true);
    fullScreen_.record(*device_, commands, targets);
    passes.mark(commands, fullScreenName, false);
    floor_.record(commands);
}

YardstickMs Yardsticks::recorded(const std::vector<TimedPass>& passes) {
    return {floor_.recordedMs(passes), msOf(passes, fullScreenName)};
}

} // namespace demos
