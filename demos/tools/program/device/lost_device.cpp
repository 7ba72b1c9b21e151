#include "program/device/lost_device.h"

#include <cstdio>
#include <cstdlib>

#include "program/exit_code.h"

namespace demos {

void endIfLost(const Host& host, const Error& error) {
    if (!host.lost()) return;
    std::fprintf(stderr, "%s\n", error.text.c_str());
    std::fflush(nullptr);
    std::_Exit(runFailed);
}

} // namespace demos
