#pragma once

namespace demos {

/// What the program tells its caller.
enum ExitCode : int {
    ok = 0,
    runFailed = 1,     ///< the device, the disk or validation objected while rendering
    different = 1,     ///< compare: beyond the limits
    badInput = 2,      ///< nothing was rendered and nothing written
    interrupted = 130, ///< by SIGINT or SIGTERM, as shells say it; what was finished is written
};

} // namespace demos
