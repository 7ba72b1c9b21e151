// The first picture of a new host: deep water with waves and a sky of colours, without any image of the
// host's, is as bright as the traced one.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>

#include <glm/geometric.hpp>

#include "host/files/image_file.h"
#include "host/water/waves.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace tests;

constexpr uint32_t width = 160, height = 90;

class FirstPicture : public WaterTest {
  protected:
    /// The sky of LightingDesc's own colours.
    static std::filesystem::path skyFile(const seaglass::LightingDesc& light) {
        demos::Picture sky = {512, 256, {}};
        for (uint32_t y = 0; y < sky.height; ++y)
            for (uint32_t x = 0; x < sky.width; ++x) {
                const double up = std::cos(std::numbers::pi * (y + 0.5) / sky.height);
                float radiance[3];
                skyRadiance(light, {std::sqrt(1 - up * up), up, 0}, radiance);
                sky.rgba.insert(sky.rgba.end(), {radiance[0], radiance[1], radiance[2], 1});
            }
        const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "sky_of_colors.exr";
        demos::Error error;
        EXPECT_TRUE(writeExr(file, sky, error)) << error.text;
        return file;
    }

    static demos::Scene sceneOf(const seaglass::LightingDesc& light, double windMps, const Camera& camera) {
        demos::Scene scene;
        scene.timeS = 5;
        scene.sky.file = skyFile(light);
        scene.sun.azimuthDeg = 300;
        scene.sun.elevationDeg = 40;
        for (size_t i = 0; i < 3; ++i) scene.sun.irradiance[i] = double{light.sunIrradiance[i]};
        demos::WaterDesc& water = scene.water.emplace();
        demos::WavesDesc& waves = water.waves.emplace();
        waves.windMps = windMps;
        waves.fetchM = 50e3;
        water.refraction.emplace();
        demos::CameraDesc& view = scene.cameras.emplace_back();
        for (int i = 0; i < 3; ++i) {
            view.positionM[static_cast<size_t>(i)] = camera.eye[i];
            view.targetM[static_cast<size_t>(i)] = camera.target[i];
        }
        view.verticalFovDeg = camera.fovDegrees;
        return scene;
    }
};

/// Mean luminance (Rec. 709) of both pictures where both show water.
double stopsApart(const WaterPicture& drawn, const demos::Picture& traced) {
    double a = 0, b = 0;
    size_t count = 0;
    const auto luminance = [](const float* p) {
        return 0.2126 * double{p[0]} + 0.7152 * double{p[1]} + 0.0722 * double{p[2]};
    };
    for (size_t i = 0; i < size_t{width} * height; ++i) {
        if (!drawn.covered(i)) continue;
        ++count;
        a += luminance(&drawn.color[4 * i]);
        b += luminance(&traced.rgba[4 * i]);
    }
    EXPECT_GT(count, size_t{width} * height / 3);
    const double stops = std::log2(a / b);
    std::printf("%.3f drawn, %.3f traced: %+.3f stops\n", a / static_cast<double>(count),
                b / static_cast<double>(count), stops);
    return stops;
}

TEST_F(FirstPicture, IsAsBrightAsTheTracedOne) {
    // All that a first host says: where the sun is and how bright.
    seaglass::LightingDesc light;
    const double azimuth = glm::radians(300.0), elevation = glm::radians(40.0);
    light.toSun[0] = std::cos(elevation) * std::cos(azimuth);
    light.toSun[1] = std::sin(elevation);
    light.toSun[2] = std::cos(elevation) * std::sin(azimuth);
    Camera camera;
    camera.width = width;
    camera.height = height;
    changeView = [](seaglass::ViewDesc& view) { view.sceneColor = view.sceneDepth = {}; };
    for (const float sun : {0.0f, 3.0f})
        for (const double wind : {3.0, 10.0})
            for (const double down : {0.5, 6.0, 60.0}) { // over 10 m
                for (float& channel : light.sunIrradiance) channel = sun;
                camera.eye = {3, 4, 7};
                camera.target = camera.eye + glm::dvec3(0, -down, -10);
                const demos::Scene scene = sceneOf(light, wind, camera);
                demos::SceneSea sea;
                demos::Error error;
                ASSERT_TRUE(seaOf(*scene.water->waves, sea, error)) << error.text;
                const seaglass::RefractionDesc refraction;
                seaglass::BodyDesc desc;
                desc.waves = &sea.desc;
                desc.wavesBackend = demos::wavesBackend();
                desc.refraction = &refraction;
                lighting = light;
                const WaterPicture drawn = picture({makeBody(desc)}, camera, 5);
                const demos::Picture traced =
                    tests::traced(scene, {width, height, scene.cameras.front(), scene.timeS, 8}).color;
                EXPECT_NEAR(stopsApart(drawn, traced), 0, 0.2) << sun << " " << wind << " " << down;
            }
}

} // namespace
