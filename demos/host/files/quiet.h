#pragma once

namespace demos {

/// Nothing reaches stderr while one lives. libpng prints what is wrong with a file, beside handing it over as
/// an error. Not for several threads.
class QuietStderr {
  public:
    QuietStderr();
    ~QuietStderr();
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;

  private:
    int kept_ = -1; ///< where stderr went before
};

} // namespace demos
