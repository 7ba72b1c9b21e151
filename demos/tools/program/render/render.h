#pragma once

#include "program/exit_code.h"
#include "program/options.h"

namespace demos {

/// seaglass render: checks everything, renders, writes, says what it did.
ExitCode renderScene(const RenderOptions& options, Error& error);

} // namespace demos
