// Each call of Vulkan fails in turn, in a host that uses all there is: the library says so by a typed status,
// keeps nothing of what failed, destroys nothing that no call made, and goes on when the device does.
#include <cstdio>
#include <set>

#include <gtest/gtest.h>

#include "tests/faults/whole_scene.h"

namespace {

using namespace seaglass;
using namespace ::tests;

/// What a sweep found.
struct Found {
    size_t faults = 0, typed = 0, leaks = 0, garbageDestroyed = 0, garbageUsed = 0;

    void print(const char* what) const {
        std::printf("%s: %zu faults, %zu typed, %zu leaks, %zu garbage destroyed, %zu garbage used\n", what,
                    faults, typed, leaks, garbageDestroyed, garbageUsed);
    }
};

struct Shape {
    const char* name;
    ReflectionTechnique technique;
    VkSampleCountFlagBits samples;
};
constexpr Shape shapes[] = {
    {"Hybrid", ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_1_BIT},
    {"HybridOfFourSamples", ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_4_BIT},
    {"Planar", ReflectionTechnique::planar, VK_SAMPLE_COUNT_1_BIT},
};

class Faults : public testing::TestWithParam<Shape> {
  protected:
    /// The calls that can fail, in a scene in which none does.
    static std::vector<const char*> calls() {
        FailingDevice device;
        WholeScene scene(device, GetParam().technique, GetParam().samples);
        for (const Step& step : scene.steps())
            EXPECT_EQ(step.call(), Status::ok) << step.name << scene.message();
        return device.calls();
    }

    /// Call number `call` fails; or, if `sticky`, it and all that follow.
    void fail(uint64_t call, Fault fault, bool sticky) {
        FailingDevice device;
        SCOPED_TRACE(std::string(GetParam().name) + ": call " + std::to_string(call) + ", " +
                     toString(fault) + (sticky ? ", and all after it" : ""));
        {
            WholeScene scene(device, GetParam().technique, GetParam().samples);
            device.failAt(call, fault, sticky);
            const std::vector<Step> steps = scene.steps();
            for (size_t i = 0; i < steps.size(); ++i) {
                const Step& step = steps[i];
                const size_t before = device.heldButPipelines();
                const bool wasWhole = device.failed().empty();
                const Status status = step.call();
                if (!wasWhole || device.failed().empty()) {
                    ASSERT_EQ(status, Status::ok) << step.name << ": " << scene.message();
                    continue;
                }
                ++found_.faults;
                found_.typed += status == statusOf(fault) && !scene.message().empty();
                EXPECT_EQ(status, statusOf(fault)) << step.name << ", " << device.failed();
                EXPECT_FALSE(scene.message().empty());
                if (step.creates) {
                    EXPECT_EQ(device.heldButPipelines(), before) << step.name << ", " << device.failed();
                }
                if (sticky) break;
                i = step.again - 1;
            }
            EXPECT_FALSE(device.failed().empty());
        }
        found_.leaks += device.held();
        found_.garbageDestroyed += device.garbageDestroyed();
        found_.garbageUsed += device.garbageUsed();
        EXPECT_EQ(device.held(), 0u) << "left behind";
        EXPECT_EQ(device.garbageDestroyed() + device.garbageUsed(), 0u) << device.complaint();
    }

    Found found_;
};
INSTANTIATE_TEST_SUITE_P(, Faults, testing::ValuesIn(shapes),
                         [](const auto& info) { return info.param.name; });

TEST_P(Faults, OfEachFunctionOnce) {
    const std::vector<const char*> all = calls();
    std::set<std::string> seen;
    size_t turn = 0;
    // From the last on, so that it is one in the midst of a frame where there is one.
    for (size_t call = all.size(); call-- > 0;)
        if (seen.insert(all[call]).second) {
            fail(call, everyFault[turn % 4], turn / 4 % 2 == 1);
            ++turn;
        }
    EXPECT_GE(seen.size(), 14u);
    found_.print(GetParam().name);
}

TEST_P(Faults, OfEachCallInTurn) {
    const size_t count = calls().size();
    for (const Fault fault : everyFault)
        for (const bool sticky : {false, true})
            for (size_t call = 0; call < count; ++call) fail(call, fault, sticky);
    found_.print(GetParam().name);
}

} // namespace
