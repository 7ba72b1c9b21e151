#include "host/timing/pass_clock.h"

namespace demos {

PassClock clockOf(PassClock wanted, VkPhysicalDeviceType type, bool hasTimestamps) {
    const bool cpu = type == VK_PHYSICAL_DEVICE_TYPE_CPU;
    if (wanted == PassClock::fence || (wanted == PassClock::processor && cpu)) return wanted;
    // lavapipe's timestamps around draws are made up: 75 ms in all where the wall said 692.
    return hasTimestamps && (!cpu || wanted == PassClock::timestamps) ? PassClock::timestamps
                                                                      : PassClock::fence;
}

const char* toString(PassClock clock) {
    switch (clock) {
    case PassClock::automatic:
        return "automatic";
    case PassClock::timestamps:
        return "timestamps";
    case PassClock::fence:
        return "fence";
    case PassClock::processor:
        return "processor";
    }
    return "";
}

const char* describe(PassClock clock) {
    switch (clock) {
    case PassClock::automatic:
        return "the clock that the device is right by";
    case PassClock::timestamps:
        return "timestamps, frames whole";
    case PassClock::fence:
        return "fence, stage by stage, compute passes by timestamps";
    case PassClock::processor:
        return "processor time, stage by stage";
    }
    return "";
}

} // namespace demos
