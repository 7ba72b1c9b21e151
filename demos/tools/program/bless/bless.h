#pragma once

#include "program/bless/bless_options.h"
#include "program/exit_code.h"

namespace demos {

/// seaglass bless: says how new pictures differ from their references, and makes those that are chosen
/// references.
ExitCode blessPictures(const BlessOptions& options, Error& error);

} // namespace demos
