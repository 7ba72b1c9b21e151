#pragma once

#include "program/compare/judged.h"

namespace demos {

/// As CI services read it: a suite of one case a picture. What differs is a failure, what cannot be compared
/// an error.
std::string junitXml(const std::vector<Judged>& all);

} // namespace demos
