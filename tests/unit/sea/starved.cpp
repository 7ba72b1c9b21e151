#include "tests/unit/sea/starved.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local int allocationsLeft = -1; // negative: any number
std::atomic<size_t> held = 0;

} // namespace

// In a file of their own: inlined next to each other they make GCC 12 see mismatched pairs.
void* operator new(size_t size) {
    if (allocationsLeft == 0) throw std::bad_alloc();
    if (allocationsLeft > 0) --allocationsLeft;
    if (void* memory = std::malloc(size ? size : 1)) {
        held.fetch_add(1, std::memory_order_relaxed);
        return memory;
    }
    throw std::bad_alloc();
}
// Else a sanitizer's own would come in between.
void* operator new(size_t size, const std::nothrow_t&) noexcept {
    try {
        return operator new(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept {
    if (memory) held.fetch_sub(1, std::memory_order_relaxed);
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    operator delete(memory);
}

namespace tests {

Starved::Starved(int allocations) {
    allocationsLeft = allocations;
}
Starved::~Starved() {
    allocationsLeft = -1;
}

Fed::Fed() : left_(allocationsLeft) {
    allocationsLeft = -1;
}
Fed::~Fed() {
    allocationsLeft = left_;
}

size_t allocationsHeld() {
    return held.load(std::memory_order_relaxed);
}

} // namespace tests
