// Long work that is interrupted ends with what is finished.
#pragma once

namespace demos {

/// While it lives, the first SIGINT or SIGTERM is remembered; the second ends the program as ever.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool wished() const;
};

} // namespace demos
