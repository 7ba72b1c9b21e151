// How time passes from frame to frame.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace demos {

class Clock {
  public:
    /// By fixed steps in seconds, or without them by the clock.
    explicit Clock(std::optional<double> stepS) : stepS_(stepS) {}

    bool fixed() const { return stepS_.has_value(); }
    /// Seconds since it was last asked, 0 at first.
    double passed() {
        const auto now = std::chrono::steady_clock::now();
        const double real = std::chrono::duration<double>(now - last_.value_or(now)).count();
        const double step = last_ ? stepS_.value_or(std::min(real, longestS)) : 0;
        last_ = now;
        return step;
    }

  private:
    /// After a stop for loading, nothing leaps.
    static constexpr double longestS = 1;

    std::optional<double> stepS_;
    std::optional<std::chrono::steady_clock::time_point> last_;
};

} // namespace demos
