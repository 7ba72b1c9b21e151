#include "host/timing/pass_timer.h"

#include <algorithm>

#include "host/vulkan/device.h"

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

double msOf(const std::vector<TimedPass>& passes, const std::string& name, const std::string& within) {
    for (const TimedPass& pass : passes)
        if (pass.name == name && pass.within == within) return pass.ms;
    return 0;
}

double sumWithin(const std::vector<TimedPass>& passes, const std::string& stage) {
    double ms = 0;
    for (const TimedPass& pass : passes)
        if (pass.within == stage) ms += pass.ms;
    return ms;
}

bool PassTimer::create(VkDevice device, double tickNs, uint32_t validBits, bool late, Error& error) {
    device_ = device;
    tickNs_ = tickNs;
    validTicks_ = validBits < 64 ? (uint64_t{1} << validBits) - 1 : UINT64_MAX;
    late_ = late;
    if (tickNs == 0) return true;
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2 * capacity;
    VkQueryPool pool = VK_NULL_HANDLE;
    if (!succeeded(vkCreateQueryPool(device, &info, nullptr, &pool), "vkCreateQueryPool", error))
        return false;
    pool_ = UniqueQueryPool(device, pool);
    return true;
}

void PassTimer::begin(VkCommandBuffer commands) {
    spans_.clear();
    open_ = none;
    used_ = 0;
    full_ = separate_ = false;
    commands_ = pool_ ? commands : VK_NULL_HANDLE;
    first_ = capacity - first_;
    if (pool_) vkCmdResetQueryPool(commands, pool_.get(), 0, 2 * capacity);
}

void PassTimer::mark(VkCommandBuffer commands, const char* pass, bool begins) {
    if (commands != commands_ || commands == VK_NULL_HANDLE || full_) return;
    full_ = used_ == capacity;
    if (full_) return;
    if (begins) {
        spans_.push_back({pass, open_, used_, UINT32_MAX});
        open_ = spans_.size() - 1;
    } else {
        size_t ended = open_;
        while (ended != none && spans_[ended].name != pass) ended = spans_[ended].around;
        if (ended == none) return;
        spans_[ended].end = used_;
        open_ = spans_[ended].around;
    }
    // A pass begins when all before it has ended: at the top of the pipe its time would hold theirs, or they
    // its.
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(), first_ + used_++);
    // lavapipe takes the time at its next flush: without a barrier here that can be after the pass's first
    // dispatch.
    if (begins && separate_) waitForAll(commands);
}

bool PassTimer::collect(std::vector<TimedPass>& out, Error& error) const {
    out.clear();
    if (full_) {
        error.text = "more than " + std::to_string(capacity / 2) + " passes in one submission";
        return false;
    }
    if (used_ == 0) return true;
    std::vector<uint64_t> ticks(used_);
    const VkResult got = read(ticks.data(), sizeof(uint64_t), VK_QUERY_RESULT_WAIT_BIT);
    if (!succeeded(got, "vkGetQueryPoolResults", error)) return false;
    for (const Span& span : spans_) {
        if (span.end == UINT32_MAX) continue;
        const uint64_t passed = (ticks[span.end] - ticks[span.begin]) & validTicks_;
        const double ms = static_cast<double>(passed) * tickNs_ * 1e-6;
        const std::string within = span.around == none ? "" : spans_[span.around].name;
        const auto known = std::find_if(out.begin(), out.end(), [&](const TimedPass& pass) {
            return pass.name == span.name && pass.within == within;
        });
        if (known == out.end())
            out.push_back({span.name, within, ms});
        else
            known->ms += ms;
    }
    return true;
}

VkResult PassTimer::read(void* into, size_t bytesEach, VkQueryResultFlags flags) const {
    return vkGetQueryPoolResults(device_, pool_.get(), first_, used_, used_ * bytesEach, into, bytesEach,
                                 VK_QUERY_RESULT_64_BIT | flags);
}

std::optional<std::string> PassTimer::unfinished() const {
    if (used_ == 0) return "";
    struct Query {
        uint64_t ticks, available;
    };
    std::vector<Query> queries(used_, {0, 0});
    const VkResult got = read(queries.data(), sizeof(Query), VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
    if (got != VK_SUCCESS && got != VK_NOT_READY) return std::nullopt;
    const auto runs = std::find_if(spans_.rbegin(), spans_.rend(), [&](const Span& span) {
        const bool ended = span.end != UINT32_MAX && queries[span.end].available != 0;
        return queries[span.begin].available != 0 && !ended;
    });
    if (runs == spans_.rend()) return "";
    return runs->around == none ? runs->name : runs->name + " (" + spans_[runs->around].name + ")";
}

} // namespace demos
