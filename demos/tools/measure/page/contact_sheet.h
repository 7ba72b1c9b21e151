#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// Pictures side by side, two in a row.
struct ContactSheet {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

/// The reference first, then a picture of each entry, all of this size.
ContactSheet contactSheet(const ViewResult& view, uint32_t width, uint32_t height);

} // namespace demos::measure
