#include "tests/unit/sea/starved.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local int allocationsLeft = -1; // negative: any number

} // namespace

// In a file of their own: inlined next to each other they make GCC 12 see mismatched pairs.
void* operator new(size_t size) {
    if (allocationsLeft == 0) throw std::bad_alloc();
    if (allocationsLeft > 0) --allocationsLeft;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}

namespace seaglass::tests {

Starved::Starved(int allocations) {
    allocationsLeft = allocations;
}
Starved::~Starved() {
    allocationsLeft = -1;
}

} // namespace seaglass::tests
