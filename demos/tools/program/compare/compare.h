#pragma once

#include "program/compare/compare_options.h"
#include "program/exit_code.h"

namespace demos {

/// seaglass compare: reads both pictures, measures, says and writes what it found.
ExitCode comparePictures(const CompareOptions& options, Error& error);

} // namespace demos
