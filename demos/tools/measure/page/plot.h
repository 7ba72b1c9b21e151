#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// A script by which gnuplot draws error (FLIP of the water) against cost (multiples of the floor) of one
/// sheet's entries into `svg`. Those that no other beats in both are joined. What costs nothing stands left
/// of the logarithmic axis' least cost. Entries that lack either number are left out.
std::string plotScript(const Tradeoff& tradeoff, const Sheet& sheet, const std::string& svg);

} // namespace demos::measure
