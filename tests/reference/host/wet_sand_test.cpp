// The demo's sand where waves have been: as dark as the library says that it is wet, and as traced.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "host/camera.h"
#include "host/host.h"
#include "host/water/shore.h"
#include "host/water/waves.h"
#include "seaglass/shore.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/box_file.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

constexpr uint32_t width = 128, height = 72;
constexpr double timeS = 39.5;

/// Down the beach, from over its edge.
CameraDesc overTheBeach() {
    CameraDesc camera;
    camera.positionM = {-8, 22, 18};
    camera.targetM = {-8, 0, 16};
    camera.verticalFovDeg = 50;
    return camera;
}

Scene shore() {
    Error error;
    const std::optional<Scene> scene = loadScene(tests::demoScene("shore"), {}, error);
    EXPECT_TRUE(scene) << error.text;
    Scene out = scene.value_or(Scene{});
    out.timeS = timeS;
    return out;
}

Picture drawn(const Scene& scene, Aov aov) {
    Error error;
    const std::unique_ptr<Host> host = Host::create({}, error);
    std::optional<Picture> picture;
    if (host && host->load(scene, error))
        picture = host->render({width, height, overTheBeach(), timeS, aov}, error);
    EXPECT_TRUE(picture) << error.text;
    return picture.value_or(Picture{});
}

/// Of what is opaque.
Picture depthOf(Scene scene) {
    scene.water.reset();
    return drawn(scene, Aov::depth);
}

double brightnessAt(const Picture& picture, size_t i) {
    return 0.2126 * double{picture.rgba[4 * i]} + 0.7152 * double{picture.rgba[4 * i + 1]} +
           0.0722 * double{picture.rgba[4 * i + 2]};
}

/// How wet each pixel's sand is, by the library's own word on the CPU.
std::vector<seaglass::ShoreWetness> wetnessOf(const Scene& scene, const Picture& depth) {
    Error error;
    SceneSea sea;
    SceneShore bed;
    EXPECT_TRUE(seaOf(*scene.water->waves, sea, error) &&
                shoreOf(*scene.water->shore, waterPlane(*scene.water), bed, error));
    sea.desc.shore = &bed.desc;
    seaglass::SeaError problem;
    seaglass::Sea* const made = seaglass::createSea(&sea.desc, &problem);
    EXPECT_NE(made, nullptr) << problem.text;
    std::vector<float> rows(size_t{4} * seaglass::shoreRowCount(*made, 45));
    const double eye[2] = {0, 0};
    const seaglass::ShoreBlock block = seaglass::shoreRows(*made, timeS, 45, eye, rows.data());
    Camera camera;
    EXPECT_TRUE(makeCamera(overTheBeach(), double{width} / height, camera, error));
    std::vector<seaglass::ShoreWetness> out;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double right = (2 * (x + 0.5) / width - 1) * camera.tanHalfFovX,
                         up = (1 - 2 * (y + 0.5) / height) * camera.tanHalfFovY;
            const double along{depth.rgba[(size_t{y} * width + x) * 4]};
            const glm::dvec3 at =
                camera.eye + along * (camera.forward + right * camera.right + up * camera.up);
            out.push_back(seaglass::shoreWetness(*made, block, rows.data(), at.x, at.z, at.y));
        }
    seaglass::destroySea(made);
    return out;
}

TEST(WetSand, IsHalfAsBrightWhereWavesHaveBeenAndAsItWasElsewhere) {
    const Scene wetted = shore();
    Scene dried = wetted;
    dried.water->shore.reset();
    const Picture wet = drawn(wetted, Aov::scene), dry = drawn(dried, Aov::scene);
    const std::vector<seaglass::ShoreWetness> wetness = wetnessOf(wetted, depthOf(wetted));
    double soaked = 0, asItWas = 0, worst = 0;
    size_t soakedCount = 0, dryCount = 0;
    for (size_t i = 0; i < wetness.size(); ++i) {
        const double ratio = brightnessAt(wet, i) / brightnessAt(dry, i);
        if (wetness[i].wet > 0.99 && wetness[i].under < 0.01) {
            soaked += ratio;
            ++soakedCount;
        }
        if (wetness[i].wet < 1e-3) {
            asItWas += ratio;
            worst = std::max(worst, std::abs(ratio - 1));
            ++dryCount;
        }
    }
    ASSERT_GT(soakedCount, 200u);
    ASSERT_GT(dryCount, 200u);
    std::printf("wet sand is %.2f times as bright (%zu pixels), dry sand %.3f (%zu pixels)\n",
                soaked / double(soakedCount), soakedCount, asItWas / double(dryCount), dryCount);
    EXPECT_NEAR(soaked / static_cast<double>(soakedCount), 0.5, 0.1);
    EXPECT_NEAR(asItWas / static_cast<double>(dryCount), 1, 0.01);
    EXPECT_LT(worst, 0.3) << "near the edge of what is wet a pixel may be of both";
}

TEST(WetSand, LooksAsTraced) {
    const Scene scene = shore();
    const Picture seen = drawn(scene, Aov::color);
    reference::FrameDesc frame{width, height, overTheBeach()};
    frame.timeS = timeS;
    const Picture traced = tests::traced(scene, frame).color;
    const std::vector<seaglass::ShoreWetness> wetness = wetnessOf(scene, depthOf(scene));
    double drawnSum = 0, tracedSum = 0, off = 0;
    size_t count = 0;
    for (size_t i = 0; i < wetness.size(); ++i) {
        if (wetness[i].wet < 0.1 || wetness[i].under > 0.01) continue;
        const double a = brightnessAt(seen, i), b = brightnessAt(traced, i);
        drawnSum += a;
        tracedSum += b;
        off += std::abs(a - b);
        ++count;
    }
    ASSERT_GT(count, 300u);
    std::printf("%zu pixels of wet sand: %.3f drawn, %.3f traced, %.3f apart\n", count,
                drawnSum / double(count), tracedSum / double(count), off / double(count));
    EXPECT_NEAR(drawnSum / tracedSum, 1, 0.05);
    EXPECT_LT(off, 0.1 * tracedSum);
}

/// What is painted or polished takes no water up where what is rough beside it does.
TEST(WetSand, StopsAtWhatIsPainted) {
    Scene wetted = shore();
    const std::vector<tests::Box> rough = {{{-30, -4, 8}, {-8, 0.4, 30}}},
                                  painted = {{{-8, -4, 8}, {14, 0.4, 30}}};
    wetted.meshes = {{tests::writeBoxes("rough", rough, 0.5)},
                     {tests::writeBoxes("painted", painted, 0.5, 0.4)}};
    Scene dried = wetted;
    dried.water->shore.reset();
    const Picture wet = drawn(wetted, Aov::scene), dry = drawn(dried, Aov::scene);
    double least[2] = {9, 9}, most[2] = {0, 0};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            if (x > width / 2 - 3 && x < width / 2 + 3) continue;
            const size_t i = size_t{y} * width + x, side = x < width / 2 ? 0 : 1;
            const double ratio = brightnessAt(wet, i) / brightnessAt(dry, i);
            least[side] = std::min(least[side], ratio);
            most[side] = std::max(most[side], ratio);
        }
    std::printf("rough %.3f to %.3f, painted %.3f to %.3f\n", least[0], most[0], least[1], most[1]);
    EXPECT_LT(least[0], 0.6);
    EXPECT_GT(least[1], 0.99);
    EXPECT_LT(most[1], 1.01);
}

} // namespace
