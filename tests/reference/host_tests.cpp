// What is not water must look in the reference as the host renders it.
#include <gtest/gtest.h>

#include "tests/program/demo_scenes.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

/// The lake's mountains lie in shadow kilometres away.
class HostScene : public testing::TestWithParam<const char*> {};

TEST_P(HostScene, OpaqueThingsLookAsTraced) {
    Error error;
    std::optional<Scene> scene = loadScene(tests::demoScene(GetParam()), {}, error);
    ASSERT_TRUE(scene) << error.text;
    scene->water.reset();
    constexpr uint32_t width = 320, height = 180;

    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    ASSERT_TRUE(host->load(*scene, error)) << error.text;
    const std::optional<Picture> rendered =
        host->render({width, height, scene->cameras.front(), scene->timeS, Aov::color}, error);
    ASSERT_TRUE(rendered) << error.text;

    const Picture traced = tests::traced(*scene, {width, height, scene->cameras.front()}).color;

    size_t differ = 0, far = 0;
    double sumRendered = 0, sumTraced = 0;
    for (size_t i = 0; i < traced.rgba.size(); i += 4) {
        bool off = false, wide = false;
        for (size_t c = 0; c < 3; ++c) {
            const double a = static_cast<double>(rendered->rgba[i + c]),
                         b = static_cast<double>(traced.rgba[i + c]);
            off |= std::abs(a - b) > 0.03 * std::max(a, b) + 0.002;
            wide |= std::abs(a - b) > 0.3 * std::max(a, b) + 0.02;
            sumRendered += a;
            sumTraced += b;
        }
        differ += off ? 1 : 0;
        far += wide ? 1 : 0;
    }
    const double pixels = width * height;
    RecordProperty("percent_over_3", std::to_string(100 * static_cast<double>(differ) / pixels));
    RecordProperty("percent_over_30", std::to_string(100 * static_cast<double>(far) / pixels));
    // Edges of shadows, edges of things, and texture filters.
    EXPECT_LT(static_cast<double>(differ) / pixels, 0.06);
    EXPECT_LT(static_cast<double>(far) / pixels, 0.02);
    EXPECT_NEAR(sumTraced / sumRendered, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Opaque, HostScene, testing::Values("harbour", "lake"),
                         [](const auto& test) { return std::string(test.param); });

} // namespace
