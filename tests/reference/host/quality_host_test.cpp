// Each quality preset is as near to the traced picture as the one before or, but for noise,
// nearer.
#include <gtest/gtest.h>

#include "host/host.h"
#include "host/water/quality.h"
#include "measure/picture_error.h"
#include "metrics/flip.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 240, height = 135;

double difference(const Picture& picture, const Picture& traced, double exposureEv) {
    const std::vector<float> map = flip({width, height, measure::displayed(traced, exposureEv)},
                                        {width, height, measure::displayed(picture, exposureEv)});
    double sum = 0;
    for (const float value : map) sum += static_cast<double>(value);
    return sum / static_cast<double>(map.size());
}

class QualityOfTheHost : public testing::TestWithParam<const char*> {};

TEST_P(QualityOfTheHost, BringsThePictureNearerToTheTraced) {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene(GetParam()), {}, error);
    ASSERT_TRUE(scene) << error.text;
    const Picture traced =
        tests::traced(*scene, {width, height, scene->cameras.front(), scene->timeS, 32}).color;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    double first = 0, before = 1;
    for (const std::string_view quality : qualities()) {
        Scene set = *scene;
        setQuality(quality, *set.water);
        ASSERT_TRUE(host->load(set, error)) << error.text;
        const std::optional<Picture> picture =
            host->render({width, height, scene->cameras.front(), scene->timeS, Aov::color}, error);
        ASSERT_TRUE(picture) << error.text;
        const double now = difference(*picture, traced, scene->exposureEv);
        std::printf("%s, %s: %.4f\n", GetParam(), std::string(quality).c_str(), now);
        EXPECT_LT(now, 1.01 * before) << quality;
        if (first == 0) first = now;
        before = now;
    }
    EXPECT_LT(before, 0.87 * first);
}

INSTANTIATE_TEST_SUITE_P(Quality, QualityOfTheHost, testing::Values("harbour", "ocean"),
                         [](const auto& test) { return std::string(test.param); });

} // namespace
