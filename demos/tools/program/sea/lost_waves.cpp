#include "program/sea/lost_waves.h"

#include <cstdio>

namespace demos {

void warnOfLostWaves(double resolvedShare, double least, const std::string& beginning,
                     const std::string& patch, const std::string& samples) {
    if (resolvedShare >= least) return;
    std::fprintf(
        stderr,
        "warning: %sthe cascades hold %.0f %% of the height's variance asked for, expected %.0f: waves "
        "are too long for %s, or too short for %s\n",
        beginning.c_str(), 100 * resolvedShare, 100 * least, patch.c_str(), samples.c_str());
}

} // namespace demos
