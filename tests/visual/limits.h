#pragma once

#include "demos/tools/metrics/compare.h"

namespace tests {

/// Of golden pictures. Wide enough for another CPU's rounding, which moves a few wave crests and edges by a
/// pixel; too narrow for a change that an eye would see.
inline demos::Limits goldenLimits() {
    const demos::ShareLimit little = {3.0 / 255, 0.01}, lot = {24.0 / 255, 0.0005};
    return {0.02, 0.5 / 255, {little, lot}};
}

} // namespace tests
