// Antialiasing by brute force: a picture rendered larger, averaged down.
#pragma once

#include "host/host.h"

namespace demos {

/// Each pixel the mean of factor^2; the sides of `large` are multiples of `factor`.
Picture averaged(const Picture& large, uint32_t factor);

} // namespace demos
