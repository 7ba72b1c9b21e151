#include "program/device/device_limit.h"

#include <algorithm>

namespace demos {

bool fitsDevice(const Size& size, uint32_t supersample, const DeviceInfo& device, Error& error) {
    if (std::max(size.width, size.height) * supersample <= device.longestSide) return true;
    error.text = "--size is '" + std::to_string(size.width) + "x" + std::to_string(size.height) + "'";
    if (supersample > 1) error.text += " and --supersample is '" + std::to_string(supersample) + "'";
    error.text += ", expected at most " + std::to_string(device.longestSide) + " pixels a side in all on " +
                  device.name;
    return false;
}

} // namespace demos
