#pragma once

#include <string>

#include "measure/tradeoff.h"

namespace demos::measure {

/// What was not measured is null.
std::string tradeoffJson(const Tradeoff& tradeoff);
/// One line an entry, under a line of names. What was not measured is empty.
std::string tradeoffCsv(const Tradeoff& tradeoff);
/// A table for each scene, in the columns that a reader compares. What was not measured is a dash.
std::string tradeoffMarkdown(const Tradeoff& tradeoff);

} // namespace demos::measure
