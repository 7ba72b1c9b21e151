#pragma once

#include "program/exit_code.h"
#include "program/measure/measure_options.h"

namespace demos {

/// seaglass measure: reads every scene, measures, writes, says what it found.
ExitCode measureTechniques(const MeasureOptions& options, Error& error);

} // namespace demos
