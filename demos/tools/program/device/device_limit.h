// Whether a device has pictures of a size, before anything is drawn.
#pragma once

#include "host/host.h"
#include "program/compare/values.h"

namespace demos {

/// False with `error` set when a side, times `supersample`, is longer than the device's images can be.
bool fitsDevice(const Size& size, uint32_t supersample, const DeviceInfo& device, Error& error);

} // namespace demos
