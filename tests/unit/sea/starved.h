// Memory that runs out: while a Starved lives, its thread gets only so many more allocations.
#pragma once

#include <cstddef>

namespace tests {

class Starved {
  public:
    explicit Starved(int allocations);
    Starved(const Starved&) = delete;
    Starved& operator=(const Starved&) = delete;
    ~Starved();
};

/// While it lives, a Starved does not count: what is tested of others' making.
class Fed {
  public:
    Fed();
    Fed(const Fed&) = delete;
    Fed& operator=(const Fed&) = delete;
    ~Fed();

  private:
    int left_;
};

/// Of all threads: what `new` gave and `delete` has not got back.
size_t allocationsHeld();

} // namespace tests
