// A display of one's own, in memory.
#pragma once

#include <string>

#include <sys/types.h>

namespace tests {

class Xvfb {
  public:
    Xvfb();
    ~Xvfb();
    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;

    /// As $DISPLAY names it, or empty where there is none.
    const std::string& display() const { return display_; }

  private:
    pid_t server_ = -1;
    std::string display_;
};

} // namespace tests

/// In a test: skips it where no display can be made.
#define REQUIRE_DISPLAY(xvfb)                                                                                \
    if ((xvfb).display().empty()) GTEST_SKIP() << "Xvfb is not there or does not start (Debian: xvfb)"
