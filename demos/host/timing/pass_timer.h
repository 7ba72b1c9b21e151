// The passes of a command buffer as the device went through them, by timestamps: how long each took, and
// which one it did not come back from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/host_desc.h"
#include "host/vulkan/vk_handle.h"

namespace demos {

struct TimedPass {
    std::string name;
    std::string within; ///< the pass around it, if there is one
    double ms = 0;
};

/// 0 where it was not heard. A pass that is within no other, if `within` is empty.
double msOf(const std::vector<TimedPass>& passes, const std::string& name, const std::string& within = "");

/// Of the passes directly within one.
double sumWithin(const std::vector<TimedPass>& passes, const std::string& within);

/// Timestamps are right around compute passes; around draws a software device makes them up.
class PassTimer {
  public:
    /// `tickNs` 0 is a queue without timestamps: nothing is marked then. `late` devices take a timestamp when
    /// the commands behind it may have begun.
    bool create(VkDevice device, double tickNs, uint32_t validBits, bool late, Error& error);
    /// Forgets what was marked, and from here on hears what is recorded into this command buffer alone.
    void begin(VkCommandBuffer commands);
    void end() { commands_ = VK_NULL_HANDLE; }
    void mark(VkCommandBuffer commands, const char* pass, bool begins);
    /// Whether passes are kept from beginning before their timestamps where the device takes them late: by
    /// barriers, so outside of renderings alone.
    void separate(bool on) { separate_ = on && late_; }
    /// Milliseconds of the passes since begin(), once the device has finished. Repeats within the same pass
    /// are summed.
    bool collect(std::vector<TimedPass>& out, Error& error) const;
    /// The pass that has begun and not ended, while the device works or when it never will have finished:
    /// "ssr_march (reflect)". Empty where there is none; nullopt where the device does not tell.
    std::optional<std::string> unfinished() const;
    /// The first pass that is within no other; empty where nothing was marked.
    std::string outermost() const { return spans_.empty() ? "" : spans_.front().name; }

  private:
    static constexpr uint32_t capacity = 512; ///< of a submission
    static constexpr size_t none = SIZE_MAX;

    struct Span {
        std::string name;
        size_t around = none; ///< of spans_
        uint32_t begin = 0, end = UINT32_MAX;
    };

    /// All that were written, `bytesEach` apart.
    VkResult read(void* into, size_t bytesEach, VkQueryResultFlags flags) const;

    VkDevice device_ = VK_NULL_HANDLE;
    double tickNs_ = 0;
    uint64_t validTicks_ = 0;
    bool late_ = false, separate_ = false, full_ = false;
    UniqueQueryPool pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    std::vector<Span> spans_;
    size_t open_ = none; ///< the innermost span that has not ended
    /// Of the pool: two submissions take its halves by turns. So what is read before the device has come to
    /// the reset is of no earlier one.
    uint32_t first_ = 0;
    uint32_t used_ = 0;
};

} // namespace demos
