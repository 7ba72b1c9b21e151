#include "reference/rows.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace demos::reference {

bool forEachRow(uint32_t rows, uint32_t threads, const std::function<void(uint32_t)>& work,
                const ProgressFunction& progress) {
    std::atomic<uint32_t> next{0};
    std::mutex told;
    uint32_t done = 0;
    bool stopped = false;
    const auto takeRows = [&] {
        for (uint32_t y = next++; y < rows; y = next++) {
            work(y);
            const std::scoped_lock lock(told);
            ++done;
            if (!progress || progress(done, rows)) continue;
            stopped = true;
            next = rows;
        }
    };
    const uint32_t wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> others;
    for (uint32_t i = 1; i < wanted; ++i) others.emplace_back(takeRows);
    takeRows();
    for (std::thread& other : others) other.join();
    return !stopped;
}

} // namespace demos::reference
