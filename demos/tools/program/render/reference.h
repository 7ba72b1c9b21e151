#pragma once

#include "program/exit_code.h"
#include "program/options.h"

namespace demos {

/// seaglass reference: checks everything, traces, writes, says what it did. Needs no Vulkan device.
ExitCode renderReference(const ReferenceOptions& options, Error& error);

} // namespace demos
