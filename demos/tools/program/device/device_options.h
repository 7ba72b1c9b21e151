// What the command line says of the device that draws.
#pragma once

#include <string>

#include "program/render/render_options.h"

namespace CLI {
class App;
}

namespace demos {

/// What the line says, before any of it is checked.
struct RawDevice {
    std::string device;
    bool validation = false, noValidation = false;
};

void describeDevice(CLI::App& command, RawDevice& raw);
bool checkDevice(const RawDevice& raw, RenderOptions& out, Error& error);

} // namespace demos
