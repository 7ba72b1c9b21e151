// Whatever shape the host has, it gets the same water, and the validation layers hear nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "tests/gpu/host/host_shape.h"
#include "tests/gpu/rig/rig.h"
#include "tests/gpu/rig/scene_images.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Fails on any validation message.
class HostShapes : public testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().validationMessages(); }
    void TearDown() override { EXPECT_EQ(device().validationMessages(), messagesBefore_); }

  private:
    uint32_t messagesBefore_ = 0;
};

/// What the plain host draws, at 5 s.
const Picture& plainPicture() {
    static const Picture picture = ShapedHost(device()).picture(shoreCamera());
    return picture;
}

float apartAt(const Picture& a, const Picture& b, size_t pixel) {
    float most = 0;
    for (size_t c = 0; c < 3; ++c) {
        const float x = a[pixel * 4 + c], y = b[pixel * 4 + c];
        const float apart = std::abs(x - y) / std::max(1.0f, std::abs(x));
        most = apart <= most ? most : apart; // not a number wins
    }
    return most;
}

/// Share of the pixels that differ by more than `tolerance`, of 1 or of what is greater.
double apart(const Picture& a, const Picture& b, float tolerance) {
    EXPECT_EQ(a.size(), b.size());
    size_t count = 0;
    for (size_t i = 0; i < a.size() / 4; ++i) count += !(apartAt(a, b, i) <= tolerance);
    return static_cast<double>(count) / static_cast<double>(a.size() / 4);
}

/// Of the pixels that are water, those near and those that something hides.
void expectAPicture(const Picture& picture) {
    size_t background = 0;
    for (size_t i = 0; i < picture.size() / 4; ++i)
        background += picture[i * 4] == 0.25f && picture[i * 4 + 1] == 0.5f && picture[i * 4 + 2] == 1;
    const double share = static_cast<double>(background) / static_cast<double>(picture.size() / 4);
    EXPECT_GT(share, 0.2);
    EXPECT_LT(share, 0.7);
}

struct Case {
    HostShape shape;
    double share = 0;    ///< of pixels that may differ
    float tolerance = 0; ///< by more than this
    bool reversed = true;
    double far = 0;
};

class HostsOfShape : public HostShapes, public testing::WithParamInterface<Case> {};

void expectPlainPicture(const Case& test) {
    Picture expected = plainPicture();
    Camera camera = shoreCamera();
    camera.reversed = test.reversed;
    camera.far = test.far;
    expectAPicture(expected);
    if (test.shape.encoding == Encoding::srgb)
        expected = displayed(expected);
    else if (test.shape.color == VK_FORMAT_R8G8B8A8_UNORM)
        for (float& value : expected) value = std::clamp(value, 0.0f, 1.0f);
    Picture drawn = ShapedHost(device(), test.shape, test.reversed).picture(camera);
    if (test.shape.encoding == Encoding::srgb)
        for (float& value : drawn) value = std::min(value, 1.0f); // where a display ends
    // A value may lie in the middle between two that the format holds.
    const float tolerance = test.tolerance + 1.001f * colorError(test.shape.color);
    const double share = apart(expected, drawn, tolerance);
    std::printf("%-28s %.4f of the pixels by more than %g\n", test.shape.name, share, double{tolerance});
    if (test.share == 0 && tolerance == 0) {
        EXPECT_EQ(expected, drawn);
    } else {
        EXPECT_LE(share, test.share);
    }
}

TEST_P(HostsOfShape, DrawThePlainPicture) {
    if (!canDraw(GetParam().shape)) GTEST_SKIP() << "the device does not draw into " << GetParam().shape.name;
    expectPlainPicture(GetParam());
}

/// A shape, plain or another, with a field of its own.
template<typename Value>
auto with(Value HostShape::*field, std::type_identity_t<Value> value) {
    return [=](HostShape shape = {}) {
        shape.*field = value;
        return shape;
    };
}

const auto inPass = with(&HostShape::renderPass, true);
const auto inSecondaries = with(&HostShape::secondary, true);
const auto copyingDepth = with(&HostShape::copiesDepth, true);
const auto resolvingScene = with(&HostShape::resolvesScene, true);
const auto flipped = with(&HostShape::flipped, true);
const auto withSunShadow = with(&HostShape::sunShadow, true);
const auto withSkyColors = with(&HostShape::skyCube, false);
const auto withFourSamples = with(&HostShape::samples, VK_SAMPLE_COUNT_4_BIT);

HostShape drawnInto(VkFormat color) {
    return with(&HostShape::color, color)();
}

HostShape displaying(VkFormat color) {
    return with(&HostShape::encoding, Encoding::srgb)(drawnInto(color));
}

HostShape withDepth(VkFormat depth, bool stencil) {
    return with(&HostShape::stencilAttached, stencil)(with(&HostShape::depth, depth)());
}

HostShape inWorld(size_t index) {
    return with(&HostShape::world, everyWorld()[index])();
}

HostShape named(const char* name, const HostShape& shape = {}) {
    return with(&HostShape::name, name)(shape);
}

std::vector<Case> cases() {
    const HostShape depthAndStencil = withDepth(VK_FORMAT_D32_SFLOAT_S8_UINT, true);
    // Sampled at other places; means along edges.
    constexpr double edges = 0.12;
    // Where the bits of a matrix differ: glints, and pixels along edges.
    constexpr double rounding = 0.01;
    // Along the line where depth hides the water.
    constexpr double line = 0.005;
    return {
        {named("Plain")},
        {named("SunShadow", withSunShadow())},
        {named("RenderPass", inPass())},
        {named("Secondaries", inSecondaries())},
        {named("RenderPassSecondaries", inSecondaries(inPass()))},
        {named("D32AndStencil", depthAndStencil)},
        {named("RenderPassD32AndStencil", inPass(depthAndStencil))},
        {named("SecondariesD32AndStencil", inSecondaries(depthAndStencil))},
        {named("D32BesideStencil", withDepth(VK_FORMAT_D32_SFLOAT_S8_UINT, false))},
        {named("D24AndStencil", withDepth(VK_FORMAT_D24_UNORM_S8_UINT, true)), line},
        {named("D24", withDepth(VK_FORMAT_X8_D24_UNORM_PACK32, false)), line},
        {named("D16", withDepth(VK_FORMAT_D16_UNORM, false)), line},
        {named("RenderPassD16", inPass(withDepth(VK_FORMAT_D16_UNORM, false))), line},
        // Drivers may cut what lies between two halves off, where others round it.
        {named("RGBA16F", drawnInto(VK_FORMAT_R16G16B16A16_SFLOAT)), 0, 0x1p-11f},
        {named("B10G11R11", drawnInto(VK_FORMAT_B10G11R11_UFLOAT_PACK32))},
        {named("RGBA8", drawnInto(VK_FORMAT_R8G8B8A8_UNORM))},
        // The scene comes as bytes, too: where its steps are coarse water darkens them to what is finer.
        {named("EncodedRGBA8", displaying(VK_FORMAT_R8G8B8A8_UNORM)), 0, 0.004f},
        {named("RenderPassEncodedRGBA8", inPass(displaying(VK_FORMAT_R8G8B8A8_UNORM))), 0, 0.004f},
        {named("EncodedRGBA16F", displaying(VK_FORMAT_R16G16B16A16_SFLOAT)), 0, 0.001f},
        {named("CopiedD32AndStencil", copyingDepth(depthAndStencil))},
        {named("CopiedD32", copyingDepth(withDepth(VK_FORMAT_D32_SFLOAT, false)))},
        {named("RenderPassB10G11R11", inPass(drawnInto(VK_FORMAT_B10G11R11_UFLOAT_PACK32)))},
        {named("FourSamples", withFourSamples()), edges, 0.02f},
        {named("RenderPassFourSamples", inPass(withFourSamples())), edges, 0.02f},
        {named("SecondariesFourSamples", inSecondaries(withFourSamples())), edges, 0.02f},
        {named("FourSamplesOfAResolvedScene", resolvingScene(withFourSamples())), edges, 0.02f},
        {named("RenderPassFourSamplesOfAResolvedScene", inPass(resolvingScene(withFourSamples()))), edges,
         0.02f},
        {named("Flipped", flipped()), rounding, 0.004f},
        {named("RenderPassFlipped", inPass(flipped())), rounding, 0.004f},
        {named("ForwardDepth"), rounding, 0.004f, false, 0},
        {named("ForwardDepthFiniteFar"), rounding, 0.004f, false, 500},
        {named("ReversedDepthFiniteFar"), rounding, 0.004f, true, 500},
        {named("SkyOfColors", withSkyColors()), rounding, 0.004f},
        {named("RenderPassSkyOfColors", inPass(withSkyColors())), rounding, 0.004f},
        {named("LeftHanded", inWorld(1)), rounding, 0.004f},
        {named("YDown", inWorld(2)), rounding, 0.004f},
        {named("RenderPassYDown", inPass(inWorld(2))), rounding, 0.004f},
        {named("YDownLeftHanded", inWorld(3)), rounding, 0.004f, false, 500},
        {named("ZUp", inWorld(4)), rounding, 0.004f},
        {named("ZUpLeftHanded", inWorld(5)), rounding, 0.004f},
        {named("ZUpLeftHandedCentimetres", inWorld(6)), rounding, 0.004f},
    };
}

INSTANTIATE_TEST_SUITE_P(, HostsOfShape, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.shape.name); });

// Endlessly deep water, as over a scene that is nowhere nearer than the far plane.
TEST_F(HostShapes, HandOverNoSceneImages) {
    const auto mirrorsTheSky = [](BodyDesc& desc) { desc.reflection = nullptr; };
    const auto picture = [&](SceneGiven scene, bool renderPass) {
        HostShape shape;
        shape.scene = scene;
        shape.renderPass = renderPass;
        return ShapedHost(device(), shape, true, {}, mirrorsTheSky).picture(shoreCamera());
    };
    const Picture far = picture(SceneGiven::nothing, false);
    expectAPicture(far);
    for (const bool renderPass : {false, true})
        EXPECT_LT(apart(far, picture(SceneGiven::noImages, renderPass), 0.002f), 0.001);
}

/// What a gale makes of the water.
struct Gale {
    Gale() {
        sea.windSpeed = 26;
        sea.fetch = 30e3f;
        sea.samples = 64;
        sea.seed = 3;
    }
    std::function<void(BodyDesc&)> blowing(bool sprays) const {
        return [this, sprays](BodyDesc& desc) {
            desc.waves = &sea;
            desc.spray = sprays ? &spray : nullptr;
            desc.shading.sprayParticles = 32768;
        };
    }
    static Camera camera(bool reversed = true) {
        Camera camera = shoreCamera();
        camera.eye.y = 14;
        camera.reversed = reversed;
        return camera;
    }
    SeaDesc sea;
    SprayDesc spray{4, 1.0f / 48};
};

TEST_F(HostShapes, HaveTheSameSpray) {
    const Gale gale;
    const auto drawn = [&](const HostShape& shape, bool sprays, bool reversed = true) {
        return ShapedHost(device(), shape, reversed, {}, gale.blowing(sprays))
            .picture(Gale::camera(reversed));
    };
    const Picture plain = drawn({}, true);
    EXPECT_GT(apart(plain, drawn({}, false), 0.02f), 0.1);
    EXPECT_EQ(drawn(inPass(), true), plain);
    EXPECT_LE(apart(plain, drawn(flipped(), true), 0.004f), 0.02);
    EXPECT_LE(apart(plain, drawn(inWorld(3), true, false), 0.004f), 0.02);
    EXPECT_LE(apart(plain, drawn(inWorld(5), true), 0.004f), 0.02);
    if (canDraw(withFourSamples())) {
        EXPECT_LE(apart(plain, drawn(withFourSamples(), true), 0.02f), 0.3);
    }
    Picture shown = drawn(displaying(VK_FORMAT_R16G16B16A16_SFLOAT), true);
    // Blended as it is held: docs/contract.md.
    EXPECT_LE(apart(displayed(plain), shown, 0.06f), 0.02);
}

TEST_F(HostShapes, HaveOneToFourFramesInFlight) {
    const Camera camera = shoreCamera();
    std::vector<Picture> alone;
    {
        ShapedHost host(device());
        for (int i = 0; i < 6; ++i) alone.push_back(host.picture(camera, 2 + i));
    }
    EXPECT_NE(alone[0], alone[1]);
    for (const uint32_t inFlight : {1u, 2u, 3u, 4u}) {
        ShapedHost host(device(), {}, true, [&](DeviceDesc& desc) { desc.framesInFlight = inFlight; });
        EXPECT_MISUSE(beginFrame(host.context(), inFlight), "beginFrame: slot is", host.message());
        for (uint32_t i = 0; i < alone.size() + inFlight; ++i) {
            const uint32_t slot = i % inFlight;
            if (i >= inFlight) {
                EXPECT_EQ(host.fetch(slot).front(), alone[i - inFlight]) << inFlight;
            }
            if (i < alone.size()) host.submit(slot, {&camera, 1}, 2 + i);
        }
    }
}

/// Two eyes.
std::vector<Camera> eyes() {
    std::vector<Camera> cameras = {shoreCamera(), shoreCamera()};
    cameras[1].eye.x += 0.4;
    cameras[1].target.x += 0.4;
    return cameras;
}

TEST_F(HostShapes, HaveTwoViewsInAFrame) {
    const std::vector<Camera> cameras = eyes();
    const std::vector<Picture> alone = {ShapedHost(device()).picture(cameras[0]),
                                        ShapedHost(device()).picture(cameras[1])};
    EXPECT_GT(apart(alone[0], alone[1], 0.01f), 0.1);
    ShapedHost host(device());
    host.submit(0, cameras, 5);
    EXPECT_EQ(host.fetch(0), alone);
}

TEST_F(HostShapes, ChangeTheirSizeEveryFrame) {
    ShapedHost host(device());
    Camera camera = shoreCamera();
    uint32_t slot = 0;
    for (const auto& [width, height] :
         {std::pair{200u, 112u}, {121u, 67u}, {1u, 1u}, {64u, 240u}, {64u, 90u}, {200u, 90u}, {200u, 112u}}) {
        camera.width = width;
        camera.height = height;
        EXPECT_EQ(host.picture(camera, 5, slot), ShapedHost(device()).picture(camera))
            << width << " x " << height;
        slot = (slot + 1) % 4;
    }
}

/// A device of its own, whose messages count too.
class OwnDevices : public HostShapes {
  protected:
    demos::Device* make(const demos::DeviceShape& shape) {
        demos::HostDesc desc;
        desc.validation = true;
        demos::Error error;
        std::unique_ptr<demos::Device> made = demos::Device::create(desc, error, shape);
        if (!made) {
            why_ = error.text;
            return nullptr;
        }
        made_.push_back(std::move(made));
        return made_.back().get();
    }
    void TearDown() override {
        for (const auto& made : made_) EXPECT_EQ(made->validationMessages(), 0u);
        made_.clear();
        HostShapes::TearDown();
    }
    const std::string& why() const { return why_; }

  private:
    std::vector<std::unique_ptr<demos::Device>> made_;
    std::string why_;
};

TEST_F(OwnDevices, NeedNoFeatureBeyondRequirements) {
    demos::DeviceShape shape;
    shape.onlyRequired = true;
    demos::Device* least = make(shape);
    ASSERT_TRUE(least) << why();
    EXPECT_EQ(ShapedHost(*least, inPass()).picture(shoreCamera()), plainPicture());
}

TEST_F(OwnDevices, AreSeveralAtOnce) {
    demos::Device* second = make({});
    ASSERT_TRUE(second) << why();
    const Camera camera = shoreCamera();
    auto one = std::make_unique<ShapedHost>(device());
    ShapedHost two(*second);
    one->submit(0, {&camera, 1}, 5);
    two.submit(0, {&camera, 1}, 5);
    EXPECT_EQ(two.fetch(0).front(), plainPicture());
    EXPECT_EQ(one->fetch(0).front(), plainPicture());
    one.reset();
    EXPECT_EQ(two.picture(camera, 5, 1), plainPicture());
}

TEST_F(OwnDevices, HaveAQueueFamilyOtherThanTheFirst) {
    demos::DeviceShape shape;
    shape.familiesPassedOver = 1;
    demos::Device* other = make(shape);
    if (!other) GTEST_SKIP() << why();
    EXPECT_EQ(ShapedHost(*other).picture(shoreCamera()), plainPicture());
}

TEST_F(OwnDevices, DrawSeveralViewsInOnePass) {
    demos::DeviceShape deviceShape;
    deviceShape.multiview = true;
    demos::Device* device = make(deviceShape);
    ASSERT_TRUE(device) << why();
    const std::vector<Camera> cameras = eyes();
    std::vector<Picture> level;
    for (const bool tilted : {false, true}) {
        const auto tilt = [&](BodyDesc& desc) {
            if (tilted) std::ranges::copy(std::array{0.12, 0.992, 0.04, 0.0}, desc.plane);
        };
        const std::vector<Picture> alone = {ShapedHost(*device, {}, true, {}, tilt).picture(cameras[0]),
                                            ShapedHost(*device, {}, true, {}, tilt).picture(cameras[1])};
        HostShape shape;
        shape.multiview = true;
        for (const bool pass : {false, true})
            for (const bool secondary : {false, true}) {
                shape.renderPass = pass;
                shape.secondary = secondary;
                ShapedHost host(*device, shape, true, {}, tilt);
                host.submit(0, cameras, 5);
                EXPECT_EQ(host.fetch(0), alone) << tilted << pass << secondary;
            }
        if (!tilted) level = alone;
        if (tilted) {
            EXPECT_GT(apart(level[0], alone[0], 0.01f), 0.1);
        }
    }
    const Gale gale;
    const std::vector<Camera> above = {Gale::camera(), Gale::camera()};
    HostShape shape;
    const Picture alone = ShapedHost(*device, shape, true, {}, gale.blowing(true)).picture(above[0]);
    shape.multiview = true;
    ShapedHost host(*device, shape, true, {}, gale.blowing(true));
    host.submit(0, above, 5);
    EXPECT_EQ(host.fetch(0), std::vector<Picture>(2, alone)) << "spray";
}

} // namespace
