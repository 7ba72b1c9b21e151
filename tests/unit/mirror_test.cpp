// The screen mirror: what it must be for any camera, any plane and any distance from the origin.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "gpu/view/plane.h"
#include "reflection/core/mirror.h"
#include "tests/unit/cameras.h"

namespace {

using namespace seaglass;
using tests::Camera;

VkImageView someHandle() {
    return reinterpret_cast<VkImageView>(uintptr_t{1});
}

ViewDesc describedView(const Camera& camera) {
    ViewDesc view = tests::viewDesc(camera);
    const VkExtent2D extent = {camera.width, camera.height};
    view.sceneColor = {someHandle(), VK_FORMAT_R16G16B16A16_SFLOAT, extent, VK_IMAGE_LAYOUT_GENERAL};
    view.sceneDepth = {someHandle(), VK_FORMAT_D32_SFLOAT, extent, VK_IMAGE_LAYOUT_GENERAL};
    return view;
}

ViewGeometry geometryOf(const Camera& camera) {
    ViewGeometry geometry;
    EXPECT_STREQ(readView(describedView(camera), geometry).text(), "");
    return geometry;
}

glm::dvec3 pixelOf(const ViewGeometry& view, const glm::dvec3& world) {
    const glm::dvec4 p = view.pixelFromRelative * glm::dvec4(world - view.eye, 1);
    return glm::dvec3(p) / p.w;
}

glm::dvec4 unitPlane(double x, double y, double z, double d) {
    glm::dvec4 plane;
    const double values[4] = {x, y, z, d};
    EXPECT_EQ(readPlane(values, plane), nullptr);
    return plane;
}

std::vector<Camera> everyKindOfCamera() {
    std::vector<Camera> cameras;
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 500.0})
            for (const double roll : {0.0, 35.0, 90.0}) {
                Camera camera;
                camera.reversed = reversed;
                camera.far = far;
                camera.rollDegrees = roll;
                cameras.push_back(camera);
            }
    Camera steep;
    steep.eye = {0, 20, 8};
    cameras.push_back(steep);
    Camera distant;
    distant.eye = {1e6, 3, -1e6};
    distant.target = {1e6 + 3, 2, -1e6 - 20};
    cameras.push_back(distant);
    return cameras;
}

TEST(Mirror, MapsAPointToWhereItsMirrorImageProjects) {
    const glm::dvec4 plane = unitPlane(0, 1, 0, -0.25);
    for (const Camera& camera : everyKindOfCamera()) {
        const ViewGeometry view = geometryOf(camera);
        const ScreenMirror mirror = screenMirror(view, planeFacingEye(plane, view.eye));
        const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
        for (const double distance : {3.0, 12.0, 60.0}) {
            const glm::dvec3 world = camera.eye + ahead * distance + glm::dvec3(0.3, 1.5, 0.2);
            const glm::dvec3 image = world - glm::dvec3(0, 2 * (world.y - 0.25), 0);
            const glm::dvec4 q = mirror.pixelFromPixel * glm::dvec4(pixelOf(view, world), 1);
            const glm::dvec3 expected = pixelOf(view, image);
            EXPECT_NEAR(q.x / q.w, expected.x, 1e-5);
            EXPECT_NEAR(q.y / q.w, expected.y, 1e-5);
            EXPECT_NEAR(q.z / q.w, expected.z, 1e-9);
        }
    }
}

TEST(Mirror, IsItsOwnInverseUpToScale) {
    for (const Camera& camera : everyKindOfCamera()) {
        const ViewGeometry view = geometryOf(camera);
        for (const glm::dvec4& plane : {unitPlane(0, 1, 0, 0), unitPlane(0.3, 2, -0.4, 1)}) {
            const glm::dmat4 h = screenMirror(view, planeFacingEye(plane, view.eye)).pixelFromPixel;
            const glm::dmat4 twice = h * h;
            const double scale = twice[0][0];
            for (int i = 0; i < 16; ++i) {
                // An entry's rounding grows with the entries it was summed from.
                double magnitude = 0;
                for (int k = 0; k < 4; ++k) magnitude += std::abs(h[k][i % 4] * h[i / 4][k]);
                EXPECT_NEAR(twice[i / 4][i % 4], i % 5 == 0 ? scale : 0.0, 1e-9 * (magnitude + 1));
            }
        }
    }
}

TEST(Mirror, HeightIsLinearInThePixel) {
    const glm::dvec4 plane = unitPlane(0, 1, 0, -1);
    for (const Camera& camera : everyKindOfCamera()) {
        const ViewGeometry view = geometryOf(camera);
        const ScreenMirror mirror = screenMirror(view, planeFacingEye(plane, view.eye));
        const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
        for (const double lift : {-0.5, 0.0, 4.0}) {
            const glm::dvec3 world = camera.eye + ahead * 15.0 + glm::dvec3(0, lift, 0);
            const glm::dvec4 p(pixelOf(view, world), 1);
            EXPECT_NEAR(glm::dot(mirror.heightRow, p) / glm::dot(mirror.weightRow, p), world.y - 1, 1e-6);
        }
    }
}

TEST(Mirror, FloatUniformsStayExactFarFromTheOrigin) {
    Camera camera;
    camera.eye = {1e5, 2, 1e5};
    camera.target = {1e5, 1, 1e5 - 10};
    camera.width = 1920;
    camera.height = 1080;
    const ViewGeometry view = geometryOf(camera);
    const MirrorBlock uniforms = mirrorBlock(view, unitPlane(0, 1, 0, 0), {}, {});
    const glm::dvec3 world = camera.eye + glm::dvec3(1.5, 1, -30);
    const glm::dvec3 image(world.x, -world.y, world.z);
    const glm::vec4 q = uniforms.screenMirror * glm::vec4(glm::vec3(pixelOf(view, world)), 1);
    const glm::dvec3 expected = pixelOf(view, image);
    EXPECT_NEAR(q.x / q.w, expected.x, 2e-3);
    EXPECT_NEAR(q.y / q.w, expected.y, 2e-3);
}

TEST(Mirror, AScaledPlaneIsTheSameMirror) {
    const ViewGeometry view = geometryOf(Camera{});
    const MirrorBlock a = mirrorBlock(view, unitPlane(0, 1, 0, -0.5), {}, {});
    const MirrorBlock b = mirrorBlock(view, unitPlane(0, 400, 0, -200), {}, {});
    EXPECT_EQ(a.screenMirror, b.screenMirror);
    EXPECT_EQ(a.plane, b.plane);
}

TEST(Mirror, FacesTheEyeFromEitherSide) {
    const glm::dvec4 plane = unitPlane(0, 1, 0, 0);
    EXPECT_GT(planeFacingEye(plane, {0, 3, 0}).w, 0);
    const glm::dvec4 below = planeFacingEye(plane, {0, -3, 0});
    EXPECT_GT(below.w, 0);
    EXPECT_LT(below.y, 0);
}

TEST(Mirror, RefusesPlanesWithoutANormal) {
    glm::dvec4 out;
    const double zero[4] = {0, 0, 0, 1};
    const double nan[4] = {0, NAN, 0, 1};
    EXPECT_NE(readPlane(zero, out), nullptr);
    EXPECT_NE(readPlane(nan, out), nullptr);
}

TEST(View, ReadsTheDepthDirectionFromTheProjection) {
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 100.0}) {
            Camera camera;
            camera.reversed = reversed;
            camera.far = far;
            EXPECT_EQ(geometryOf(camera).reversedDepth, reversed) << "far " << far;
        }
}

TEST(View, FindsTheEyeAndLooksForward) {
    Camera camera;
    camera.eye = {12, 3, -7};
    camera.target = {2, 3, -7};
    const ViewGeometry view = geometryOf(camera);
    EXPECT_NEAR(glm::length(view.eye - camera.eye), 0, 1e-12);
    EXPECT_NEAR(view.forward.x, -1, 1e-12);
}

TEST(View, PixelsCountFromTheViewportsCorner) {
    Camera camera;
    const glm::dvec3 world(0.5, 1.2, 0);
    const glm::dvec3 whole = pixelOf(geometryOf(camera), world);
    ViewDesc shifted = describedView(camera);
    shifted.viewport.x = 40;
    shifted.viewport.y = 24;
    shifted.sceneColor.extent = shifted.sceneDepth.extent = {400, 300};
    ViewGeometry geometry;
    ASSERT_STREQ(readView(shifted, geometry).text(), "");
    EXPECT_EQ(geometry.regionOrigin, glm::ivec2(40, 24));
    EXPECT_NEAR(glm::length(pixelOf(geometry, world) - whole), 0, 1e-9);
}

TEST(View, TheMiddleOfTheViewportIsStraightAhead) {
    const Camera camera;
    const glm::dvec3 ahead = pixelOf(geometryOf(camera), camera.target);
    EXPECT_NEAR(ahead.x, 0.5 * camera.width, 1e-9);
    EXPECT_NEAR(ahead.y, 0.5 * camera.height, 1e-9);
}

TEST(View, ANegativeHeightFlips) {
    Camera camera;
    ViewDesc flipped = describedView(camera);
    glm::dmat4 projection = tests::projectionMatrix(camera);
    projection[1][1] = -projection[1][1];
    tests::copyMatrix(projection, flipped.projection);
    flipped.viewport.y = static_cast<float>(camera.height);
    flipped.viewport.height = -flipped.viewport.height;
    ViewGeometry geometry;
    ASSERT_STREQ(readView(flipped, geometry).text(), "");
    const glm::dvec3 world(0.5, 1.2, 0);
    EXPECT_NEAR(glm::length(pixelOf(geometry, world) - pixelOf(geometryOf(camera), world)), 0, 1e-9);
}

/// As left-handed hosts look, and such with y down: along their view's z.
TEST(View, MayLookAlongPlusZ) {
    for (const bool reversed : {true, false}) {
        Camera camera;
        camera.reversed = reversed;
        camera.far = reversed ? 0 : 300;
        ViewDesc turned = describedView(camera);
        for (int i = 2; i < 16; i += 4) turned.view[i] *= -1;
        for (int i = 8; i < 12; ++i) turned.projection[i] *= -1;
        ViewGeometry geometry;
        ASSERT_STREQ(readView(turned, geometry).text(), "");
        const ViewGeometry truth = geometryOf(camera);
        EXPECT_EQ(geometry.reversedDepth, reversed);
        EXPECT_EQ(geometry.infinityDepth, truth.infinityDepth);
        EXPECT_NEAR(glm::length(geometry.forward - truth.forward), 0, 1e-12);
        EXPECT_NEAR(glm::length(geometry.eye - truth.eye), 0, 1e-12);
        const glm::dvec3 world(0.5, 1.2, 0);
        EXPECT_NEAR(glm::length(pixelOf(geometry, world) - pixelOf(truth, world)), 0, 1e-9);
    }
}

TEST(View, TakesProjectionsFromTheEyeAlone) {
    const auto read = [](const Camera& camera, const auto& change) {
        ViewDesc view = describedView(camera);
        glm::dmat4 projection = tests::projectionMatrix(camera);
        change(projection);
        tests::copyMatrix(projection, view.projection);
        ViewGeometry geometry;
        return std::string(readView(view, geometry).text());
    };
    std::vector<Camera> cameras = everyKindOfCamera();
    cameras.emplace_back().eye = {0, 2, 0}; // level, over the origin
    cameras.back().target = {0, 2, -3};
    for (const Camera& camera : cameras) {
        EXPECT_EQ(read(camera, [](glm::dmat4&) {}), "");
        // Turned by a quarter on the screen; of one eye of two; of a display that is canted.
        const glm::dmat4 quarter = glm::rotate(glm::dmat4(1), 0.5 * std::numbers::pi, glm::dvec3(0, 0, 1));
        EXPECT_EQ(read(camera, [&](glm::dmat4& p) { p = quarter * p; }), "");
        EXPECT_EQ(read(camera, [](glm::dmat4& p) { p = glm::translate(p, glm::dvec3(0.04, 0, 0.01)); }), "");
        EXPECT_EQ(read(camera, [](glm::dmat4& p) { p = glm::rotate(p, 0.1, glm::dvec3(0, 1, 0)); }), "");
        const std::string refused = read(camera, [&](glm::dmat4& p) { p = p * tests::viewMatrix(camera); });
        EXPECT_NE(refused.find("ViewDesc.projection"), std::string::npos) << camera.eye.y;
    }
}

TEST(View, NamesWhatIsWrong) {
    const auto refused = [](auto&& spoil) {
        ViewDesc view = describedView(Camera{});
        spoil(view);
        ViewGeometry geometry;
        return std::string(readView(view, geometry).text());
    };
    EXPECT_NE(refused([](ViewDesc& v) { v.view[5] = NAN; }).find("view"), std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.projection[0] = INFINITY; }).find("projection"), std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.projection[0] = 0; }).find("singular"), std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) {
                  for (int i = 0; i < 15; ++i) v.view[i] *= i % 4 < 3 ? 100 : 1;
              }).find("view scales"),
              std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) {
                  for (int i = 0; i < 3; ++i) v.view[i] = std::sqrt(0.5) * (v.view[i] + v.view[4 + i]);
              }).find("view shears"),
              std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) {
                  v.sceneColor.layout = VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL;
              }).find("sceneColor.layout"),
              std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.viewport.width = 0; }).find("viewport"), std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.viewport.maxDepth = 0.5f; }).find("depth range"),
              std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.viewIndex = 8; }).find("viewIndex"), std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) { v.sceneDepth.view = VK_NULL_HANDLE; }).find("sceneDepth"),
              std::string::npos);
    EXPECT_NE(refused([](ViewDesc& v) {
                  v.sceneColor.extent = {4, 4};
              }).find("sceneColor"),
              std::string::npos);
}

TEST(View, ValuesOfAMatrixComeBackAsTheyWere) {
    const ViewDesc view = describedView(everyKindOfCamera().front());
    double values[16];
    toValues(toMatrix(view.view), values);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(values[i], view.view[i]);
    EXPECT_EQ(glm::dvec3(toMatrix(view.view)[3]), glm::dvec3(view.view[12], view.view[13], view.view[14]));
}

TEST(View, NamesTheImageThatCannotBeRead) {
    const auto refused = [](auto&& spoil) {
        ViewDesc view = describedView(Camera{});
        Image normals = view.sceneColor;
        view.surfaceNormals = &normals;
        spoil(view, normals);
        ViewGeometry geometry;
        return std::string(readView(view, geometry).text());
    };
    const auto begins = [](const std::string& text, const char* with) { return text.find(with) == 0; };
    using View = ViewDesc;
    EXPECT_EQ(refused([](View&, Image&) {}), "");
    EXPECT_EQ(refused([](View& v, Image&) { v.sceneDepth.format = VK_FORMAT_UNDEFINED; }),
              "ViewDesc.sceneDepth.format holds no depth that can be read, expected D16_UNORM, "
              "X8_D24_UNORM_PACK32 or D32_SFLOAT, with stencil or without, R16_UNORM or R32_SFLOAT");
    EXPECT_TRUE(begins(refused([](View& v, Image&) { v.sceneDepth.format = VK_FORMAT_R16G16B16A16_SFLOAT; }),
                       "ViewDesc.sceneDepth.format"));
    EXPECT_TRUE(begins(refused([](View& v, Image&) { v.sceneDepth.format = VK_FORMAT_S8_UINT; }),
                       "ViewDesc.sceneDepth.format"));
    EXPECT_TRUE(begins(refused([](View& v, Image&) { v.sceneColor.format = VK_FORMAT_R32G32B32A32_UINT; }),
                       "ViewDesc.sceneColor.format"));
    EXPECT_TRUE(begins(refused([](View& v, Image&) { v.sceneColor.format = VK_FORMAT_D32_SFLOAT; }),
                       "ViewDesc.sceneColor.format"));
    EXPECT_TRUE(begins(refused([](View&, Image& n) { n.format = VK_FORMAT_R8G8B8A8_UNORM; }),
                       "ViewDesc.surfaceNormals.format"));
    for (const VkImageLayout layout : {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL}) {
        EXPECT_TRUE(begins(refused([&](View& v, Image&) { v.sceneDepth.layout = layout; }),
                           "ViewDesc.sceneDepth.layout"));
        EXPECT_TRUE(begins(refused([&](View& v, Image&) { v.sceneColor.layout = layout; }),
                           "ViewDesc.sceneColor.layout"));
        EXPECT_TRUE(begins(refused([&](View&, Image& n) { n.layout = layout; }), //
                           "ViewDesc.surfaceNormals.layout"));
    }
    EXPECT_TRUE(begins(refused([](View& v, Image&) {
                           v.sceneDepth.extent = {0, 0};
                       }),
                       "ViewDesc.sceneDepth"));
    EXPECT_TRUE(begins(refused([](View& v, Image&) { v.viewport.x = 1; }), "ViewDesc.sceneDepth"));
    EXPECT_TRUE(begins(refused([](View&, Image& n) { n.extent.height = 0; }), "ViewDesc.surfaceNormals"));
}

TEST(View, NamesSampleCountsThatDoNotFit) {
    const auto refused = [](VkSampleCountFlagBits depth, VkSampleCountFlagBits color,
                            VkSampleCountFlagBits normal) {
        ViewDesc view = describedView(Camera{});
        Image normals = view.sceneColor;
        view.surfaceNormals = &normals;
        view.sceneDepth.samples = depth;
        view.sceneColor.samples = color;
        normals.samples = normal;
        ViewGeometry geometry;
        return std::string(readView(view, geometry).text());
    };
    constexpr auto one = VK_SAMPLE_COUNT_1_BIT, four = VK_SAMPLE_COUNT_4_BIT, eight = VK_SAMPLE_COUNT_8_BIT;
    EXPECT_EQ(refused(four, four, one), "");
    EXPECT_EQ(refused(four, one, one), "");
    EXPECT_EQ(refused(one, four, one).find("ViewDesc.sceneColor.samples"), 0u);
    EXPECT_EQ(refused(four, eight, one).find("ViewDesc.sceneColor.samples"), 0u);
    EXPECT_EQ(refused(four, four, four).find("ViewDesc.surfaceNormals.samples"), 0u);
    for (const auto none : {VkSampleCountFlagBits{}, VK_SAMPLE_COUNT_32_BIT})
        EXPECT_EQ(refused(none, none, one).find("ViewDesc.sceneDepth.samples"), 0u);
}

TEST(View, MultisampledScenesAreMirroredFromWhereTheirSampleLies) {
    for (const VkSampleCountFlagBits samples :
         {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_2_BIT, VK_SAMPLE_COUNT_4_BIT, VK_SAMPLE_COUNT_8_BIT}) {
        ViewDesc desc = describedView(Camera{});
        desc.sceneDepth.samples = samples;
        ViewGeometry view;
        ASSERT_STREQ(readView(desc, view).text(), "");
        const ScreenMirror mirror = screenMirror(view, planeFacingEye(unitPlane(0, 1, 0, 0), view.eye));
        const glm::dmat4 both = mirror.sceneFromPixel * mirror.pixelFromPixel;
        const glm::dmat4 unit = both / both[3][3];
        for (int i = 0; i < 16; ++i) EXPECT_NEAR(unit[i / 4][i % 4], i % 5 == 0 ? 1 : 0, 1e-6);
        EXPECT_EQ(mirror.sceneFromPixel == mirror.pixelFromPixel, samples == VK_SAMPLE_COUNT_1_BIT);
    }
}

TEST(View, DepthStepsAreThoseOfTheFormat) {
    const auto stepOf = [](VkFormat format, bool reversed) {
        Camera camera;
        camera.reversed = reversed;
        ViewDesc view = describedView(camera);
        view.sceneDepth.format = format;
        ViewGeometry geometry;
        EXPECT_STREQ(readView(view, geometry).text(), "");
        return geometry.depthStep;
    };
    for (const bool reversed : {true, false}) {
        EXPECT_EQ(stepOf(VK_FORMAT_D16_UNORM, reversed), 1.0 / 65535);
        EXPECT_EQ(stepOf(VK_FORMAT_D24_UNORM_S8_UINT, reversed), 1.0 / 16777215);
    }
    EXPECT_EQ(stepOf(VK_FORMAT_D32_SFLOAT_S8_UINT, true), 0);
    EXPECT_EQ(stepOf(VK_FORMAT_D32_SFLOAT_S8_UINT, false), 0x1p-24);
}

} // namespace
