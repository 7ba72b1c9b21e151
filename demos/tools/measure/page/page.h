#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// Bytes of what goes with a sheet.
struct SheetFiles {
    std::string png; ///< the contact sheet
    std::string svg; ///< the plot; empty where there is none
};

/// One HTML page with everything in it; `files` has one element for each sheet.
std::string tradeoffPage(const Tradeoff& tradeoff, const std::vector<SheetFiles>& files);

} // namespace demos::measure
