// A device that was lost or hangs ends the program.
#pragma once

#include "host/host.h"

namespace demos {

/// Where it is so: says `error` and ends with runFailed, at once. Drivers wait for a hung device when it is
/// destroyed, and when the program returns.
void endIfLost(const Host& host, const Error& error);

} // namespace demos
