// A comparison in words and numbers.
#pragma once

#include <string>
#include <vector>

#include "metrics/compare.h"
#include "program/compare/judged.h"
#include "program/compare/pair.h"

namespace demos {

struct Measure {
    std::string name, value;
    std::string limit; ///< empty: none
};

std::vector<Measure> measures(const Comparison& comparison, PictureKind kind, const Limits& limits);

/// As lines of two or three columns.
std::string measuresTable(const std::vector<Measure>& measures);

std::string measuresJson(const Pair& pair, const CompareOptions& options);

/// The verdict and the measures; what is in a report comes after.
Judged judgedPair(const CompareOptions& options, const Pair& pair);

} // namespace demos
