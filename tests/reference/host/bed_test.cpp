// Refraction that looks at a picture of the bed shows what the reference traces behind a quay and past the
// picture's border.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "host/water/quality.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/camera_of.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 90;

/// Calm water before a quay, whose edge hides dark stripes on the bed: bent rays alone lead to them.
Scene pastAQuay() {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sky.intensity = 0.2;
    scene.sun.azimuthDeg = 250;
    scene.sun.elevationDeg = 50;
    scene.sun.irradiance = {10, 10, 10};
    const std::vector<tests::Box> pale = {{{-30, -3, -30}, {30, -2, 0}}, {{-30, -3, 0}, {30, 0.4, 8}}};
    const std::vector<tests::Box> dark = {{{-30, -2, -6.5}, {30, -1.98, -5}},
                                          {{-4, -2, -20}, {-3, -1.98, -1}}};
    scene.meshes.push_back({tests::writeBoxes("quay", pale, 0.5)});
    scene.meshes.push_back({tests::writeBoxes("stripes", dark, 0.03)});
    scene.water.emplace().refraction.emplace().type = "pool";
    scene.water->shading.refractionSamples = 8;
    scene.cameras.emplace_back();
    scene.cameras[0].positionM = {0, 1.2, 3};
    scene.cameras[0].targetM = {0, -0.6, -3};
    return scene;
}

/// Mean difference, a share of the mean.
double apart(const Picture& drawn, const Picture& traced) {
    double sum = 0, difference = 0;
    for (size_t i = 0; i < drawn.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        sum += static_cast<double>(traced.rgba[i]);
        difference += std::abs(static_cast<double>(drawn.rgba[i]) - static_cast<double>(traced.rgba[i]));
    }
    return difference / sum;
}

double apart(Host& host, const Scene& scene) {
    const Picture drawn = tests::rendered(host, scene, width, height);
    return apart(drawn, tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 16}).color);
}

class BedsPicture : public testing::Test {
  protected:
    void SetUp() override {
        HostDesc desc;
        desc.validation = true;
        Error error;
        host_ = Host::create(desc, error);
        ASSERT_TRUE(host_) << error.text;
    }

    void TearDown() override {
        ASSERT_TRUE(host_);
        EXPECT_EQ(host_->validationMessages(), 0u);
    }

    std::unique_ptr<Host> host_;
};

TEST_F(BedsPicture, ShowsWhatTheSceneHides) {
    Scene scene = pastAQuay();
    const double without = apart(*host_, scene);
    scene.water->bed.emplace();
    const double with = apart(*host_, scene);
    std::printf("apart by %.4f without, %.4f with\n", without, with);
    EXPECT_LT(with, 0.02);
    EXPECT_GT(without, 3 * with);
}

// Without that picture the scene's shows what lies in open water, in another place than bent rays lead to it.
TEST_F(BedsPicture, IsNotNeededForWhatTheSceneShows) {
    Scene scene = pastAQuay();
    scene.sun.azimuthDeg = 60;
    const std::vector<tests::Box> boxes = {{{-2.2, -2.5, -4}, {-0.2, -1.2, -2}},
                                           {{0.6, -1.8, -1}, {1.8, -0.6, 0}}};
    scene.meshes = {{tests::writeBoxes("submerged", boxes, 0.7)}};
    scene.cameras[0].positionM = {0, 3.5, 9};
    scene.cameras[0].targetM = {0, -0.3, -1};
    scene.cameras[0].verticalFovDeg = 30;
    const Picture truth = tests::traced(scene, {96, 54, scene.cameras.front(), scene.timeS, 9}).color;
    for (const uint32_t samples : {2u, 3u, 8u}) {
        scene.water->shading.refractionSamples = samples;
        const double off = apart(tests::rendered(*host_, scene, 96, 54), truth);
        std::printf("%u samples: apart by %.4f\n", samples, off);
        EXPECT_LT(off, 0.1);
    }
}

// It mirrors less than in air, where the sun before the eye would make it much brighter.
TEST_F(BedsPicture, OfADarkBedIsAsBrightAsTheTraced) {
    Scene scene = pastAQuay();
    scene.meshes = {{tests::writeBoxes("dark", {{{-300, -3, -300}, {300, -2, 300}}}, 0.03)}};
    scene.sun.azimuthDeg = 270;
    scene.sun.elevationDeg = 60;
    scene.water->bed.emplace();
    EXPECT_LT(apart(*host_, scene), 0.02);
}

// What a pool's ladder mirrors under water is bright water, not the ground below the sky's horizon.
TEST_F(BedsPicture, OfSubmergedMetalIsAsBrightAsTheTraced) {
    Error error;
    std::optional<Scene> pool = loadScene(tests::demoScene("pool"), {}, error);
    ASSERT_TRUE(pool) << error.text;
    setQuality("highest", *pool->water);
    pool->water->waves->warp = 0; // so few pixels that each sea has its own figure
    const CameraDesc edge = tests::cameraOf(*pool, "edge");
    pool->cameras = {edge};
    constexpr uint32_t across = 240, down = 135;
    const Picture drawn = tests::rendered(*host_, *pool, across, down);
    const Picture traced = tests::traced(*pool, {across, down, edge, pool->timeS, 16}).color;
    double shown = 0, truth = 0;
    for (size_t y = 79; y < 100; ++y) // its legs
        for (size_t x = 116; x < 125; ++x) {
            shown += double{drawn.rgba[(y * across + x) * 4 + 1]};
            truth += double{traced.rgba[(y * across + x) * 4 + 1]};
        }
    std::printf("green of the ladder's legs: %.3f of the traced\n", shown / truth);
    EXPECT_NEAR(shown / truth, 1, 0.1); // 0.56 where they mirror the sky cube
}

/// Share of the pixels that are far darker than those on all four sides.
double shareOfSpecks(const Picture& picture) {
    const auto green = [&](uint32_t x, uint32_t y) {
        return picture.rgba[(size_t{y} * picture.width + x) * 4 + 1];
    };
    size_t specks = 0;
    for (uint32_t y = 1; y + 1 < picture.height; ++y)
        for (uint32_t x = 1; x + 1 < picture.width; ++x) {
            const float least = std::min(std::min(green(x - 1, y), green(x + 1, y)),
                                         std::min(green(x, y - 1), green(x, y + 1)));
            specks += green(x, y) < 0.6f * least;
        }
    return static_cast<double>(specks) / static_cast<double>(picture.rgba.size() / 4);
}

// A pixel is longer there along the line of sight than the search for the bed is exact, and ripples bend rays
// every way, even along the raised eye's own.
TEST_F(BedsPicture, HasNoSpecksThroughALongLens) {
    Error error;
    std::optional<Scene> pool = loadScene(tests::demoScene("pool"), {}, error);
    ASSERT_TRUE(pool) << error.text;
    setQuality("highest", *pool->water);
    CameraDesc far = tests::cameraOf(*pool, "far");
    far.verticalFovDeg = 10;
    ASSERT_TRUE(host_->load(*pool, error)) << error.text;
    const std::optional<Picture> drawn = host_->render({480, 270, far, pool->timeS, Aov::color}, error);
    ASSERT_TRUE(drawn) << error.text;
    const double specks = shareOfSpecks(*drawn);
    std::printf("%.5f of the pixels are specks\n", specks);
    EXPECT_LT(specks, 0.006);
}

} // namespace
