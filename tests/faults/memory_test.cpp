// Memory of the CPU runs out, in a host that uses all there is: the host's own callbacks return null, or
// `new` throws.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/faults/whole_scene.h"
#include "tests/unit/sea/starved.h"

namespace {

using namespace seaglass;
using namespace ::tests;

/// A host's callbacks, of which call number `emptyAt` returns null.
struct EmptyAt {
    size_t calls = 0, held = 0;
    size_t emptyAt = ~size_t{0};

    static void* VKAPI_PTR allocate(void* user, size_t size, size_t alignment, VkSystemAllocationScope) {
        auto& self = *static_cast<EmptyAt*>(user);
        if (self.calls++ == self.emptyAt) return nullptr;
        ++self.held;
        return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    }
    static void VKAPI_PTR release(void* user, void* memory) {
        if (memory) --static_cast<EmptyAt*>(user)->held;
        std::free(memory);
    }
    VkAllocationCallbacks callbacks() { return {this, allocate, nullptr, release, nullptr, nullptr}; }
};

/// Runs the scene with callbacks that are empty at that call, and says how often they were called.
size_t runEmptyAt(size_t call) {
    SCOPED_TRACE("call " + std::to_string(call));
    EmptyAt memory;
    memory.emptyAt = call;
    const VkAllocationCallbacks callbacks = memory.callbacks();
    FailingDevice device;
    {
        WholeScene scene(device, ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_1_BIT, &callbacks);
        const std::vector<Step> steps = scene.steps();
        size_t failures = 0;
        for (size_t i = 0; i < steps.size(); ++i) {
            const size_t heldBefore = device.heldButPipelines();
            const Status status = steps[i].call();
            if (status == Status::ok) continue;
            EXPECT_EQ(status, Status::outOfHostMemory) << steps[i].name << ": " << scene.message();
            if (steps[i].creates) {
                EXPECT_EQ(device.heldButPipelines(), heldBefore) << steps[i].name;
            }
            EXPECT_EQ(++failures, 1u);
            if (failures > 1) break;
            i = steps[i].again - 1;
        }
        EXPECT_EQ(failures, memory.calls > call ? 1u : 0u);
    }
    EXPECT_EQ(memory.held, 0u);
    EXPECT_EQ(device.held(), 0u);
    EXPECT_EQ(device.wrongAllocators() + device.garbageDestroyed(), 0u) << device.complaint();
    return memory.calls;
}

/// Each `stride`-th call of the callbacks is one that fails.
void sweepCallbacks(size_t stride) {
    const size_t calls = runEmptyAt(~size_t{0});
    EXPECT_GT(calls, 300u);
    size_t runs = 0;
    for (size_t call = 0; call < calls; call += stride, ++runs) (void)runEmptyAt(call);
    std::printf("%zu of %zu calls of the host's callbacks gave null\n", runs, calls);
}

TEST(HostsCallbacks, GiveNullNowAndThen) {
    sweepCallbacks(97);
}

TEST(HostsCallbacks, GiveNullInEachCall) {
    sweepCallbacks(1);
}

/// In each step of the scene `new` throws at allocation number 0, and then at numbers that grow by `growth`,
/// until the step needs no more.
void sweepNew(double growth) {
    // What is made once for the program.
    (void)runEmptyAt(~size_t{0});
    const size_t heldBefore = tests::allocationsHeld();
    size_t thrown = 0;
    {
        FailingDevice device;
        {
            WholeScene scene(device, ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_1_BIT);
            const std::vector<Step> steps = scene.steps();
            double left = 0;
            size_t hungry = 0; // what begins a frame anew before it has all it wants
            for (size_t i = 0; i < steps.size(); ++i) {
                SCOPED_TRACE(steps[i].name + std::string(", allocation ") + std::to_string(left));
                const size_t deviceHeld = device.heldButPipelines();
                Status status = Status::ok;
                {
                    const tests::Starved starved(i == hungry ? static_cast<int>(left) : -1);
                    ASSERT_NO_THROW(status = steps[i].call());
                }
                if (status == Status::ok) {
                    if (i < hungry) continue;
                    ++hungry;
                    left = 0;
                    continue;
                }
                ++thrown;
                ASSERT_EQ(i, hungry);
                ASSERT_EQ(status, Status::outOfHostMemory) << scene.message();
                if (steps[i].creates) {
                    EXPECT_EQ(device.heldButPipelines(), deviceHeld);
                }
                left = std::max(left + 1, left * growth);
                i = steps[i].again - 1;
            }
        }
        EXPECT_EQ(device.held(), 0u);
        EXPECT_EQ(device.garbageDestroyed() + device.garbageUsed(), 0u) << device.complaint();
    }
    EXPECT_EQ(tests::allocationsHeld(), heldBefore);
    std::printf("new threw %zu times\n", thrown);
    EXPECT_GT(thrown, 50u);
}

TEST(New, ThrowsNowAndThen) {
    sweepNew(4);
}

TEST(New, ThrowsNearlyEverywhere) {
    sweepNew(1.02);
}

} // namespace
