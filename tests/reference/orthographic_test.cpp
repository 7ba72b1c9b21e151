// What parallel lines of sight see, drawn by the host and traced.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "host/host.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 90, block = 10;

struct Shot {
    const char* name;
    const char* scene;
    Vec3 position, target;
    double heightM;
    bool water;
    double most; ///< mean difference of blocks, of 255
};

Scene sceneOf(const Shot& shot) {
    Error error;
    std::optional<Scene> scene = loadScene(tests::demoScene(shot.scene), {}, error);
    EXPECT_TRUE(scene) << error.text;
    CameraDesc camera;
    camera.positionM = shot.position;
    camera.targetM = shot.target;
    camera.orthographicHeightM = shot.heightM;
    scene->cameras = {camera};
    if (!shot.water) scene->water.reset();
    return *scene;
}

/// Of a screen's values, by blocks of pixels, whose means sampling leaves alone.
double differenceOfBlocks(const Picture& a, const Picture& b, double exposureEv) {
    const std::vector<uint8_t> first = toneMap(a, exposureEv), second = toneMap(b, exposureEv);
    const size_t channels = first.size() / (width * height);
    double total = 0;
    for (uint32_t y = 0; y < height; y += block)
        for (uint32_t x = 0; x < width; x += block)
            for (size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (uint32_t i = 0; i < block * block; ++i) {
                    const size_t pixel = size_t{y + i / block} * width + x + i % block;
                    sum += double(first[pixel * channels + c]) - double(second[pixel * channels + c]);
                }
                total += std::abs(sum) / (block * block);
            }
    return total / (3.0 * width * height / (block * block));
}

class Orthographic : public testing::TestWithParam<Shot> {};

TEST_P(Orthographic, LooksAsTraced) {
    const Scene scene = sceneOf(GetParam());
    Error error;
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Picture drawn = tests::rendered(*host, scene, width, height);
    const Picture traced = tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 9}).color;
    const double off = differenceOfBlocks(drawn, traced, scene.exposureEv);
    std::printf("off by %.2f of 255\n", off);
    EXPECT_LT(off, GetParam().most);
    EXPECT_EQ(host->validationMessages(), 0u);
}
INSTANTIATE_TEST_SUITE_P(
    , Orthographic,
    testing::Values(Shot{"PoolWithoutWater", "pool", {-30, 30, 30}, {0, 0, 0}, 18, false, 1.4},
                    Shot{"Pool", "pool", {-30, 30, 30}, {0, 0, 0}, 18, true, 1.4},
                    Shot{"PoolFromAbove", "pool", {0, 40, 0}, {0, 0, 0}, 16, true, 1.4},
                    Shot{"Harbour", "harbour", {-40, 40, 50}, {0, 0, 4}, 30, true, 1.4},
                    Shot{"HarbourFromAbove", "harbour", {0, 60, 6}, {0, 0, 6}, 24, true, 1.4},
                    Shot{"Ocean", "ocean", {0, 40, 0}, {40, 0, -40}, 30, true, 4.5}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
