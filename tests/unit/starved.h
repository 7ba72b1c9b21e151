// Memory that runs out: while a Starved lives, its thread gets only so many more allocations.
#ifndef SEAGLASS_TESTS_UNIT_STARVED_H
#define SEAGLASS_TESTS_UNIT_STARVED_H

namespace seaglass::tests {

class Starved {
  public:
    explicit Starved(int allocations);
    Starved(const Starved&) = delete;
    Starved& operator=(const Starved&) = delete;
    ~Starved();
};

} // namespace seaglass::tests

#endif
