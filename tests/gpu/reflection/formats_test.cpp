// What a host hands in: formats of colour and depth, and what is refused.
#include "gpu/view/scene_formats.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"
#include "tests/gpu/rig/scene_images.h"

namespace {

using namespace seaglass;
using namespace tests;

struct Format {
    VkFormat format;
    const char* name;
};

std::string nameOf(const testing::TestParamInfo<Format>& info) {
    return info.param.name;
}

class Formats : public ReflectionTest, public testing::WithParamInterface<Format> {
  protected:
    Reflected reflected(const Camera& camera, const demos::Image& color, const demos::Image& depth,
                        ReflectionTechnique technique) {
        ReflectorDesc desc;
        desc.reflection.technique = technique;
        ViewDesc view = viewDesc(camera);
        view.sceneColor = asSeaglass(color);
        view.sceneDepth = asSeaglass(depth);
        return reflectImages(view, desc);
    }
};

constexpr ReflectionTechnique screenTechniques[] = {ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                                    ReflectionTechnique::hybrid};

class ColorFormats : public Formats {};

TEST_P(ColorFormats, ChangeNothingButTheColorsPrecision) {
    const VkFormat format = GetParam().format;
    if (!canSample(format)) GTEST_SKIP() << "the device cannot sample " << GetParam().name;
    const Camera camera = testCamera();
    const VkExtent2D extent = {camera.width, camera.height};
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const demos::Image depth = uploadDepth(VK_FORMAT_D32_SFLOAT, extent, traced.depth);
    const demos::Image exact = uploadColor(VK_FORMAT_R32G32B32A32_SFLOAT, extent, traced.color);
    const demos::Image color = uploadColor(format, extent, traced.color);
    for (const ReflectionTechnique technique : screenTechniques) {
        const Reflected expected = reflected(camera, exact, depth, technique);
        const Reflected found = reflected(camera, color, depth, technique);
        ASSERT_EQ(expected.info, found.info);
        float largest = 0;
        for (size_t i = 0; i < found.color.size(); ++i)
            largest = std::max(largest, std::abs(found.color[i] - expected.color[i]));
        // The reflection itself holds halves.
        EXPECT_LE(largest, colorError(format) + 0x1p-10f);
        EXPECT_GT(score(traced, found).coverage, 0.97);
    }
}

constexpr Format colorFormats[] = {
    {VK_FORMAT_R16G16B16A16_SFLOAT, "RGBA16F"}, {VK_FORMAT_B10G11R11_UFLOAT_PACK32, "B10G11R11"},
    {VK_FORMAT_R8G8B8A8_UNORM, "RGBA8_UNORM"},  {VK_FORMAT_R8G8B8A8_SRGB, "RGBA8_SRGB"},
    {VK_FORMAT_B8G8R8A8_UNORM, "BGRA8_UNORM"},  {VK_FORMAT_B8G8R8A8_SRGB, "BGRA8_SRGB"},
};
INSTANTIATE_TEST_SUITE_P(, ColorFormats, testing::ValuesIn(colorFormats), nameOf);

/// Depth matters most where walls are seen from above.
std::vector<Pose> levelAndSteep() {
    std::vector<Pose> chosen = poses();
    std::erase_if(chosen, [](const Pose& pose) {
        return pose.name != std::string("level") && pose.name != std::string("steep");
    });
    return chosen;
}

/// How far a step of the depth moves what is mirrored, in pixels: a wall that is seen from above moves twice
/// as far as one that is faced.
double pixelsPerStep(const Camera& camera, VkFormat format) {
    const double focalPixels = 0.5 * camera.height / std::tan(radians(camera.fovDegrees) / 2);
    return 4 * focalPixels * camera.eye.y / camera.near * depthStep(format, camera.reversed);
}

class DepthFormats : public Formats {
  protected:
    void SetUp() override {
        Formats::SetUp();
        if (!canSample(GetParam().format)) GTEST_SKIP() << "the device cannot sample " << GetParam().name;
    }

    /// As from `traced`, its depth in the format or as exact as it is.
    Score scoreOf(const Camera& camera, const TracedView& traced, VkFormat format,
                  ReflectionTechnique technique) {
        const VkExtent2D extent = {camera.width, camera.height};
        const demos::Image color = uploadColor(VK_FORMAT_R32G32B32A32_SFLOAT, extent, traced.color);
        const demos::Image depth = uploadDepth(format, extent, traced.depth);
        return score(traced, reflected(camera, color, depth, technique));
    }
};

TEST_P(DepthFormats, KeepClassesAndPlaces) {
    for (const Pose& pose : levelAndSteep())
        for (const bool reversed : {true, false}) {
            Camera camera = pose.camera;
            camera.reversed = reversed;
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            for (const ReflectionTechnique technique : screenTechniques) {
                const Score exact = scoreOf(camera, traced, VK_FORMAT_R32_SFLOAT, technique);
                const Score s = scoreOf(camera, traced, GetParam().format, technique);
                print(pose.name, s);
                // Sixteen bits leave whole rows of a steep view at one depth: rounding decides which are
                // found.
                EXPECT_GE(s.coverage, exact.coverage - limitOnDriver(0.01, 0.0125)) << pose.name;
                EXPECT_LE(s.medianPixels, exact.medianPixels + limitOnDriver(0.2, 0.21)) << pose.name;
                EXPECT_LE(s.p95Pixels, exact.p95Pixels + 0.05 + pixelsPerStep(camera, GetParam().format))
                    << pose.name;
                EXPECT_LE(s.falseOnSky, exact.falseOnSky + 0.001) << pose.name;
                EXPECT_LE(s.skyOnGeometry, exact.skyOnGeometry + 0.002) << pose.name;
            }
        }
}

TEST_P(DepthFormats, AFloorInTheDepthIsNoObstacle) {
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back({{-200, -1, -200}, {200, 0, 200}});
    for (const Pose& pose : levelAndSteep()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        TracedView floored = Tracer(pose.camera, boxes).run();
        floored.truth = traced.truth;
        floored.source = traced.source;
        for (const ReflectionTechnique technique : screenTechniques) {
            const Score exact = scoreOf(pose.camera, floored, VK_FORMAT_R32_SFLOAT, technique);
            const Score s = scoreOf(pose.camera, floored, GetParam().format, technique);
            print(pose.name, s);
            EXPECT_GE(s.coverage, exact.coverage - 0.02) << pose.name;
            EXPECT_LE(s.falseOnSky, exact.falseOnSky + 0.002) << pose.name;
        }
    }
}

constexpr Format depthFormats[] = {
    {VK_FORMAT_D16_UNORM, "D16"},
    {VK_FORMAT_D16_UNORM_S8_UINT, "D16_S8"},
    {VK_FORMAT_X8_D24_UNORM_PACK32, "X8_D24"},
    {VK_FORMAT_D24_UNORM_S8_UINT, "D24_S8"},
    {VK_FORMAT_D32_SFLOAT, "D32"},
    {VK_FORMAT_D32_SFLOAT_S8_UINT, "D32_S8"},
    {VK_FORMAT_R16_UNORM, "R16"},
};
INSTANTIATE_TEST_SUITE_P(, DepthFormats, testing::ValuesIn(depthFormats), nameOf);

} // namespace
