// Bad input is refused by the name of its field before anything is recorded or made; odd input that means
// something is taken for what it means.
#include <algorithm>
#include <cmath>

#include "seaglass/reflection.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class BadInput : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    ReflectorDesc desc() const {
        ReflectorDesc reflector;
        reflector.reflection.technique = GetParam();
        return reflector;
    }
};

/// What no technique takes: `refused` is called with a field's name and what spoils a view there.
template<typename Refused>
void forEachBadCamera(const Refused& refused) {
    const auto zero = [](double(&matrix)[16]) { std::fill(std::begin(matrix), std::end(matrix), 0.0); };
    refused("ViewDesc.view is singular", [&](ViewDesc& v) { zero(v.view); });
    refused("ViewDesc.view is not finite", [](ViewDesc& v) { v.view[12] = NAN; });
    refused("ViewDesc.view has a last row", [](ViewDesc& v) {
        for (int row = 0; row < 3; ++row) std::swap(v.view[12 + row], v.view[4 * row + 3]);
    });
    refused("ViewDesc.projection is singular", [&](ViewDesc& v) { zero(v.projection); });
    refused("ViewDesc.projection is singular", [](ViewDesc& v) { v.projection[5] = 0; });
    refused("ViewDesc.projection is not finite", [](ViewDesc& v) { v.projection[10] = INFINITY; });
    refused("ViewDesc.viewport", [](ViewDesc& v) { v.viewport.width = 0; });
    refused("ViewDesc.viewport", [](ViewDesc& v) { v.viewport.height = NAN; });
    refused("ViewDesc.viewport", [](ViewDesc& v) { v.viewport.x = -1; });
    refused("ViewDesc.viewport", [](ViewDesc& v) { v.viewport.minDepth = 0.1f; });
    refused("ViewDesc.viewIndex", [](ViewDesc& v) { v.viewIndex = 8; });
}

TEST_P(BadInput, InAViewIsRefusedBeforeAnythingIsRecorded) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const demos::Image depth = uploadFloats(traced.width, traced.height, 1, traced.depth);
    const demos::Image color = uploadFloats(traced.width, traced.height, 4, traced.color);
    Reflector* reflector = nullptr;
    const ReflectorDesc reflectorDesc = desc();
    ASSERT_EQ(createReflector(context(), &reflectorDesc, &reflector), Status::ok) << message();
    const auto expectRefused = [&](const char* field, auto&& spoil) {
        ViewDesc view = viewDesc(camera);
        view.sceneDepth = asSeaglass(depth);
        view.sceneColor = asSeaglass(color);
        spoil(view);
        frame([&](VkCommandBuffer commands) {
            spiedCalls().clear();
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::invalidArgument) << field;
            EXPECT_EQ(spiedCalls().size(), 0u) << field << ": " << spiedCalls().front().name;
        });
        EXPECT_NE(message().find(field), std::string::npos) << message();
        EXPECT_EQ(reflectionImages(reflector, 0).color, VkImageView(VK_NULL_HANDLE)) << field;
    };
    forEachBadCamera(expectRefused);
    expectRefused("ViewDesc.sceneDepth is smaller", [](ViewDesc& v) { v.viewport.y = 1; });
    expectRefused("ViewDesc.sceneDepth is smaller", [](ViewDesc& v) { v.sceneDepth.extent = {0, 0}; });
    expectRefused("ViewDesc.sceneColor is smaller", [](ViewDesc& v) { v.sceneColor.extent.width = 0; });
    expectRefused("ViewDesc.sceneDepth.view", [](ViewDesc& v) { v.sceneDepth.view = VK_NULL_HANDLE; });
    expectRefused("ViewDesc.sceneDepth.format",
                  [](ViewDesc& v) { v.sceneDepth.format = VK_FORMAT_R32_UINT; });
    expectRefused("ViewDesc.sceneColor.format",
                  [](ViewDesc& v) { v.sceneColor.format = VK_FORMAT_R8_UNORM; });
    expectRefused("ViewDesc.sceneColor.encoding is srgb, which", [](ViewDesc& v) {
        v.sceneColor.format = VK_FORMAT_B8G8R8A8_SRGB;
        v.sceneColor.encoding = Encoding::srgb;
    });
    expectRefused("ViewDesc.sceneColor.encoding is out of range",
                  [](ViewDesc& v) { v.sceneColor.encoding = static_cast<Encoding>(3); });
    expectRefused("ViewDesc.sceneColor.layout",
                  [](ViewDesc& v) { v.sceneColor.layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL; });
    expectRefused("ViewDesc.sceneColor.samples",
                  [](ViewDesc& v) { v.sceneColor.samples = VK_SAMPLE_COUNT_4_BIT; });
    destroyReflector(reflector);
}

class BadPlane : public BadInput {};

TEST_P(BadPlane, IsRefusedAndLeavesNothing) {
    for (const auto& [index, value] : std::vector<std::pair<int, double>>{
             {1, 0.0}, {1, 1e-13}, {0, NAN}, {1, NAN}, {2, -INFINITY}, {3, NAN}, {3, INFINITY}}) {
        ReflectorDesc bad = desc();
        bad.plane[index] = value;
        Reflector* reflector = nullptr;
        spiedCalls().clear();
        EXPECT_EQ(createReflector(context(), &bad, &reflector), Status::invalidArgument);
        EXPECT_EQ(reflector, nullptr);
        EXPECT_TRUE(spiedCalls().empty());
        EXPECT_NE(message().find("ReflectorDesc: plane"), std::string::npos) << message();
    }
}

TEST_P(BadInput, ButAPlaneOfAnyScaleIsThePlane) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    ReflectorDesc wanted = desc();
    const Reflected unit = reflectScene(testCamera(), traced, wanted);
    for (const double scale : {7.0, -7.0, 1e-6}) {
        for (int i = 0; i < 4; ++i) wanted.plane[i] = desc().plane[i] * scale;
        const Reflected scaled = reflectScene(testCamera(), traced, wanted);
        EXPECT_EQ(scaled.info, unit.info) << scale;
        EXPECT_EQ(scaled.color, unit.color) << scale;
    }
}

class BadPlanarInput : public ReflectionTest {
  protected:
    void SetUp() override {
        ReflectionTest::SetUp();
        const ReflectorDesc desc = with(ReflectionTechnique::planar);
        ASSERT_EQ(createReflector(context(), &desc, &reflector_), Status::ok) << message();
    }
    void TearDown() override {
        destroyReflector(reflector_);
        ReflectionTest::TearDown();
    }

    Reflector* reflector_ = nullptr;
};

TEST_F(BadPlanarInput, InAViewIsRefusedBeforeAnythingIsMade) {
    forEachBadCamera([&](const char* field, auto&& spoil) {
        ViewDesc view = viewDesc(testCamera());
        spoil(view);
        PlanarView out;
        out.clearDepth = 7;
        spiedCalls().clear();
        EXPECT_EQ(planarView(reflector_, &view, &out), Status::invalidArgument) << field;
        EXPECT_NE(message().find(std::string("planarView: ") + field), std::string::npos) << message();
        EXPECT_EQ(spiedCalls().size(), 0u) << field << ": " << spiedCalls().front().name;
        EXPECT_EQ(out.clearDepth, 7) << field;
        EXPECT_EQ(reflectionImages(reflector_, 0).color, VkImageView(VK_NULL_HANDLE)) << field;
    });
}

TEST_F(BadPlanarInput, InAViewIsRefusedBeforeAnythingIsRecorded) {
    const ViewDesc good = viewDesc(testCamera());
    PlanarView out;
    ASSERT_EQ(planarView(reflector_, &good, &out), Status::ok) << message();
    forEachBadCamera([&](const char* field, auto&& spoil) {
        ViewDesc view = good;
        spoil(view);
        frame([&](VkCommandBuffer commands) {
            spiedCalls().clear();
            EXPECT_EQ(reflect(commands, &reflector_, 1, &view), Status::invalidArgument) << field;
            EXPECT_EQ(spiedCalls().size(), 0u) << field << ": " << spiedCalls().front().name;
        });
        EXPECT_NE(message().find(std::string("reflect: ") + field), std::string::npos) << message();
    });
}

TEST_F(BadPlanarInput, InTheScenesImagesIsNotLookedAt) {
    const auto reflected = [&](auto&& spoil) {
        ViewDesc view = viewDesc(testCamera());
        spoil(view);
        PlanarView out;
        EXPECT_EQ(planarView(reflector_, &view, &out), Status::ok) << message();
        const size_t count = size_t{out.extent.width} * out.extent.height;
        const DrawnBuffers drawn({std::vector<float>(count, 0.01f), std::vector<uint64_t>(count, 0x3c00)});
        frame([&](VkCommandBuffer commands) {
            recordDrawing(commands, out, drawn);
            EXPECT_EQ(reflect(commands, &reflector_, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector_, 0);
        return download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent);
    };
    const std::vector<float> named = reflected([](ViewDesc&) {}); // no images at all
    EXPECT_GT(std::ranges::count_if(named, [](float info) { return info > 0; }), 500);
    EXPECT_EQ(named, reflected([](ViewDesc& v) {
                  for (Image* const image : {&v.sceneDepth, &v.sceneColor}) {
                      image->format = VK_FORMAT_R32_UINT;
                      image->layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
                      image->extent = {1, 1};
                      image->samples = VK_SAMPLE_COUNT_4_BIT;
                  }
              }));
}

INSTANTIATE_TEST_SUITE_P(, BadInput,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

INSTANTIATE_TEST_SUITE_P(, BadPlane,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid, ReflectionTechnique::planar),
                         nameOf);

} // namespace
