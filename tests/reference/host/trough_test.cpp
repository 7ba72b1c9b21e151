// What stands in waves is, in a trough, as bright down to the water as above, and its mirror image begins
// there: as traced.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/fields.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 120;

/// The nearest post stands in a trough, 0.3 m deep.
Scene postsInWaves(const std::string& technique) {
    std::vector<tests::Box> posts;
    for (int i = 0; i < 7; ++i)
        for (int j = 0; j < 4; ++j) {
            const double x = -18 + 6 * i, z = -10 * j;
            posts.push_back({{x - 0.4, -8, z - 0.4}, {x + 0.4, 8, z + 0.4}});
        }
    Scene scene;
    scene.sky.file = tests::demoTexture("ocean_sky.exr");
    scene.sky.intensity = 0.3;
    scene.sun.azimuthDeg = 60;
    scene.sun.elevationDeg = 40;
    scene.sun.irradiance = {3, 3, 3};
    scene.meshes.push_back({tests::writeBoxes("posts", posts, 0.7)});
    WaterDesc& water = scene.water.emplace();
    water.mesh.cellSize = 0.1f;
    WavesDesc& waves = water.waves.emplace();
    waves.windMps = 12;
    waves.fetchM = 100e3;
    water.reflection.emplace().technique = demos::techniqueNamed(technique);
    scene.cameras.emplace_back();
    scene.cameras[0].positionM = {8, 3.5, 12};
    scene.cameras[0].targetM = {8, 0.5, 0};
    scene.cameras[0].verticalFovDeg = 30;
    return scene;
}

/// [pixel], one past the last.
struct Part {
    uint32_t left, top, right, bottom;
};

double brightness(const Picture& picture, const Part& part) {
    double sum = 0;
    for (uint32_t y = part.top; y < part.bottom; ++y)
        for (uint32_t x = part.left; x < part.right; ++x)
            sum += static_cast<double>(picture.rgba[(size_t{y} * picture.width + x) * 4 + 1]);
    return sum / (part.right - part.left) / (part.bottom - part.top);
}

class Troughs : public testing::TestWithParam<const char*> {};

TEST_P(Troughs, ShowAPostsFootAndItsMirrorImageFromThere) {
    HostDesc desc;
    desc.validation = true;
    Error error;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Scene scene = postsInWaves(GetParam());
    const Picture drawn = tests::rendered(*host, scene, width, height);
    const Picture traced =
        tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 16}).color;
    const Part foot = {37, 71, 51, 74}, image = {37, 76, 50, 80}, beside = {56, 76, 69, 80};
    for (const Picture* picture : {&drawn, &traced})
        std::printf("foot %.4f, image %.4f, water beside %.4f\n", brightness(*picture, foot),
                    brightness(*picture, image), brightness(*picture, beside));
    EXPECT_NEAR(brightness(drawn, foot) / brightness(traced, foot), 1, 0.03);
    EXPECT_NEAR(brightness(drawn, image) / brightness(traced, image), 1, 0.12);
    EXPECT_EQ(host->validationMessages(), 0u);
}

INSTANTIATE_TEST_SUITE_P(By, Troughs, testing::Values("sspr", "ssr", "hybrid", "planar"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
