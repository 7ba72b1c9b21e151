// Bad input that the tests on GPUs do not give: refused by a line that names it, and nothing is kept.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/faults/failing_device.h"
#include "tests/unit/cameras.h"
#include "water/interface/waves_backend.h"

namespace {

using namespace seaglass;
using namespace ::tests;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

class Refused : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(createContext(&desc_, &context_), Status::ok) << message_; }
    void TearDown() override {
        destroyContext(context_);
        EXPECT_EQ(device_.held(), 0u);
    }
    void expectRefused(Status status, const char* line, Status by = Status::invalidArgument) {
        EXPECT_EQ(status, by) << line;
        EXPECT_NE(message_.find(line), std::string::npos) << "'" << message_ << "', expected " << line;
        message_.clear();
    }
    static DeviceDesc describe(FailingDevice& device, std::string& message) {
        DeviceDesc desc = device.desc();
        desc.message = {[](void* user, const char* text) { *static_cast<std::string*>(user) = text; },
                        &message};
        return desc;
    }

    FailingDevice device_;
    std::string message_;
    DeviceDesc desc_ = describe(device_, message_);
    Context* context_ = nullptr;
};

TEST_F(Refused, DevicesWithoutHandles) {
    Context* none = nullptr;
    DeviceDesc bad = desc_;
    bad.instance = nullptr;
    expectRefused(createContext(&bad, &none), "DeviceDesc.instance is null");
    bad = desc_;
    bad.device = nullptr;
    expectRefused(createContext(&bad, &none), "DeviceDesc.device is null");
    EXPECT_EQ(none, nullptr);
    EXPECT_EQ(createContext(nullptr, &none), Status::invalidArgument);
}

TEST_F(Refused, EstimatesOfNothing) {
    Estimate costs;
    SceneSamples seven;
    seven.depth = static_cast<VkSampleCountFlagBits>(7);
    const ReflectionDesc reflection;
    const BodyDesc body;
    expectRefused(estimate(context_, &reflection, {4, 0}, &costs), "estimate: the extent is empty");
    expectRefused(estimate(context_, &reflection, {4, 16385}, &costs), "estimate: the extent is 4 x 16385");
    expectRefused(estimate(context_, &body, {4, 0}, &costs), "estimate: the extent is empty");
    expectRefused(estimate(context_, &body, {~0u, 4}, &costs), "estimate: the extent is 4294967295 x 4");
    expectRefused(estimate(context_, &reflection, {4, 4}, &costs, seven), "estimate: SceneSamples.depth");
    expectRefused(estimate(context_, &body, {4, 4}, &costs, seven), "estimate: SceneSamples.depth");
}

TEST_F(Refused, PlanesAndBoundsThatAreNone) {
    Reflector* none = nullptr;
    ReflectorDesc bad;
    bad.plane[3] = notANumber;
    expectRefused(createReflector(context_, &bad, &none), "plane is not finite");
    bad = {};
    bad.plane[0] = bad.plane[1] = bad.plane[2] = 0;
    expectRefused(createReflector(context_, &bad, &none), "plane has no normal");
    for (const double low : {2.0, notANumber, -std::numeric_limits<double>::infinity()}) {
        bad = {};
        for (size_t axis = 0; axis < 3; ++axis) bad.boundsLow[axis] = 0, bad.boundsHigh[axis] = 1;
        bad.boundsLow[1] = low;
        expectRefused(createReflector(context_, &bad, &none), "boundsLow and boundsHigh are no box");
    }
    EXPECT_EQ(none, nullptr);
}

TEST_F(Refused, TimesThatAreNone) {
    Body* body = nullptr;
    const BodyDesc still;
    ASSERT_EQ(createBody(context_, &still, &body), Status::ok) << message_;
    ASSERT_EQ(beginFrame(context_, 0), Status::ok);
    for (const double time : {notANumber, std::numeric_limits<double>::infinity()})
        expectRefused(simulate(device_.commands(), &body, 1, time), "simulate: time is not finite");
    EXPECT_EQ(simulate(device_.commands(), &body, 1, -1e300), Status::ok) << message_;
    destroyBody(body);
}

TEST_F(Refused, BackendsWithoutMemory) {
    const SeaDesc sea;
    WavesBackend poor;
    poor.name = "poor";
    poor.create = [](const Sea&) -> void* { return nullptr; };
    poor.destroy = [](void*) {};
    poor.evaluate = [](void*, uint32_t, double, const CascadeMaps&) {};
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = &poor;
    desc.wavesOn = WavesOn::cpu;
    Body* none = nullptr;
    const size_t held = device_.heldButPipelines();
    expectRefused(createBody(context_, &desc, &none), "waves backend poor: out of memory",
                  Status::outOfHostMemory);
    EXPECT_EQ(none, nullptr);
    EXPECT_EQ(device_.heldButPipelines(), held);
}

class RefusedInAFrame : public Refused {
  protected:
    void SetUp() override {
        Refused::SetUp();
        ASSERT_EQ(beginFrame(context_, 0), Status::ok);
        Camera camera;
        camera.width = camera.height = 16;
        view_ = viewDesc(camera);
        view_.sceneColor = image(VK_FORMAT_R16G16B16A16_SFLOAT);
        view_.sceneDepth = image(VK_FORMAT_D32_SFLOAT);
    }
    Image image(VkFormat format) {
        Image made;
        made.view = device_.hosts<VkImageView>();
        made.format = format;
        made.extent = {16, 16};
        made.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        return made;
    }

    ViewDesc view_;
};

TEST_F(RefusedInAFrame, ShadowsThatNoMapHolds) {
    Body* body = nullptr;
    const BodyDesc still;
    ASSERT_EQ(createBody(context_, &still, &body), Status::ok) << message_;
    SunShadow right;
    right.map = image(VK_FORMAT_D32_SFLOAT);
    for (size_t i = 0; i < 4; ++i) right.textureFromWorld[0][5 * i] = 1;
    const auto expectNamed = [&](const SunShadow& shadow, const char* line) {
        LightingDesc lighting;
        lighting.shadow = &shadow;
        expectRefused(shade(device_.commands(), &body, 1, &view_, &lighting), line);
    };
    SunShadow bad = right;
    bad.map.view = VK_NULL_HANDLE;
    expectNamed(bad, "SunShadow.map.view is null");
    bad = right;
    bad.map.samples = VK_SAMPLE_COUNT_4_BIT;
    expectNamed(bad, "SunShadow.map.samples is not 1");
    bad = right;
    bad.bounds[0][2] = bad.bounds[0][0];
    expectNamed(bad, "SunShadow.bounds is no part of a texture");
    bad = right;
    bad.textureFromWorld[0][3] = notANumber;
    expectNamed(bad, "SunShadow.textureFromWorld is not finite");
    destroyBody(body);
}

TEST_F(RefusedInAFrame, ViewsWiderThanImagesOfTheDevice) {
    constexpr uint32_t most = 16384;
    Reflector* reflector = nullptr;
    const ReflectorDesc desc;
    ASSERT_EQ(createReflector(context_, &desc, &reflector), Status::ok) << message_;
    const auto reflected = [&](uint32_t width) {
        view_.viewport.width = static_cast<float>(width);
        view_.sceneColor.extent = view_.sceneDepth.extent = {width, 16};
        return reflect(device_.commands(), &reflector, 1, &view_);
    };
    EXPECT_EQ(reflected(most), Status::ok) << message_;
    expectRefused(reflected(most + 1), "16385 x 16 pixels, the device's images have up to 16384 each way",
                  Status::unsupported);
    destroyReflector(reflector);
}

TEST_F(RefusedInAFrame, ViewportsThatNoNumberOfPixelsReaches) {
    Reflector* reflector = nullptr;
    const ReflectorDesc desc;
    ASSERT_EQ(createReflector(context_, &desc, &reflector), Status::ok) << message_;
    const VkViewport right = view_.viewport;
    for (float VkViewport::*const field :
         {&VkViewport::x, &VkViewport::y, &VkViewport::width, &VkViewport::height})
        for (const float value : {1.7e7f, 3e9f, 1e30f, 3e38f}) {
            view_.viewport = right;
            view_.viewport.*field = value;
            expectRefused(reflect(device_.commands(), &reflector, 1, &view_),
                          "ViewDesc.viewport ends beyond 2^24 pixels");
        }
    destroyReflector(reflector);
}

TEST_F(RefusedInAFrame, OutputsThatThereAreNone) {
    Body* body = nullptr;
    Target* target = nullptr;
    const BodyDesc still;
    const LightingDesc lighting;
    TargetDesc desc;
    desc.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.depthFormat = VK_FORMAT_D32_SFLOAT;
    ASSERT_EQ(createBody(context_, &still, &body), Status::ok) << message_;
    ASSERT_EQ(createTarget(context_, &desc, &target), Status::ok) << message_;
    for (const uint32_t number : {9u, 100u, ~0u}) {
        const auto output = static_cast<SurfaceOutput>(number);
        expectRefused(shade(device_.commands(), &body, 1, &view_, &lighting, output), "shade: output is ");
        expectRefused(draw(device_.commands(), target, &body, 1, &view_, &lighting, output),
                      "draw: output is ");
        expectRefused(prepare(target, body, nullptr, nullptr, output), "prepare: output is ");
    }
    destroyTarget(target);
    destroyBody(body);
}

TEST_F(RefusedInAFrame, OverlaysOnNothing) {
    Reflector* reflector = nullptr;
    const ReflectorDesc desc;
    ASSERT_EQ(createReflector(context_, &desc, &reflector), Status::ok) << message_;
    const OverlayDesc overlay;
    expectRefused(recordOverlay(device_.commands(), reflector, &view_, &overlay),
                  "OverlayDesc.target.view is null");
    destroyReflector(reflector);
}

TEST(Statuses, HaveNames) {
    for (int i = 0; i < 7; ++i) {
        EXPECT_STRNE(toString(static_cast<Status>(i)), "");
        EXPECT_STRNE(toString(static_cast<Status>(i)), "unknown status");
    }
    EXPECT_STREQ(toString(static_cast<Status>(99)), "unknown status");
}

} // namespace
