// Times of passes over many frames, and what they come to.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/host.h"

namespace demos {

/// Interpolated, 0..1; 0 of nothing.
double quantile(std::vector<double> samples, double q);

/// Median and interquartile range.
PassTime summary(const std::string& name, const std::vector<double>& ms);

/// Samples by pass, in the order in which the passes were first seen.
class PassSamples {
  public:
    void add(const std::string& name, double ms);
    std::vector<PassTime> medians() const;

  private:
    std::vector<std::pair<std::string, std::vector<double>>> samples_;
};

} // namespace demos
