// Caustics as they are drawn, beside the traced ones.
#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"
#include "tests/unit/sea/statistics.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 120;

/// Clear water with waves over an even bed, as an eye in it looks down on some two metres of the bed.
Scene bath(double depth, const WavesDesc& waves, double sunDeg = 55) {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sky.intensity = 0.02;
    scene.sun.azimuthDeg = 20;
    scene.sun.elevationDeg = sunDeg;
    scene.sun.irradiance = {10, 10, 10};
    scene.meshes.push_back({tests::writeBoxes("bath", {{{-20, -depth - 1, -20}, {20, -depth, 20}}}, 0.5)});
    WaterDesc& water = scene.water.emplace();
    water.refraction.emplace().absorptionPerM = {0, 0, 0};
    water.refraction->backscatterPerM = {0, 0, 0};
    water.waves = waves;
    water.caustics.emplace();
    water.underwater.emplace();
    scene.timeS = 2;
    scene.cameras.emplace_back();
    scene.cameras[0].positionM = {0, -0.6 * depth, 0.001};
    scene.cameras[0].targetM = {0, -depth, 0};
    scene.cameras[0].nearM = 0.02;
    scene.cameras[0].verticalFovDeg = 2 * std::atan(0.75 / (0.4 * depth)) * 57.29578;
    return scene;
}

/// Means over squares of pixels, of green.
std::vector<double> coarser(const Picture& picture, size_t side) {
    std::vector<double> means;
    for (size_t y = 0; y + side <= height; y += side)
        for (size_t x = 0; x + side <= width; x += side) {
            double sum = 0;
            for (size_t j = y; j < y + side; ++j)
                for (size_t i = x; i < x + side; ++i)
                    sum += static_cast<double>(picture.rgba[(j * width + i) * 4 + 1]);
            means.push_back(sum / static_cast<double>(side * side));
        }
    return means;
}

struct Alike {
    double drawn = 0, traced = 0; ///< deviation over mean
    double correlation = 0;
};

Alike compare(const Picture& drawn, const Picture& traced, size_t side) {
    const std::vector<double> a = coarser(drawn, side), b = coarser(traced, side);
    return {tests::deviationOf(a) / tests::meanOf(a), tests::deviationOf(b) / tests::meanOf(b),
            tests::correlationOf(a, b)};
}

WavesDesc swell() {
    WavesDesc waves;
    waves.windMps = 4;
    waves.fetchM = 2e3;
    waves.samples = 64;
    waves.cascades = 1;
    waves.largestPatchM = 8;
    return waves;
}

WavesDesc ripplesOfThePool() {
    Error error;
    const auto pool = loadScene(tests::demoScene("pool"), {}, error);
    EXPECT_TRUE(pool) << error.text;
    return *pool->water->waves;
}

Picture tracedOf(const Scene& scene) {
    return tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 16}).color;
}

struct Bath {
    const char* name;
    WavesDesc (*waves)();
    double depth, alike, sunDeg = 55;
};

void PrintTo(const Bath& bath, std::ostream* out) {
    *out << bath.name;
}

class DrawnCaustics : public testing::TestWithParam<Bath> {};

/// Also where rays have crossed, and where a low sun sends them far.
TEST_P(DrawnCaustics, LieWhereTheyAreTraced) {
    HostDesc desc;
    desc.validation = true;
    Error error;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Bath& c = GetParam();
    const Scene scene = bath(c.depth, c.waves(), c.sunDeg);
    const Picture drawn = tests::rendered(*host, scene, width, height), traced = tracedOf(scene);
    for (const size_t side : {size_t{1}, size_t{4}, size_t{8}}) {
        const Alike a = compare(drawn, traced, side);
        std::printf("%s, means of %zu px: contrast %.3f drawn, %.3f traced, correlation %.3f\n", c.name, side,
                    a.drawn, a.traced, a.correlation);
    }
    const Alike a = compare(drawn, traced, 4);
    EXPECT_GT(a.correlation, c.alike);
    // Over a pale bed twice as much, were light that the surface turns back taken to come from the spot.
    EXPECT_NEAR(a.drawn / a.traced, 1, 0.25);
    EXPECT_EQ(host->validationMessages(), 0u);
}
INSTANTIATE_TEST_SUITE_P(, DrawnCaustics,
                         testing::Values(Bath{"SwellOverAMetre", swell, 1, 0.95},
                                         Bath{"SwellOverTwo", swell, 2, 0.93},
                                         Bath{"SwellInALowSun", swell, 1, 0.9, 20},
                                         Bath{"PoolOfAFoot", ripplesOfThePool, 0.3, 0.93},
                                         Bath{"PoolOfAMetre", ripplesOfThePool, 1, 0.95},
                                         Bath{"PoolOfTwo", ripplesOfThePool, 2, 0.95},
                                         Bath{"PoolInALowSun", ripplesOfThePool, 1, 0.9, 20}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TracedPicture, HasAsMuchLightUnderWavesAsUnderCalmWater) {
    Scene scene = bath(2, ripplesOfThePool());
    const std::vector<double> waves = coarser(tracedOf(scene), height);
    scene.water->waves.reset();
    const std::vector<double> calm = coarser(tracedOf(scene), height);
    std::printf("%.4f of calm water's\n", waves[0] / calm[0]);
    EXPECT_NEAR(waves[0] / calm[0], 1, 0.02); // of two square metres
}

} // namespace
