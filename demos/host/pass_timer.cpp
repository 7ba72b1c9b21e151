#include "host/pass_timer.h"

#include <algorithm>

namespace demos {

namespace {

void waitForAll(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

} // namespace

bool PassTimer::create(const Device& device, Error& error) {
    device_ = &device;
    if (device.timestampNs() == 0) return true;
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = capacity;
    VkQueryPool pool = VK_NULL_HANDLE;
    if (!succeeded(vkCreateQueryPool(device.handle(), &info, nullptr, &pool), "vkCreateQueryPool", error))
        return false;
    pool_ = UniqueQueryPool(device.handle(), pool);
    return true;
}

void PassTimer::listen(VkCommandBuffer commands) {
    spans_.clear();
    used_ = 0;
    listening_ = static_cast<bool>(pool_);
    if (listening_) vkCmdResetQueryPool(commands, pool_.get(), 0, capacity);
}

void PassTimer::mark(VkCommandBuffer commands, const char* pass, bool begins) {
    if (!listening_ || used_ == capacity) return;
    if (begins) {
        spans_.push_back({pass, used_, UINT32_MAX});
    } else {
        const auto open = std::find_if(spans_.rbegin(), spans_.rend(), [&](const Span& span) {
            return span.end == UINT32_MAX && span.name == pass;
        });
        if (open == spans_.rend()) return;
        open->end = used_;
    }
    // A pass begins when all before it has ended: at the top of the pipe its time would hold theirs, or they
    // its.
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(), used_++);
    // lavapipe takes the time at its next flush: without a barrier here that can be after the pass's first
    // dispatch.
    if (begins) waitForAll(commands);
}

std::vector<PassTime> PassTimer::collect() const {
    std::vector<PassTime> times;
    if (used_ == 0) return times;
    std::vector<uint64_t> ticks(used_);
    if (vkGetQueryPoolResults(device_->handle(), pool_.get(), 0, used_, used_ * sizeof(uint64_t),
                              ticks.data(), sizeof(uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT) != VK_SUCCESS)
        return times;
    for (const Span& span : spans_) {
        if (span.end == UINT32_MAX) continue;
        const double ms =
            static_cast<double>(ticks[span.end] - ticks[span.begin]) * device_->timestampNs() * 1e-6;
        const auto known = std::find_if(times.begin(), times.end(),
                                        [&](const PassTime& time) { return time.name == span.name; });
        if (known == times.end())
            times.push_back({span.name, ms, 0});
        else
            known->ms += ms;
    }
    return times;
}

} // namespace demos
