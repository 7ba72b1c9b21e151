// What times are taken by.
#pragma once

#include <volk.h>

#include "host/host.h"

namespace demos {

/// What `wanted` comes to on a device; `hasTimestamps` is of its queue. Never PassClock::automatic.
PassClock clockOf(PassClock wanted, VkPhysicalDeviceType type, bool hasTimestamps);

} // namespace demos
