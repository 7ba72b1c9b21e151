#include "program/device/validation.h"

namespace demos {

ExitCode judgeValidation(const Host& host, Error& error) {
    const uint32_t messages = host.validationMessages();
    if (messages == 0) return ok;
    error.text =
        "validation: " + std::to_string(messages) + " messages, expected none (they are printed above)";
    return runFailed;
}

} // namespace demos
