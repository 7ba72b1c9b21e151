// What frame after frame leaves behind in this process, drivers' part of it included: nothing.
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "host/host.h"
#include "scene/scene.h"
#include "tests/program/demo_scenes.h"

namespace {

using namespace demos;

/// That is in memory now; none where the system does not tell.
std::optional<double> residentMiB() {
    std::ifstream statm("/proc/self/statm");
    double pages = 0, resident = 0;
    if (!(statm >> pages >> resident)) return std::nullopt;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

class ManyFrames : public testing::TestWithParam<const char*> {};

/// llvmpipe compiles a shader that a uniform more than halves for that uniform's value, anew at each draw,
/// and keeps all of them: a floor's frames once took 1.7 MiB each.
TEST_P(ManyFrames, TakeNoMoreMemoryThanAFew) {
    if (!residentMiB()) GTEST_SKIP() << "no /proc/self/statm";
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene(GetParam()), {}, error);
    ASSERT_TRUE(scene) << error.text;
    const std::unique_ptr<Host> host = Host::create({{}, false}, error);
    ASSERT_TRUE(host && host->load(*scene, error)) << error.text;
    FrameDesc frame{32, 18, scene->cameras.front(), scene->timeS, Aov::color, 0};
    const auto draw = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            frame.timeS += 1.0 / 60;
            ASSERT_TRUE(host->render(frame, error)) << error.text;
        }
    };
    draw(4); // pipelines and images are made
    const double before = *residentMiB();
    draw(16);
    EXPECT_LT(*residentMiB() - before, 8);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ManyFrames, testing::Values("floor", "harbour"),
                         [](const auto& tested) { return std::string(tested.param); });

} // namespace
