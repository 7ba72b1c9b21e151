#include "program/device/no_device.h"

#include "host/host.h"

namespace demos {

void explainNoDevice(Error& error) {
    Error found;
    if (!listDevices(found).empty()) return;
    const std::string why = found.text.empty() ? "no Vulkan device was found" : found.text;
    error.text = why + ", expected a Vulkan 1.3 device, such as lavapipe (Debian: mesa-vulkan-drivers)";
}

} // namespace demos
