#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// Error (FLIP of the water) against cost (multiples of the floor) of one sheet's entries as an SVG element;
/// those that no other beats in both are joined. Entries that lack either number are left out.
std::string plotSvg(const Tradeoff& tradeoff, const Sheet& sheet);

} // namespace demos::measure
