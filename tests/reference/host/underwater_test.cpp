// An eye in the water: what the reference says of it has a closed form over still water, and the host agrees.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "host/host.h"
#include "measure/picture_error.h"
#include "metrics/compare.h"
#include "scene/fields.h"
#include "scene/without.h"
#include "tests/program/demo_scenes.h"
#include "tests/reference/camera_of.h"
#include "tests/reference/mean_difference.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;
using tests::cameraOf;

PixelView view(const Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

/// Rougher than the scene's, so that what is mirrored is blurred.
std::vector<std::string> breeze() {
    return {"water.waves.wind_m_s=4.5", "water.waves.swells=[]"};
}

class UnderwaterHost : public testing::Test {
  protected:
    void SetUp() override {
        take("harbour");
        Error error;
        HostDesc desc;
        desc.validation = true;
        host_ = Host::create(desc, error);
        ASSERT_TRUE(host_) << error.text;
    }
    void take(const char* name, const std::vector<std::string>& overrides = {}) {
        Error error;
        const auto scene = loadScene(tests::demoScene(name), overrides, error);
        ASSERT_TRUE(scene) << error.text;
        scene_ = *scene;
        takeUntraced(*scene_.water);
    }
    Picture render(const CameraDesc& camera) {
        Error error;
        const std::optional<Picture> picture =
            host_->render({width, height, camera, scene_.timeS, Aov::color}, error);
        EXPECT_TRUE(picture) << error.text;
        return *picture;
    }
    Picture trace(const CameraDesc& camera, uint32_t samples) {
        return tests::traced(scene_, {width, height, camera, scene_.timeS, samples}).color;
    }

    static constexpr uint32_t width = 160, height = 90;
    Scene scene_;
    std::unique_ptr<Host> host_;
};

TEST_F(UnderwaterHost, LooksAsTheReferenceTracesIt) {
    // In the scene's clearer water more of the walls shows: HDR-FLIP 0.110 from below, 0.148 where it
    // straddles.
    take("harbour", {"water.refraction.absorption_per_m=[0.55, 0.13, 0.16]",
                     "water.refraction.backscatter_per_m=[0.006, 0.012, 0.011]"});
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    // The reference lights each face from where light comes from in water; the renderer knows no faces and
    // takes the host's light for that on a level bed, which the sky's is not on walls.
    for (const auto& [name, most] : {std::pair{"below", 0.1}, {"straddle", 0.14}}) {
        const CameraDesc camera = cameraOf(scene_, name);
        const Picture traced = trace(camera, 4), rendered = render(camera);
        const Comparison c = compare(view(traced), view(rendered), PictureKind::linear, {});
        std::printf("%s: HDR-FLIP %.4f\n", name, c.flipMean);
        EXPECT_EQ(c.notFiniteInReference + c.notFiniteInTest, 0u);
        EXPECT_LT(c.flipMean, most) << name;
    }
    EXPECT_EQ(host_->validationMessages(), 0u);
}

class CrossedSurface : public UnderwaterHost, public testing::WithParamInterface<int> {};

TEST_P(CrossedSurface, NeverJumpsByAMillimetre) {
    const int steps = GetParam();
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    CameraDesc camera = cameraOf(scene_, "straddle");
    std::vector<Picture> pictures;
    for (int i = -steps; i <= steps; ++i) {
        camera.positionM[1] = 0.001 * i;
        camera.targetM[1] = 0.6 + 0.001 * i;
        pictures.push_back(render(camera));
    }
    std::vector<double> changes;
    for (size_t i = 1; i < pictures.size(); ++i)
        changes.push_back(
            compare(view(pictures[i - 1]), view(pictures[i]), PictureKind::linear, {}).flipMean);
    for (size_t i = 2; i + 2 < changes.size(); ++i) {
        const double beside = std::max({changes[i - 2], changes[i - 1], changes[i + 1], changes[i + 2]});
        EXPECT_LT(changes[i], 1.5 * beside + 0.005) << "step to " << static_cast<int>(i) + 1 - steps << " mm";
    }
    std::printf("FLIP of a millimetre: %.4f to %.4f\n", *std::ranges::min_element(changes),
                *std::ranges::max_element(changes));
}
// The near plane is some 8 cm high: through all of it in larger steps after these.
INSTANTIATE_TEST_SUITE_P(, CrossedSurface, testing::Values(8, 30),
                         [](const auto& info) { return info.param == 8 ? "Narrowly" : "Widely"; });

/// Ripples that nothing resolves blur what the surface mirrors of the bed: the more so the farther it lies.
TEST_F(UnderwaterHost, MirrorsTheBedAsSoftlyAsItIsTraced) {
    take("underwater", breeze());
    Error error;
    const CameraDesc camera = cameraOf(scene_, "far");
    const std::vector<uint8_t> traced = toneMap(trace(camera, 16), scene_.exposureEv);
    const auto surface = [](const std::vector<uint8_t>& picture) { // the upper third
        return std::span(picture).first(picture.size() / 3);
    };
    for (const auto& [samples, most] : {std::pair{1u, 6.7}, {2u, 6.2}, {4u, 5.7}}) {
        scene_.water->shading.reflectionSamples = samples;
        ASSERT_TRUE(host_->load(scene_, error)) << error.text;
        const std::vector<uint8_t> rendered = toneMap(render(camera), scene_.exposureEv);
        const double off = tests::meanDifference(surface(traced), surface(rendered));
        std::printf("%u samples: off by %.2f of 255\n", samples, off);
        EXPECT_LT(off, most) << samples;
    }
    EXPECT_EQ(host_->validationMessages(), 0u);
}

/// Towards the picture's border what is mirrored lies beyond it, and the picture shows no bed where the ray
/// is first thought to end.
TEST_F(UnderwaterHost, MirrorsABedBeyondThePictureThatEndsFarOff) {
    take("underwater", breeze());
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    const CameraDesc camera = cameraOf(scene_, "near");
    const Picture traced = trace(camera, 16), rendered = render(camera);
    double sums[2] = {};
    for (size_t i = 0; i < size_t(10) * width; ++i) { // upper rows: the surface, and little before it
        sums[0] += static_cast<double>(traced.rgba[4 * i + 2]);
        sums[1] += static_cast<double>(rendered.rgba[4 * i + 2]);
    }
    std::printf("blue light of the surface: %.3f of the traced\n", sums[1] / sums[0]);
    EXPECT_GT(sums[1] / sums[0], 0.92); // 0.81 where that was taken for endless water
    EXPECT_LT(sums[1] / sums[0], 1.05);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

/// An eye that looks up: what the surface mirrors around the window is a bed that no pixel of the scene
/// shows, and beyond the border of the mirrored picture where waves tilt it.
TEST_F(UnderwaterHost, MirrorsABedThatThePictureDoesNotShow) {
    take("underwater", breeze());
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    const CameraDesc camera = cameraOf(scene_, "up");
    const std::vector<uint8_t> traced = toneMap(trace(camera, 16), scene_.exposureEv),
                               rendered = toneMap(render(camera), scene_.exposureEv);
    size_t darker = 0;
    for (size_t i = 1; i < traced.size(); i += 3) darker += rendered[i] + 30 < traced[i]; // green
    const double share = static_cast<double>(darker) / (width * height);
    std::printf("much darker than traced: %.2f %%\n", 100 * share);
    EXPECT_LT(share, 0.02); // 0.027 where that was taken for endless water
    EXPECT_EQ(host_->validationMessages(), 0u);
}

/// What stands in the water goes on above it: no sky between both, nor behind what is thin.
TEST_F(UnderwaterHost, SeesNoSkyBetweenABoatsSidesAndItsBottom) {
    take("underwater", breeze());
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    const CameraDesc camera = cameraOf(scene_, "up");
    constexpr uint32_t across = 320, up = 180;
    const auto traced =
        toneMap(tests::traced(scene_, {across, up, camera, scene_.timeS, 16}).color, scene_.exposureEv);
    const std::optional<Picture> picture =
        host_->render({across, up, camera, scene_.timeS, Aov::color}, error);
    ASSERT_TRUE(picture) << error.text;
    const std::vector<uint8_t> rendered = toneMap(*picture, scene_.exposureEv);
    size_t boat = 0, sky = 0;
    for (uint32_t y = 72; y < 132; ++y)
        for (uint32_t x = 136; x < 190; ++x) {
            const size_t i = 3 * (size_t{y} * across + x);
            if (traced[i + 2] > 90) continue; // dim, and wholly within the boat
            ++boat;
            sky += rendered[i + 2] > 130;
        }
    std::printf("%zu of the boat's %zu pixels are sky\n", sky, boat);
    EXPECT_GT(boat, 500u);
    EXPECT_LT(sky, 8u);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

/// A low sun's bright sky is overhead under water: sides and undersides of what swims there are dim.
TEST_F(UnderwaterHost, TheSkyOfAnEveningLightsSidesAsDimlyAsItIsTraced) {
    std::vector<std::string> evening = breeze();
    for (const char* const sun :
         {"sun.azimuth_deg=298", "sun.elevation_deg=7.5", "sun.irradiance=[8.685, 4.944, 1.910]"})
        evening.emplace_back(sun);
    take("underwater", evening);
    Error error;
    ASSERT_TRUE(host_->load(scene_, error)) << error.text;
    CameraDesc camera = cameraOf(scene_, "middle");
    camera.positionM = {6.06, -0.2, 6.77};
    camera.targetM = {3.83, -1.92, -2.82};
    camera.verticalFovDeg = 30;
    const Picture traced = trace(camera, 16), rendered = render(camera);
    double truth = 0, excess = 0;
    for (size_t i = size_t{20} * width; i < size_t{width} * height; ++i) { // below the surface
        const float blue = traced.rgba[4 * i + 2];
        truth += double{blue};
        excess += std::max(double{rendered.rgba[4 * i + 2]} - double{blue}, 0.0);
    }
    std::printf("%.3f too much\n", excess / truth);
    EXPECT_LT(excess, 0.06 * truth); // 0.083 where the horizon shone on them as it does in air
    EXPECT_EQ(host_->validationMessages(), 0u);
}

/// What it mirrors of the water below lies where rays find it: beyond the window, all of the picture's
/// surface.
TEST_F(UnderwaterHost, MirrorsTheBedWhereItIsTraced) {
    takeWaves(*scene_.water);
    const CameraDesc camera = cameraOf(scene_, "below");
    for (const std::string technique : {"sspr", "ssr", "hybrid", "planar"}) {
        Error error;
        scene_.water->reflection->technique = demos::techniqueNamed(technique);
        ASSERT_TRUE(host_->load(scene_, error)) << error.text;
        measure::Shots shots;
        ASSERT_TRUE(takeShots(*host_, {width, height, camera, scene_.timeS, Aov::color, 0}, shots, error))
            << error.text;
        const reference::Pictures truth = tests::traced(scene_, {width, height, camera, scene_.timeS}, true);
        const auto off = errorOf(truth, shots, scene_.exposureEv, error);
        ASSERT_TRUE(off && off->coverage && off->positionPxP50 && off->psnrDb) << error.text;
        std::printf("%s: found %.1f %%, off %.2f px (p95 %.2f), %.1f dB\n", technique.c_str(),
                    100 * *off->coverage, *off->positionPxP50, *off->positionPxP95, *off->psnrDb);
        EXPECT_GT(*off->coverage, 0.8) << technique;
        EXPECT_LT(*off->positionPxP50, 0.25) << technique;
        EXPECT_GT(*off->psnrDb, 15) << technique;
    }
    EXPECT_EQ(host_->validationMessages(), 0u);
}

} // namespace
