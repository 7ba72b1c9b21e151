// Tells the host of a pipeline that its driver compiles for so long that the program seems to hang.
#pragma once

#include <chrono>

#include "gpu/device.h"

namespace seaglass::gpu {

/// Around the making of one pipeline; `what` is its name.
class CompileWatch {
  public:
    CompileWatch(const Device& device, const char* what)
        : device_(device), what_(what), began_(std::chrono::steady_clock::now()) {}
    ~CompileWatch() {
        constexpr double patienceS = 10;
        const double passedS =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
        if (passedS > patienceS)
            device_.warn("%s: the driver compiled it for %.0f s, expected %.0f at most", what_, passedS,
                         patienceS);
    }
    CompileWatch(const CompileWatch&) = delete;
    CompileWatch& operator=(const CompileWatch&) = delete;

  private:
    const Device& device_;
    const char* what_;
    std::chrono::steady_clock::time_point began_;
};

} // namespace seaglass::gpu
