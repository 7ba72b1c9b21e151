#pragma once

#include "program/exit_code.h"
#include "program/sea/sea_options.h"

namespace demos {

/// seaglass sea: simulates, measures, prints, plots. Needs no device.
ExitCode describeTheSea(const SeaOptions& options, Error& error);

} // namespace demos
