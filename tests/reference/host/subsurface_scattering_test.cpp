// Light through crests: the renderer's few looks at the displaced sea gain what rays through it do.
#include <gtest/gtest.h>

#include "host/host.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/camera_of.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 120, height = 68;

Picture rendered(const Scene& scene, const CameraDesc& camera) {
    Error error;
    HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    EXPECT_TRUE(host && host->load(scene, error)) << error.text;
    const std::optional<Picture> picture =
        host->render({width, height, camera, scene.timeS, Aov::color}, error);
    EXPECT_TRUE(picture) << error.text;
    EXPECT_EQ(host->validationMessages(), 0u);
    return *picture;
}

Picture traced(const Scene& scene, const CameraDesc& camera) {
    return tests::traced(scene, {width, height, camera, scene.timeS, 64}).color;
}

using Draw = Picture (*)(const Scene&, const CameraDesc&);

/// What scattering adds to the picture's lower half, where the water is, in the mean.
glm::dvec3 gain(Scene scene, const CameraDesc& camera, double scatteringPerM, Draw draw) {
    scene.water->refraction->scatteringPerM = scatteringPerM;
    const Picture with = draw(scene, camera);
    scene.water->refraction->scatteringPerM = 0;
    const Picture without = draw(scene, camera);
    glm::dvec3 sum(0);
    for (size_t i = with.rgba.size() / 2; i < with.rgba.size(); ++i)
        if (i % 4 < 3)
            sum[static_cast<glm::length_t>(i % 4)] += double{with.rgba[i]} - double{without.rgba[i]};
    return sum / static_cast<double>(with.rgba.size() / 8);
}

TEST(SubsurfaceScatteringHost, GainsWhatRaysThroughTheSeaDo) {
    Error error;
    auto scene = loadScene(tests::demoScene("ocean"), {"water.refraction.type=coastal"}, error);
    ASSERT_TRUE(scene) << error.text;
    const CameraDesc camera = tests::cameraOf(*scene, "low");
    const glm::dvec3 truth = gain(*scene, camera, 20, traced);
    for (const uint32_t steps : {0u, 16u}) {
        scene->water->shading.waveShadowSteps = steps;
        const glm::dvec3 drawn = gain(*scene, camera, 20, rendered);
        std::printf("%2u steps: gain drawn %.4f %.4f %.4f, by rays %.4f %.4f %.4f\n", steps, drawn.r, drawn.g,
                    drawn.b, truth.r, truth.g, truth.b);
        for (glm::length_t c = 0; c < 3; ++c) {
            EXPECT_GT(truth[c], 0.001);
            EXPECT_NEAR(drawn[c] / truth[c], 1, steps == 0 ? 0.3 : 0.15);
        }
    }
}

/// The face of a breaker on a shore, with the sun behind it.
TEST(SubsurfaceScatteringHost, SurfGainsWhatRaysThroughItDo) {
    Error error;
    const auto scene =
        loadScene(tests::demoScene("shore"),
                  {"water.foam.bias=-1", "sky.clear=true", "sun.elevation_deg=25", "sun.azimuth_deg=285",
                   "camera.near.position_m=[-10,1.9,-26]", "camera.near.target_m=[-15,1.05,-52]",
                   "camera.near.vertical_fov_deg=2.6", "time_s=37.5"},
                  error);
    ASSERT_TRUE(scene) << error.text;
    const CameraDesc camera = tests::cameraOf(*scene, "near");
    const glm::dvec3 truth = gain(*scene, camera, 2, traced), drawn = gain(*scene, camera, 2, rendered);
    std::printf("surf: gain drawn %.4f %.4f %.4f, by rays %.4f %.4f %.4f\n", drawn.r, drawn.g, drawn.b,
                truth.r, truth.g, truth.b);
    for (glm::length_t c = 0; c < 3; ++c) {
        EXPECT_GT(truth[c], 0.001);
        EXPECT_NEAR(drawn[c] / truth[c], 1, 0.3);
    }
}

} // namespace
