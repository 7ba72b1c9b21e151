// What passes take, by the clock of each kind of device.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "host/timing/pass_clock.h"
#include "host/vulkan/frame_recorder.h"
#include "tests/program/demo_scenes.h"

namespace {

using namespace demos;

TEST(PassTimes, DevicesAreTimedByTheClockThatTheyAreRightBy) {
    constexpr auto gpu = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, small = VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU,
                   cpu = VK_PHYSICAL_DEVICE_TYPE_CPU;
    EXPECT_EQ(clockOf(PassClock::automatic, gpu, true), PassClock::timestamps);
    EXPECT_EQ(clockOf(PassClock::automatic, small, true), PassClock::timestamps);
    EXPECT_EQ(clockOf(PassClock::automatic, cpu, true), PassClock::fence);
    EXPECT_EQ(clockOf(PassClock::automatic, gpu, false), PassClock::fence);
    EXPECT_EQ(clockOf(PassClock::timestamps, cpu, true), PassClock::timestamps) << "who asks gets it";
    EXPECT_EQ(clockOf(PassClock::timestamps, gpu, false), PassClock::fence);
    EXPECT_EQ(clockOf(PassClock::fence, gpu, true), PassClock::fence);
    EXPECT_EQ(clockOf(PassClock::processor, cpu, true), PassClock::processor);
    EXPECT_EQ(clockOf(PassClock::processor, gpu, true), PassClock::timestamps)
        << "what processors do says nothing of a GPU";
}

struct Timed {
    FrameTimes times;
    bool cpu = false;
};

Timed timesBy(PassClock clock, const Scene& scene) {
    Error error;
    HostDesc desc;
    desc.validation = true;
    desc.clock = clock;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    if (!host || !host->load(scene, error)) {
        ADD_FAILURE() << error.text;
        return {};
    }
    const FrameDesc frame{160, 90, scene.cameras.front(), scene.timeS, Aov::color, 0};
    const std::optional<FrameTimes> times = host->measure(frame, 1, error);
    EXPECT_TRUE(times) << error.text;
    EXPECT_EQ(host->validationMessages(), 0u);
    return {times.value_or(FrameTimes{}), host->device().type == "cpu"};
}

const StageName* stageOf(const std::string& name) {
    const auto* const found = std::ranges::find(stages, name, &StageName::name);
    return found == std::end(stages) ? nullptr : found;
}

/// What is announced while the host draws is heard in whole frames alone.
std::vector<std::string> namesWithoutDrawn(const FrameTimes& times) {
    std::vector<std::string> names;
    const StageName* within = nullptr;
    for (const PassTime& pass : times.passes) {
        const StageName* const stage = stageOf(pass.name);
        if (stage) within = stage;
        if (stage || within->compute) names.push_back(pass.name);
    }
    return names;
}

std::vector<std::string> namesOf(const FrameTimes& times) {
    std::vector<std::string> names;
    for (const PassTime& pass : times.passes) names.push_back(pass.name);
    return names;
}

/// Passes fit their stage, stages their frame. On CPU devices only what is computed: timestamps around draws
/// are wrong there.
void expectFits(const Timed& timed) {
    constexpr double rounding = 1 + 1e-9;
    ASSERT_TRUE(timed.times.gpuFrameMs);
    double ofStages = 0, ofPasses = 0, stageMs = 0;
    const StageName* within = nullptr;
    for (const PassTime& pass : timed.times.passes) {
        const StageName* const stage = stageOf(pass.name);
        if (stage) {
            within = stage;
            ofPasses = 0;
            stageMs = pass.ms;
        }
        if (timed.cpu && !within->compute) continue;
        (stage ? ofStages : ofPasses) += pass.ms;
        // A pass that runs in two drawn stages stands in the first with the time of both.
        if (within->compute) {
            EXPECT_LE(ofPasses, stageMs * rounding) << pass.name << " in " << within->name;
        }
    }
    EXPECT_GT(ofStages, 0);
    EXPECT_LE(ofStages, *timed.times.gpuFrameMs * rounding);
}

/// Both ways on this device, whatever it is.
class TimesOf : public testing::TestWithParam<const char*> {};

TEST_P(TimesOf, StagesAndPassesAreTheSameByEitherClock) {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene(GetParam()), {}, error);
    ASSERT_TRUE(scene) << error.text;
    const Timed whole = timesBy(PassClock::timestamps, *scene), apart = timesBy(PassClock::fence, *scene);
    EXPECT_EQ(whole.times.clock, PassClock::timestamps);
    EXPECT_EQ(apart.times.clock, PassClock::fence);
    for (const FrameTimes& times : {whole.times, apart.times}) {
        EXPECT_GE(times.passes.size(), 4u);
        for (const PassTime& pass : times.passes) EXPECT_GT(pass.ms, 0) << pass.name;
        EXPECT_GT(times.yardsticks.floor.ms, 0);
        EXPECT_GT(times.yardsticks.fullScreen.ms, 0);
        EXPECT_GT(times.frameMs, 0);
    }
    EXPECT_EQ(namesWithoutDrawn(whole.times), namesOf(apart.times));
    EXPECT_FALSE(apart.times.gpuFrameMs);
    expectFits(whole);
}

INSTANTIATE_TEST_SUITE_P(PassTimes, TimesOf, testing::Values("harbour", "floor"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
