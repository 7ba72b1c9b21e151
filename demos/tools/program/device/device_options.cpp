#include "program/device/device_options.h"

#include <CLI/CLI.hpp>

namespace demos {

void describeDevice(CLI::App& command, RawDevice& raw) {
    command.add_option("--device", raw.device, "Part of a device's name; the best device if not given")
        ->type_name("NAME");
    command.add_flag("--validation", raw.validation, "Vulkan validation; any message makes the exit code 1");
    command.add_flag("--no-validation", raw.noValidation, "No Vulkan validation");
}

bool checkDevice(const RawDevice& raw, RenderOptions& out, Error& error) {
    out.device = raw.device;
    if (raw.validation && raw.noValidation) {
        error.text = "--validation and --no-validation exclude each other";
        return false;
    }
    out.validation = raw.validation || (SEAGLASS_VALIDATION && !raw.noValidation);
    return true;
}

} // namespace demos
