// Hosts draw planar reflections and beds with the pipelines of their main pass, whatever its formats and
// samples are, and get the picture that Seaglass's usual images give.
#include <algorithm>
#include <cmath>
#include <string>

#include "gpu/view/scene_formats.h"
#include "tests/gpu/host/box_host.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/scene_images.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr VkSampleCountFlagBits one = VK_SAMPLE_COUNT_1_BIT, four = VK_SAMPLE_COUNT_4_BIT;

struct Case {
    const char* name;
    DrawnDesc drawn;
    bool renderPass;
};

std::vector<Case> cases() {
    return {
        {"RenderPassFourSamplesB10G11R11D32S8",
         {VK_FORMAT_B10G11R11_UFLOAT_PACK32, VK_FORMAT_D32_SFLOAT_S8_UINT, {four, four}},
         true},
        {"RenderPassResolvedSrgbD32S8",
         {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_D32_SFLOAT_S8_UINT, {four, one}},
         true},
        {"RenderPassSrgb", {VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_D32_SFLOAT, {one, one}}, true},
        {"FourSamples", {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {four, four}}, false},
        {"ResolvedD32S8", {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT_S8_UINT, {four, one}}, false},
        {"RGBA32FD24", {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_X8_D24_UNORM_PACK32, {one, one}}, false},
        {"InPlaceD16", {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D16_UNORM, {one, one}}, false},
    };
}

std::vector<Box> boxesOnABed() {
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back({{-60, -2.5, -100}, {60, -2, 40}});
    boxes.push_back({{-4, -2, -1}, {2, -1, 2}});
    return boxes;
}

Camera camera() {
    Camera c;
    c.eye = {-1, 2.5, 7};
    c.target = {-0.5, 0, 0};
    c.width = 200;
    c.height = 112;
    return c;
}

class Drawn : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        reflection_.technique = ReflectionTechnique::planar;
        desc_.reflection = &reflection_;
        desc_.refraction = &refraction_;
        desc_.bed = &bed_;
    }

    void use(const DrawnDesc& drawn) { reflection_.drawn = bed_.drawn = drawn; }

    bool canUse(const DrawnDesc& drawn) {
        use(drawn);
        Estimate out;
        return estimate(context(), &desc_, {64, 64}, &out) == Status::ok;
    }

    /// What the host of those formats draws: the water, and the images that it drew into are spied on.
    WaterPicture pictureOf(const DrawnDesc& drawn, bool renderPass) {
        use(drawn);
        Body* const body = makeBody(desc_);
        BoxHost host(drawn, renderPass, boxesOnABed());
        const Camera from = camera();
        beforeReflection = [&](VkCommandBuffer commands) {
            const ViewDesc view = viewDesc(from);
            host.drawMain(commands, from);
            PlanarView wanted;
            ASSERT_EQ(planarView(body, &view, &wanted), Status::ok) << message();
            EXPECT_EQ(wanted.colorFormat, drawn.colorFormat);
            EXPECT_EQ(wanted.depthFormat, drawn.depthFormat);
            EXPECT_EQ(wanted.samples.depth, drawn.samples.depth);
            EXPECT_EQ(wanted.samples.color, drawn.samples.color);
            host.drawAgain(context(), commands, wanted);
            ASSERT_EQ(bedView(body, &view, &wanted), Status::ok) << message();
            EXPECT_EQ(wanted.samples.color, drawn.samples.color);
            host.drawAgain(context(), commands, wanted);
        };
        // Nothing of the scene's own picture shows: its bed and its mirror image are drawn.
        const WaterPicture first = picture({body}, from, 0, SurfaceOutput::shaded, nothingBehind(from));
        host.finished();
        const WaterPicture second = picture({body}, from, 0, SurfaceOutput::shaded, nothingBehind(from));
        EXPECT_EQ(first.color, second.color);
        beforeReflection = nullptr;
        return second;
    }

    ReflectionDesc reflection_;
    const RefractionDesc refraction_ = {{0.1f, 0.1f, 0.1f}, {0, 0, 0}};
    BedDesc bed_;
    BodyDesc desc_;
};

class DrawnIn : public Drawn, public testing::WithParamInterface<Case> {};

TEST_P(DrawnIn, GivesTheUsualPicture) {
    const auto& [name, drawn, renderPass] = GetParam();
    if (!canUse(drawn)) GTEST_SKIP() << message();
    const WaterPicture usual = pictureOf({}, false), got = pictureOf(drawn, renderPass);
    const bool many = drawn.samples.depth != one;
    const bool exactDepth = seaglass::depthStep(drawn.depthFormat, true) == 0;
    const float tolerance = (many ? 0.03f : 0.01f) + colorError(drawn.colorFormat);
    size_t covered = 0, apart = 0;
    double sum = 0, usualSum = 0;
    for (size_t i = 0; i < size_t{got.width} * got.height; ++i) {
        ASSERT_EQ(got.covered(i), usual.covered(i));
        if (!got.covered(i)) continue;
        ++covered;
        float most = 0;
        for (size_t c = 0; c < 3; ++c) {
            const float x = got.color[i * 4 + c], y = usual.color[i * 4 + c];
            ASSERT_TRUE(std::isfinite(x));
            most = std::max(most, std::abs(x - y));
            sum += double{x};
            usualSum += double{y};
        }
        apart += most > tolerance;
    }
    std::printf("%-36s %zu of %zu pixels apart, mean %.4f of %.4f\n", name, apart, covered, sum, usualSum);
    EXPECT_GT(covered, size_t{got.width} * got.height / 4);
    // Samples lie elsewhere, and edges are as soft as many make them.
    EXPECT_LE(apart, many ? covered / 14 : exactDepth ? 0 : covered / 200);
    EXPECT_NEAR(sum, usualSum, 0.005 * usualSum);
}

INSTANTIATE_TEST_SUITE_P(, DrawnIn, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(DrawnIn, CostsWhatTheEstimateSays) {
    const auto& [name, drawn, renderPass] = GetParam();
    if (!canUse(drawn)) GTEST_SKIP() << message();
    for (const float temporal : {0.0f, 0.9f}) {
        reflection_.temporal = temporal;
        Body* const body = makeBody(desc_);
        BoxHost host(drawn, renderPass, boxesOnABed());
        const Camera from = camera();
        const ViewDesc view = viewDesc(from);
        Estimate estimated;
        ASSERT_EQ(estimate(context(), &desc_, {from.width, from.height}, &estimated), Status::ok)
            << message();
        Estimate surface; // whose images are made by shade()
        const BodyDesc plain;
        ASSERT_EQ(estimate(context(), &plain, {from.width, from.height}, &surface), Status::ok);
        PlanarView mirrored, below;
        spiedCalls().clear();
        ASSERT_EQ(planarView(body, &view, &mirrored), Status::ok) << message();
        ASSERT_EQ(bedView(body, &view, &below), Status::ok) << message();
        EXPECT_EQ(bytesSpied(), estimated.bytesPerView - surface.bytesPerView);
        frame([&](VkCommandBuffer commands) {
            host.drawAgain(context(), commands, mirrored);
            host.drawAgain(context(), commands, below);
            spiedCalls().clear();
            EXPECT_EQ(reflect(commands, &body, 1, &view), Status::ok) << message();
        });
        EXPECT_EQ(countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect"), estimated.dispatchesPerView);
        EXPECT_EQ(countSpied("CreateImage"), 0u);
    }
}

// Where many samples cover an edge the sky shows through the rest of the pixel, as bright as around it.
TEST_F(Drawn, EdgesAreCoveredByShares) {
    const DrawnDesc formats[] = {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {four, four}},
                                 {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {four, one}}};
    std::vector<float> pictures[2];
    for (size_t i = 0; i < 2; ++i) {
        if (!canUse(formats[i])) GTEST_SKIP() << message();
        ReflectorDesc desc;
        desc.reflection = reflection_;
        desc.reflection.blurLevels = 0;
        Reflector* reflector = nullptr;
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        const ViewDesc view = viewDesc(camera());
        BoxHost host(formats[i], i == 0, boxesOnABed());
        frame([&](VkCommandBuffer commands) {
            PlanarView mirrored;
            ASSERT_EQ(planarView(reflector, &view, &mirrored), Status::ok) << message();
            host.drawAgain(context(), commands, mirrored);
            ASSERT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector, 0);
        const std::vector<float>& color = pictures[i] =
            download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent);
        size_t partly = 0, wrong = 0;
        for (size_t p = 0; p < color.size(); p += 4) {
            const float share = color[p + 3];
            partly += share > 0.1f && share < 0.9f;
            EXPECT_EQ(share * 4, std::round(share * 4));
            // What is drawn is between 0.2 and 0.8, but for what lies beyond a triangle's edge in its pixel.
            for (size_t c = 0; c < 3; ++c)
                wrong += color[p + c] < 0.15f * share || color[p + c] > 0.85f * share;
        }
        EXPECT_GT(partly, 100u);
        EXPECT_EQ(wrong, 0u);
        destroyReflector(reflector);
    }
    for (size_t p = 0; p < pictures[0].size(); ++p) ASSERT_NEAR(pictures[0][p], pictures[1][p], 2e-3f) << p;
}

TEST_F(Drawn, FormatsThatCannotBeReadAreNamed) {
    struct Bad {
        DrawnDesc drawn;
        const char* field;
    };
    const Bad all[] = {
        {{VK_FORMAT_R32_UINT, VK_FORMAT_D32_SFLOAT, {}}, "colorFormat"},
        {{VK_FORMAT_UNDEFINED, VK_FORMAT_D32_SFLOAT, {}}, "colorFormat"},
        {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32_SFLOAT, {}}, "depthFormat"},
        {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_S8_UINT, {}}, "depthFormat"},
        {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {VkSampleCountFlagBits(3), one}},
         "samples.depth"},
        {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {VK_SAMPLE_COUNT_32_BIT, one}},
         "samples.depth"},
        {{VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {one, four}}, "samples.color"},
    };
    for (const auto& [drawn, field] : all)
        for (const bool ofBed : {false, true}) {
            use({});
            (ofBed ? bed_.drawn : reflection_.drawn) = drawn;
            const std::string name = std::string(ofBed ? "BedDesc.drawn." : "ReflectionDesc.drawn.") + field;
            Estimate out;
            EXPECT_EQ(estimate(context(), &desc_, {64, 64}, &out), Status::invalidArgument) << name;
            EXPECT_EQ(message().find(name), 0u) << message();
            Body* body = nullptr;
            EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument) << name;
            EXPECT_EQ(message().find(name), 0u) << message();
            EXPECT_EQ(body, nullptr);
        }
}

TEST_F(Drawn, WhatTheDeviceHasNotIsUnsupported) {
    const VkPhysicalDeviceLimits& limits = device().properties().limits;
    const VkSampleCountFlags both = limits.framebufferColorSampleCounts &
                                    limits.framebufferDepthSampleCounts &
                                    limits.sampledImageDepthSampleCounts;
    if (both & VK_SAMPLE_COUNT_16_BIT) GTEST_SKIP() << "the device has 16 samples";
    reflection_.drawn = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT, {VK_SAMPLE_COUNT_16_BIT, one}};
    desc_.bed = nullptr;
    Body* body = nullptr;
    EXPECT_EQ(createBody(context(), &desc_, &body), Status::unsupported);
    EXPECT_EQ(message(), "ReflectionDesc.drawn.samples is more than this device draws into and samples");
}

} // namespace
