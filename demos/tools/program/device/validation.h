// What validation says of a run that went well otherwise.
#pragma once

#include "host/host.h"
#include "program/exit_code.h"

namespace demos {

ExitCode judgeValidation(const Host& host, Error& error);

} // namespace demos
