// seaglass compare of two folders.
#pragma once

#include "program/compare/compare_options.h"
#include "program/exit_code.h"

namespace demos {

/// Whether either of the two is a folder.
bool areFolders(const CompareOptions& options);

/// Compares all that is in both, names what is in one alone, and writes what is asked for. What cannot be
/// read keeps nothing else from being compared.
ExitCode compareFolders(const CompareOptions& options, Error& error);

} // namespace demos
