// A comparison in words and numbers.
#pragma once

#include <string>
#include <vector>

#include "metrics/compare.h"
#include "program/compare/compare_options.h"

namespace demos {

struct Measure {
    std::string name, value;
    std::string limit; ///< empty: none
};

std::vector<Measure> measures(const Comparison& comparison, PictureKind kind, const Limits& limits);

/// As lines of two or three columns.
std::string measuresTable(const std::vector<Measure>& measures);

std::string measuresJson(const Comparison& comparison, PictureKind kind, const CompareOptions& options,
                         const Image& size);

} // namespace demos
