// GPU times of the passes that announce themselves, by timestamps.
#pragma once

#include <vector>

#include "host/device.h"

namespace demos {

/// Timestamps are right around compute passes; around draws a tiling or software device makes them up, so
/// passes are heard only while listening.
class PassTimer {
  public:
    bool create(const Device& device, Error& error);
    /// Recorded at the start of a command buffer; passes are heard until stop().
    void listen(VkCommandBuffer commands);
    void stop() { listening_ = false; }
    void mark(VkCommandBuffer commands, const char* pass, bool begins);
    /// The passes since listen(), in milliseconds, once the GPU has finished. Repeats are summed.
    std::vector<PassTime> collect() const;

  private:
    static constexpr uint32_t capacity = 256;

    const Device* device_ = nullptr;
    UniqueQueryPool pool_;
    bool listening_ = false;
    struct Span {
        std::string name;
        uint32_t begin = 0, end = UINT32_MAX;
    };
    std::vector<Span> spans_;
    uint32_t used_ = 0;
};

} // namespace demos
