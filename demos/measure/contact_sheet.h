#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// Pictures side by side, two in a row.
struct ContactSheet {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

/// Of pictures of one size.
ContactSheet contactSheet(const Sheet& sheet, uint32_t width, uint32_t height);

} // namespace demos::measure
