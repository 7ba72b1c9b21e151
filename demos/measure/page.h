#pragma once

#include "measure/tradeoff.h"

namespace demos::measure {

/// One HTML page with everything in it: tables, plots, and each sheet's PNG from `sheets`, which are bytes.
std::string tradeoffPage(const Tradeoff& tradeoff, const std::vector<std::string>& sheets);

} // namespace demos::measure
