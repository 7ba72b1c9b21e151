// --stats: what a frame costs, pass by pass.
#pragma once

#include <string>

#include "host/host.h"
#include "program/options.h"

namespace demos {

std::string statsJson(const DeviceInfo& device, const Size& size, const Scene& scene,
                      const CameraDesc& camera, const FrameTimes& times);
std::string statsTable(const FrameTimes& times);

} // namespace demos
