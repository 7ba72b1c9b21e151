#pragma once

#include "program/exit_code.h"
#include "program/view_options.h"

namespace demos {

/// seaglass view: checks everything, opens a window, shows frames until it is closed.
ExitCode viewScene(const ViewOptions& options, Error& error);

} // namespace demos
