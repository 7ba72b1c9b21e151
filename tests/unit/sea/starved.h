// Memory that runs out: while a Starved lives, its thread gets only so many more allocations.
#pragma once

namespace seaglass::tests {

class Starved {
  public:
    explicit Starved(int allocations);
    Starved(const Starved&) = delete;
    Starved& operator=(const Starved&) = delete;
    ~Starved();
};

} // namespace seaglass::tests
