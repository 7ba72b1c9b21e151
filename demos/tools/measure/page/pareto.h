#pragma once

#include <vector>

namespace demos::measure {

struct Point {
    double cost = 0, error = 0;
};

/// For each point whether none is better in one and as good in the other.
std::vector<bool> paretoFront(const std::vector<Point>& points);

} // namespace demos::measure
