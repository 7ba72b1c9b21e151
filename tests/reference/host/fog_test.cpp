// Fog, as the host's materials, the water and the reference have it: the same.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "host/host.h"
#include "metrics/compare.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/camera_of.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 192, height = 108;

const FogDesc clearAir = {.densityPerM = 0};
const FogDesc mist = {.densityPerM = 0.01, .color = {0.3, 0.33, 0.38}};
const FogDesc lowFog = {
    .shape = "height", .densityPerM = 0.04, .falloffPerM = 0.15, .color = {0.3, 0.33, 0.38}, .fromSky = 0.5};

class FogInScenes : public testing::Test {
  protected:
    void SetUp() override {
        Error error;
        HostDesc desc;
        desc.validation = true;
        host_ = Host::create(desc, error);
        ASSERT_TRUE(host_) << error.text;
    }
    void TearDown() override {
        ASSERT_TRUE(host_);
        EXPECT_EQ(host_->validationMessages(), 0u);
    }

    Picture draw(const Scene& scene) { return tests::rendered(*host_, scene, width, height); }

    double flipFromTraced(const Scene& scene) {
        const Picture drawn = draw(scene),
                      traced =
                          tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 9}).color;
        const Comparison c =
            compare({width, height, traced.rgba}, {width, height, drawn.rgba}, PictureKind::linear, {});
        EXPECT_EQ(c.notFiniteInReference + c.notFiniteInTest, 0u);
        return c.flipMean;
    }

    std::unique_ptr<Host> host_;
};

Scene harbour(const char* camera) {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene("harbour"), {}, error);
    if (!scene) throw std::runtime_error(error.text);
    Scene taken = *scene;
    taken.cameras = {tests::cameraOf(taken, camera)};
    return taken;
}

// Fog hides what differs, so a foggy picture is nearer to its trace than a clear one.
TEST_F(FogInScenes, HarbourLooksAsTraced) {
    for (const char* const camera : {"level", "below"}) {
        Scene scene = harbour(camera);
        const double clear = flipFromTraced(scene);
        for (const FogDesc& fog : {mist, lowFog}) {
            scene.fog = fog;
            const double foggy = flipFromTraced(scene);
            std::printf("%s, %s: FLIP %.4f, clear %.4f\n", camera, fog.shape.c_str(), foggy, clear);
            EXPECT_LT(foggy, clear + 0.002) << camera << ", " << fog.shape;
        }
    }
}

TEST_F(FogInScenes, PlanarReflectionsHaveItOnce) {
    Scene scene = harbour("level");
    scene.water->reflection->technique = seaglass::ReflectionTechnique::planar;
    const double clear = flipFromTraced(scene);
    scene.fog = mist;
    EXPECT_LT(flipFromTraced(scene), clear + 0.002);
}

TEST_F(FogInScenes, OfNoDensityIsNone) {
    Scene scene = harbour("level");
    const Picture without = draw(scene);
    scene.fog = clearAir;
    const Picture with = draw(scene);
    double apart = 0;
    for (size_t i = 0; i < with.rgba.size(); ++i)
        apart = std::max(
            apart, static_cast<double>(std::abs(with.rgba[i] - without.rgba[i]) / (0.01f + without.rgba[i])));
    EXPECT_LT(apart, 0.01);
}

/// Water to the left and a plate as high to the right, which fog of no light of its own dims alike.
Scene plateBesideWater(double orthographicHeightM) {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sun.irradiance = {0, 0, 0};
    scene.meshes = {{tests::writeBoxes("plate", {{{0, -1, -300}, {300, 0.002, 20}}}, 0.8)}};
    scene.water.emplace();
    CameraDesc camera;
    camera.positionM = {0, 4, 10};
    camera.targetM = {0, 0, -40};
    camera.orthographicHeightM = orthographicHeightM;
    scene.cameras = {camera};
    return scene;
}

TEST_F(FogInScenes, DimsWaterAndAPlateAtTheSameDistanceAlike) {
    for (const double orthographic : {0.0, 12.0})
        for (const char* const shape : {"linear", "exponential", "exponential-squared", "height"}) {
            Scene scene = plateBesideWater(orthographic);
            const Picture clear = draw(scene);
            scene.fog = FogDesc{.shape = shape,
                                .densityPerM = 0.02,
                                .startM = 4,
                                .endM = 120,
                                .falloffPerM = 0.2,
                                .baseHeightM = 1,
                                .color = {0, 0, 0},
                                .overSky = false};
            const Picture foggy = draw(scene);
            const auto passes = [&](uint32_t x, uint32_t y) {
                const size_t i = (size_t{y} * width + x) * 4;
                return static_cast<double>(foggy.rgba[i] / clear.rgba[i]);
            };
            double least = 1, most = 0;
            for (uint32_t y = height / 2 + 2; y < height; ++y)
                for (uint32_t away = 1; away < width / 2; away += 7) {
                    const double water = passes(width / 2 - 1 - away, y), plate = passes(width / 2 + away, y);
                    ASSERT_NEAR(water, plate, 0.005 + 0.01 * plate) << shape << ", " << away << ", " << y;
                    least = std::min(least, plate);
                    most = std::max(most, plate);
                }
            EXPECT_LT(least, 0.75 * most) << shape << ": the test shows what it is about";
        }
}

/// Mean of a row's luminance.
double rowLuminance(const Picture& picture, uint32_t y) {
    double sum = 0;
    for (uint32_t x = 0; x < width; ++x) {
        const float* const p = &picture.rgba[(size_t{y} * width + x) * 4];
        sum += 0.2126 * static_cast<double>(p[0]) + 0.7152 * static_cast<double>(p[1]) +
               0.0722 * static_cast<double>(p[2]);
    }
    return sum / width;
}

/// A wall 40 m away across what mirrors it.
Scene wallAcross(bool floor) {
    Scene scene;
    scene.sky.file = tests::demoTexture("harbour_sky.exr");
    scene.sun.irradiance = {0, 0, 0};
    scene.meshes = {{tests::writeBoxes("wall", {{{-40, -1, -42}, {40, 12, -40}}}, 0.8)}};
    if (floor) {
        FloorDesc& polished = scene.floor.emplace();
        polished.widthM = polished.lengthM = 100;
        polished.color = {0, 0, 0};
        polished.reflectance = 1;
        polished.reflection.emplace();
    } else {
        scene.water.emplace().reflection.emplace();
    }
    CameraDesc camera;
    camera.positionM = {0, 3, 0};
    camera.targetM = {0, 0, -20};
    camera.verticalFovDeg = 50;
    scene.cameras = {camera};
    return scene;
}

/// Of no light of its own, and none before the sky.
void makeFoggy(Scene& scene) {
    scene.fog = FogDesc{.shape = "exponential", .densityPerM = 0.03, .color = {0, 0, 0}, .overSky = false};
}

/// What share of a pixel's light passes the fog, in the middle column, where the wall is mirrored.
std::vector<double> passing(const Picture& foggy, const Picture& clear) {
    std::vector<double> shares;
    for (uint32_t y = height / 2; y < height * 2 / 3; y += 4) {
        const size_t i = (size_t{y} * width + width / 2) * 4 + 1;
        shares.push_back(static_cast<double>(foggy.rgba[i] / clear.rgba[i]));
    }
    return shares;
}

// A mirrored picture has the fog that the eye's own has before the same things.
TEST_F(FogInScenes, WhatIsDrawnFromAMirroredEyeIsAsDimAsWhatIsMirrored) {
    const auto mirrored = [&](const Scene& scene) {
        Error error;
        EXPECT_TRUE(host_->load(scene, error)) << error.text;
        const std::optional<Picture> picture =
            host_->render({width, height, scene.cameras[0], 0, Aov::reflection}, error);
        EXPECT_TRUE(picture) << error.text;
        return picture.value_or(Picture{});
    };
    std::vector<double> shares[2];
    for (const bool planar : {false, true}) {
        Scene scene = wallAcross(false);
        scene.water->reflection->technique =
            planar ? seaglass::ReflectionTechnique::planar : seaglass::ReflectionTechnique::sspr;
        const Picture clear = mirrored(scene);
        makeFoggy(scene);
        shares[planar ? 1 : 0] = passing(mirrored(scene), clear);
    }
    for (size_t i = 0; i < shares[0].size(); ++i) {
        std::printf("%.4f %.4f\n", shares[0][i], shares[1][i]);
        EXPECT_NEAR(shares[1][i], shares[0][i], 0.01 * shares[0][i]);
    }
}

TEST_F(FogInScenes, AFloorMirrorsWhatHasItAlready) {
    Scene scene = wallAcross(true);
    const auto trace = [&] {
        return tests::traced(scene, {width, height, scene.cameras.front(), 0, 4}).color;
    };
    const Picture clear = draw(scene), tracedClear = trace();
    makeFoggy(scene);
    const std::vector<double> drawn = passing(draw(scene), clear), traced = passing(trace(), tracedClear);
    for (size_t i = 0; i < drawn.size(); ++i) {
        std::printf("%.4f %.4f\n", drawn[i], traced[i]);
        EXPECT_NEAR(drawn[i], traced[i], 0.05 * traced[i]);
    }
}

// Where haze hides the sea, the horizon is no edge: from 1 km up the sea ends in haze of the sky's
// brightness.
TEST_F(FogInScenes, MeetsTheSkyAtTheHorizon) {
    for (const char* const sky : {"ocean_sky.exr", "pool_sky.exr", "storm_sky.exr"}) {
        Scene scene;
        scene.sky.file = tests::demoTexture(sky);
        scene.sun.irradiance = {0, 0, 0};
        scene.fog = FogDesc{
            .shape = "height", .densityPerM = 1.2e-4, .falloffPerM = 5e-4, .fromSky = 1, .overSky = false};
        scene.water.emplace();
        CameraDesc camera;
        camera.positionM = {0, 1000, 0};
        camera.targetM = {0, 1000, -100};
        scene.cameras = {camera};
        const Picture seen = draw(scene);
        const double above = rowLuminance(seen, height / 2 - 2), below = rowLuminance(seen, height / 2 + 1);
        std::printf("%s: the horizon's haze has %.2f of the sky's light\n", sky, below / above);
        EXPECT_NEAR(below / above, 1, 0.12) << sky;
    }
}

} // namespace
