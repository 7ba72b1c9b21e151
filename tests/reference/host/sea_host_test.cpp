// The open sea, drawn by the host, mirrors sky and sun where traced waves do.
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "host/files/image_file.h"
#include "host/host.h"
#include "host/water/quality.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/camera_of.h"
#include "tests/reference/mean_difference.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 160, height = 90;

Scene sea() {
    Error error;
    const auto scene = loadScene(tests::demoScene("ocean"), {}, error);
    EXPECT_TRUE(scene) << error.text;
    return *scene;
}

Picture render(Host& host, const Scene& scene) {
    return tests::rendered(host, scene, width, height);
}

Picture trace(const Scene& scene) {
    return tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 32}).color;
}

/// White from 5 degrees left of the sun's azimuth to 5 right, black elsewhere, as lat-long.
std::filesystem::path stripOfSky(double azimuthDeg) {
    Picture sky = {1024, 512, std::vector<float>(size_t(1024) * 512 * 4, 0)};
    for (uint32_t y = 0; y < sky.height / 2; ++y)
        for (uint32_t x = 0; x < sky.width; ++x) {
            const double away = std::remainder(360 * (x + 0.5) / sky.width - azimuthDeg, 360);
            for (size_t c = 0; c < 3; ++c)
                sky.rgba[(size_t(y) * sky.width + x) * 4 + c] = std::abs(away) < 5 ? 1.0f : 0.0f;
        }
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "strip_of_sky.exr";
    Error error;
    EXPECT_TRUE(writeExr(file, sky, error)) << error.text;
    return file;
}

/// Light below the horizon in columns from one share of the width to another.
double lightIn(const Picture& picture, double from, double to) {
    double sum = 0;
    for (uint32_t y = height / 2; y < height; ++y)
        for (auto x = static_cast<uint32_t>(from * width); x < to * width; ++x)
            sum += static_cast<double>(picture.rgba[(size_t(y) * width + x) * 4]);
    return sum;
}

/// Facets that lean aside turn a grazing ray little: a strip of sky is mirrored as a path below it, not as a
/// glow all over the sea.
TEST(SeaOfTheHost, MirrorsAStripOfSkyAsAPath) {
    Scene scene = sea();
    scene.sky.file = stripOfSky(scene.sun.azimuthDeg);
    scene.sun.irradiance = {0, 0, 0};
    scene.water->foam.reset();
    Error error;
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Picture traced = trace(scene);
    const double tracedPath = lightIn(traced, 0.65, 1), tracedAside = lightIn(traced, 0, 0.5);
    EXPECT_GT(tracedPath, 1);
    for (const uint32_t samples : {2u, 4u}) {
        scene.water->shading.reflectionSamples = samples;
        const Picture rendered = render(*host, scene);
        const double renderedPath = lightIn(rendered, 0.65, 1), renderedAside = lightIn(rendered, 0, 0.5);
        std::printf("%u samples, path: %.2f traced, %.2f drawn; aside: %.3f traced, %.3f drawn\n", samples,
                    tracedPath, renderedPath, tracedAside, renderedAside);
        EXPECT_NEAR(renderedPath / tracedPath, 1, samples == 4 ? 0.02 : 0.05);
        EXPECT_LT(renderedAside / renderedPath, 2 * tracedAside / tracedPath + 0.005);
    }
    std::filesystem::remove(scene.sky.file);
    EXPECT_EQ(host->validationMessages(), 0u);
}

/// Mean difference of what a screen shows, below the horizon: 0..255.
double difference(const Picture& a, const Picture& b, double exposureEv) {
    const std::vector<uint8_t> first = toneMap(a, exposureEv), second = toneMap(b, exposureEv);
    const size_t water = first.size() / 2;
    return tests::meanDifference(std::span(first).last(water), std::span(second).last(water));
}

/// A low sun leaves the lee of its waves dark.
TEST(SeaOfTheHost, SeesWhichWavesHideTheSun) {
    Scene scene = sea();
    Error error;
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Picture traced = trace(scene), mean = render(*host, scene);
    scene.water->shading.waveShadowSteps = 8;
    const Picture looked = render(*host, scene);
    const double without = difference(mean, traced, scene.exposureEv);
    const double with = difference(looked, traced, scene.exposureEv);
    std::printf("off by %.2f of 255 without looking, %.2f with\n", without, with);
    // 0.64 where pixels that hold small waves do not look for the large ones, which they show as well; 0.67
    // where crests are flattened or the edges of their shadows are blurred.
    EXPECT_LT(with, 0.63 * without);
    EXPECT_EQ(host->validationMessages(), 0u);
}

/// Waves a few metres away cast shadows on the glint before the eye.
TEST(SeaOfTheHost, SeesNearWavesHideTheSun) {
    Scene scene = sea();
    setQuality("highest", *scene.water);
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const Picture traced = tests::traced(scene, {640, 360, scene.cameras.front(), scene.timeS, 32}).color;
    const double off = difference(tests::rendered(*host, scene, 640, 360), traced, scene.exposureEv);
    std::printf("off by %.3f of 255\n", off);
    // 7.94 where none is looked for nearer than half a deviation of the sea's heights.
    EXPECT_LT(off, 7.7);
}

/// From an aeroplane at 10 km the horizon of the Earth's sea dips by 3.2 degrees, on a tenth of this picture.
TEST(SeaOfTheHost, LiesOnTheGlobeOfTheTracedOne) {
    Scene scene = sea();
    scene.cameras.front().positionM = {0, 1e4, 0};
    scene.cameras.front().targetM = {1, 9999.9, 0};
    scene.water->waves.reset();
    scene.water->foam.reset();
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const Picture flat = render(*host, scene);
    scene.water->planetRadiusM = 6.371e6;
    const Picture traced = trace(scene);
    const double off = difference(render(*host, scene), traced, scene.exposureEv);
    const double offWhereFlat = difference(flat, traced, scene.exposureEv);
    std::printf("off by %.2f of 255, by %.2f on a plane\n", off, offWhereFlat);
    EXPECT_LT(off, 0.5);
    EXPECT_GT(offWhereFlat, 5);
}

/// Of the green light in the lower half, by blocks of 40 x 30 pixels: mean share by which one picture's is
/// off.
double offByBlocks(const Picture& drawn, const Picture& traced) {
    constexpr uint32_t across = 40, down = 30;
    double off = 0;
    uint32_t blocks = 0;
    for (uint32_t top = traced.height / 2; top + down <= traced.height; top += down)
        for (uint32_t left = 0; left + across <= traced.width; left += across, ++blocks) {
            double light = 0, expected = 0;
            for (uint32_t y = top; y < top + down; ++y)
                for (uint32_t x = left; x < left + across; ++x) {
                    const size_t green = (size_t(y) * traced.width + x) * 4 + 1;
                    light += static_cast<double>(drawn.rgba[green]);
                    expected += static_cast<double>(traced.rgba[green]);
                }
            off += std::abs(light / expected - 1);
        }
    return off / blocks;
}

/// Low rays meet other waves, which show themselves by the sides that they turn to them.
TEST(SeaOfTheHost, MirrorsWavesInWaves) {
    Scene scene = sea();
    scene.cameras = {tests::cameraOf(scene, "low")};
    scene.sun.irradiance = {0, 0, 0};
    scene.water->foam.reset();
    setQuality("highest", *scene.water);
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const Picture traced = tests::traced(scene, {320, 180, scene.cameras.front(), scene.timeS, 32}).color;
    const double off = offByBlocks(tests::rendered(*host, scene, 320, 180), traced);
    std::printf("off by %.4f\n", off);
    // 0.046 by facets that lean by 1.25 deviations whatever the ray, 0.052 by a sky blurred half as wide as a
    // look.
    EXPECT_LT(off, 0.043);
}

/// The storm under a sun 7.5 degrees high, before the eye; without sky, so that its light alone is compared.
Scene stormInLowSun(const char* camera) {
    Error error;
    const std::vector<std::string> sun = {"sky.intensity=0", "sun.azimuth_deg=298", "sun.elevation_deg=7.5",
                                          "sun.irradiance=[8.685, 4.944, 1.910]",
                                          "water.refraction.backscatter_per_m=[0.004, 0.0062, 0.006]"};
    std::optional<Scene> scene = loadScene(tests::demoScene("storm"), sun, error);
    EXPECT_TRUE(scene) << error.text;
    scene->cameras = {tests::cameraOf(*scene, camera)};
    scene->water->spray.reset(); // which is not traced
    scene->fog.reset();
    setQuality("highest", *scene->water);
    return *scene;
}

/// The same, whose crests let none of it through.
Scene withOpaqueCrests(Scene scene) {
    scene.water->refraction->scatteringPerM = 0;
    return scene;
}

/// Below the horizon, from the left to a share of the width.
struct Light {
    double traced = 0, drawn = 0;
    double ratio() const { return drawn / traced; }
};

Light lightOf(const Scene& scene, double to) {
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    EXPECT_TRUE(host) << error.text;
    if (!host) return {};
    const Light light = {lightIn(trace(scene), 0, to), lightIn(render(*host, scene), 0, to)};
    std::printf("%.2f traced, %.2f drawn\n", light.traced, light.drawn);
    return light;
}

/// Facets that mirror a low sun lean towards it, as do the sides of longer waves that they are on: few of
/// them stand in the shadow of others, however rough the sea is.
TEST(SeaOfTheHost, MirrorsAsMuchOfALowSunAsTraced) {
    Scene scene = withOpaqueCrests(stormInLowSun("far"));
    scene.water->foam.reset();
    // 0.69 where each facet is as likely in shadow as any other (Smith).
    EXPECT_NEAR(lightOf(scene, 1).ratio(), 1, 0.12);
}

/// Foam behind a crest is in its shadow.
TEST(SeaOfTheHost, LightsNoFoamBehindCrests) {
    EXPECT_NEAR(lightOf(withOpaqueCrests(stormInLowSun("near")), 0.4).ratio(), 1, 0.25);
}

/// A low sun shines through the crests of waves alone: lower down it would enter where they cast their
/// shadow.
TEST(SeaOfTheHost, LightsCrestsAloneFromBehind) {
    const Scene scene = stormInLowSun("near");
    const Light with = lightOf(scene, 1), without = lightOf(withOpaqueCrests(scene), 1);
    // 11 where what hides the sun is not looked for.
    EXPECT_NEAR((with.drawn - without.drawn) / (with.traced - without.traced), 1, 0.3);
}

/// No wave of a mirror-calm lake rises before another: what looks for such must find none, however small the
/// waves are beside the cells that they are drawn by.
TEST(SeaOfTheHost, SeesNothingHiddenOnACalmLake) {
    Error error;
    std::optional<Scene> scene = loadScene(tests::demoScene("lake"), {}, error);
    ASSERT_TRUE(scene) << error.text;
    const std::unique_ptr<Host> host = Host::create({}, error);
    ASSERT_TRUE(host) << error.text;
    const Picture mean = render(*host, *scene);
    scene->water->shading.waveShadowSteps = 12;
    const double off = difference(render(*host, *scene), mean, scene->exposureEv);
    std::printf("off by %.3f of 255\n", off);
    EXPECT_LT(off, 0.2);
}

} // namespace
