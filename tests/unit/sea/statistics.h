// Of many values alike.
#pragma once

#include <cmath>
#include <vector>

namespace tests {

inline double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// Standard deviation.
inline double deviationOf(const std::vector<double>& values) {
    const double mean = meanOf(values);
    double sum = 0;
    for (const double v : values) sum += (v - mean) * (v - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Pearson's.
inline double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
    const double meanA = meanOf(a), meanB = meanOf(b);
    double both = 0;
    for (size_t i = 0; i < a.size(); ++i) both += (a[i] - meanA) * (b[i] - meanB);
    return both / static_cast<double>(a.size()) / (deviationOf(a) * deviationOf(b));
}

} // namespace tests
