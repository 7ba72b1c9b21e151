// A picture's rows, shared out among threads.
#pragma once

#include <cstdint>
#include <functional>

namespace demos::reference {

/// Is told rows done and rows in all, by one thread at a time; false leaves the rest undone.
using ProgressFunction = std::function<bool(uint32_t, uint32_t)>;

/// Calls `work` once for each row, from so many threads; 0: as many as the machine has. False where it was
/// stopped.
bool forEachRow(uint32_t rows, uint32_t threads, const std::function<void(uint32_t)>& work,
                const ProgressFunction& progress);

} // namespace demos::reference
