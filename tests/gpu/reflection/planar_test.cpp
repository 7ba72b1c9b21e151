// Planar reflection: a scene drawn with the mirrored camera must come out as the traced truth says, whatever
// the host's conventions. The host's drawing is traced on the CPU with the matrices that planarView() gives.
#include <array>
#include <cstring>

#include <glm/common.hpp>
#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

ReflectorDesc planarDesc() {
    ReflectorDesc desc;
    desc.reflection.technique = ReflectionTechnique::planar;
    return desc;
}

glm::dvec2 ndcOf(const glm::dvec2& pixel, const VkViewport& v) {
    return {(pixel.x - v.x) / v.width * 2 - 1, (pixel.y - v.y) / v.height * 2 - 1};
}

/// Where in the world, and an alpha that means nothing: the boxes seen by the mirrored camera, culled at the
/// plane where the projection clips there.
Drawn draw(const PlanarView& view, const glm::dmat4& hostProjection, const std::vector<Box>& boxes) {
    Drawn out;
    const glm::dmat4 clip = matrix(view.projection) * matrix(view.view);
    // The host's own projection tells rays apart: the oblique one may put any depth behind the eye.
    const glm::dmat4 inverse = glm::inverse(hostProjection * matrix(view.view));
    const bool parallel = hostProjection[2][3] == 0;
    const bool reversed = view.clearDepth == 0;
    for (uint32_t y = 0; y < view.extent.height; ++y)
        for (uint32_t x = 0; x < view.extent.width; ++x) {
            const glm::dvec2 ndc = ndcOf({x + 0.5, y + 0.5}, view.viewport);
            const auto at = [&](double depth) {
                const glm::dvec4 p = inverse * glm::dvec4(ndc, depth, 1);
                return glm::dvec3(p) / p.w;
            };
            const glm::dvec3 eye =
                parallel ? at(reversed ? 1 : 0) : glm::dvec3(glm::inverse(matrix(view.view))[3]);
            const glm::dvec3 ray = glm::normalize(at(0.5) - eye);
            const double toPlane = view.obliqueClip ? std::max(-eye.y / ray.y, 0.0) : 0.0;
            const double hit = nearestHit(boxes, eye + ray * toPlane, ray);
            if (std::isinf(hit)) {
                out.depth.push_back(view.clearDepth);
                out.color.push_back(0);
                continue;
            }
            const glm::dvec3 world = eye + ray * (toPlane + hit);
            const glm::dvec4 p = clip * glm::dvec4(world, 1);
            // Behind the mirror, and so beyond the host's own far plane.
            if (parallel && world.y > 1e-6) {
                EXPECT_NEAR(p.z / p.w, 0.5, 0.5 + 1e-9);
            }
            out.depth.push_back(static_cast<float>(p.z / p.w));
            out.color.push_back(glm::packHalf4x16(glm::vec4(world, 0.25f)));
        }
    return out;
}

/// How far from the mirror what the pixel mirrors is: infinite for the sky, negative where no mirror is seen.
double mirroredDistance(const Camera& camera, const std::vector<Box>& boxes, const glm::dvec2& pixel) {
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    const VkViewport whole = viewDesc(camera).viewport;
    const auto at = [&](double depth) {
        const glm::dvec4 p = inverse * glm::dvec4(ndcOf(pixel, whole), depth, 1);
        return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 eye = camera.parallelHeight > 0 ? at(camera.reversed ? 1 : 0) : camera.eye;
    const glm::dvec3 ray = glm::normalize(at(0.5) - eye);
    const double toPlane = -eye.y / ray.y;
    if (!(toPlane > 0) || std::isinf(toPlane)) return -1;
    return nearestHit(boxes, eye + ray * toPlane, ray * glm::dvec3(1, -1, 1));
}

class Planar : public ReflectionTest {
  protected:
    void TearDown() override {
        destroyReflector(reflector_);
        ReflectionTest::TearDown();
    }

    void use(const ReflectorDesc& desc) {
        EXPECT_EQ(createReflector(context(), &desc, &reflector_), Status::ok) << message();
    }

    Reflector* reflector() {
        if (!reflector_) use(planarDesc());
        return reflector_;
    }

    PlanarView handOut(const ViewDesc& view) {
        PlanarView out;
        EXPECT_EQ(planarView(reflector(), &view, &out), Status::ok) << message();
        return out;
    }

    Reflected reflectDrawn(const ViewDesc& view, const PlanarView& mirrored, const Drawn& drawn) {
        const DrawnBuffers buffers(drawn);
        frame([&](VkCommandBuffer commands) {
            recordDrawing(commands, mirrored, buffers);
            Reflector* const one = reflector();
            EXPECT_EQ(reflect(commands, &one, 1, &view), Status::ok) << message();
        });
        const ReflectionImages images = reflectionImages(reflector(), view.viewIndex);
        return {download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    }

    Reflected reflectBoxes(const ViewDesc& view, Drawn* drawnOut = nullptr) {
        const PlanarView mirrored = handOut(view);
        const Drawn drawn = draw(mirrored, matrix(view.projection), harbourOfBoxes());
        if (drawnOut) *drawnOut = drawn;
        return reflectDrawn(view, mirrored, drawn);
    }

    void expectTruth(const char* name, const Camera& camera) {
        const std::vector<Box> boxes = harbourOfBoxes();
        const TracedView truth = Tracer(camera, boxes).run();
        Drawn drawn;
        const Reflected result = reflectBoxes(viewDesc(camera), &drawn);
        size_t reflected = 0, hits = 0, wrongClass = 0, wrongColor = 0, wrongDistance = 0;
        for (size_t i = 0; i < truth.truth.size(); ++i) {
            if (truth.truth[i] == Truth::none) continue;
            ++reflected;
            const bool sky = truth.truth[i] == Truth::sky;
            const ReflectionClass found = reflectionClass(result.info[i]);
            wrongClass += found != (sky ? ReflectionClass::sky : ReflectionClass::hit);
            if (sky || found != ReflectionClass::hit) continue;
            ++hits;
            const glm::vec4 expected(glm::vec3(glm::unpackHalf4x16(drawn.color[i])), 1);
            wrongColor += std::memcmp(&expected, &result.color[i * 4], sizeof expected) != 0;
            const glm::dvec2 pixel(double(i % truth.width) + 0.5, double(i / truth.width) + 0.5);
            const double distance = mirroredDistance(camera, boxes, pixel);
            wrongDistance += std::abs(double{result.info[i]} - distance) > 1e-3 + 2e-3 * distance;
        }
        std::printf("%-8s %-8s far %4.0f: %zu reflected, %zu hits, wrong: class %zu, distance %zu\n", name,
                    camera.reversed ? "reversed" : "forward", camera.far, reflected, hits, wrongClass,
                    wrongDistance);
        EXPECT_GT(hits, 500u) << name;
        // Where two boxes meet in a pixel's centre, rounding decides which is seen.
        EXPECT_LE(wrongClass, 2u) << name;
        EXPECT_LE(wrongDistance, 2u) << name;
        EXPECT_EQ(wrongColor, 0u) << name;
    }

  private:
    Reflector* reflector_ = nullptr;
};

struct Convention {
    bool reversed;
    double far;
};
constexpr Convention conventions[] = {{true, 0}, {true, 1000}, {false, 0}, {false, 1000}};

TEST_F(Planar, TemporalReuseLeavesWhatStandsStillAsItIs) {
    ReflectorDesc desc = planarDesc();
    const ViewDesc view = viewDesc(testCamera());
    const Reflected once = reflectBoxes(view);
    destroyReflector(reflector());
    desc.reflection.temporal = 0.9f;
    use(desc);
    for (int i = 0; i < 4; ++i) {
        const Reflected again = reflectBoxes(view);
        EXPECT_EQ(again.info, once.info) << i;
        EXPECT_EQ(again.color, once.color) << i;
    }
    Camera moved = testCamera();
    moved.eye.x += 0.3;
    const Reflected after = reflectBoxes(viewDesc(moved));
    ViewDesc cut = viewDesc(moved);
    cut.cut = true;
    EXPECT_NE(reflectBoxes(cut).color, after.color);
}

TEST_F(Planar, HoldsColorAsTheScenesDoes) {
    ViewDesc view = viewDesc(testCamera());
    const PlanarView mirrored = handOut(view);
    Drawn linear = draw(mirrored, matrix(view.projection), harbourOfBoxes()), held = linear;
    for (size_t i = 0; i < linear.color.size(); ++i) {
        const glm::vec3 color =
            glm::min(glm::abs(glm::vec3(glm::unpackHalf4x16(linear.color[i]))) / 20.0f, 1.0f);
        linear.color[i] = glm::packHalf4x16(glm::vec4(color, 1));
        held.color[i] = glm::packHalf4x16(glm::vec4(glm::convertLinearToSRGB(color), 1));
    }
    const Reflected expected = reflectDrawn(view, mirrored, linear);
    view.sceneColor.encoding = Encoding::srgb;
    const Reflected found = reflectDrawn(view, handOut(view), held);
    EXPECT_EQ(expected.info, found.info);
    ASSERT_EQ(expected.color.size(), found.color.size());
    for (size_t i = 0; i < found.color.size(); ++i) ASSERT_NEAR(found.color[i], expected.color[i], 2e-3) << i;
}

TEST_F(Planar, AgreesWithTheTracedTruth) {
    for (const Pose& pose : poses())
        for (const Convention& convention : conventions) {
            Camera camera = pose.camera;
            camera.width = 240;
            camera.height = 135;
            camera.reversed = convention.reversed;
            camera.far = convention.far;
            expectTruth(pose.name, camera);
        }
}

TEST_F(Planar, ParallelViewsAgreeWithTheTracedTruth) {
    for (Pose& pose : parallelPoses())
        for (const bool reversed : {true, false}) {
            pose.camera.reversed = reversed;
            expectTruth(pose.name, pose.camera);
        }
}

TEST_F(Planar, ARegionOfALargerTargetIsTheSamePicture) {
    const Camera camera = testCamera();
    const Reflected whole = reflectBoxes(viewDesc(camera));
    ViewDesc part = viewDesc(camera);
    part.viewport.x = 37;
    part.viewport.y = 19;
    const Reflected moved = reflectBoxes(part);
    EXPECT_EQ(moved.info, whole.info);
    EXPECT_EQ(moved.color, whole.color);
}

TEST_F(Planar, AHalfIsDrawnAtHalfTheResolution) {
    const Camera camera = testCamera();
    ReflectorDesc desc = planarDesc();
    desc.reflection.downscale = 2;
    use(desc);
    const Reflected half = reflectBoxes(viewDesc(camera));
    const VkExtent2D extent = reflectionImages(reflector(), 0).extent;
    ASSERT_EQ(extent.width, camera.width / 2);
    ASSERT_EQ(extent.height, camera.height / 2);
    size_t hits = 0, wrong = 0;
    for (size_t i = 0; i < half.info.size(); ++i) {
        const glm::dvec2 pixel(2.0 * double(i % extent.width) + 1, 2.0 * double(i / extent.width) + 1);
        const double distance = mirroredDistance(camera, harbourOfBoxes(), pixel);
        if (distance < 0 || std::isinf(distance)) continue;
        ++hits;
        wrong += std::abs(double{half.info[i]} - distance) > 1e-3 + 2e-3 * distance;
    }
    EXPECT_GT(hits, 1000u);
    EXPECT_LE(wrong, 2u);
}

TEST_F(Planar, ANegativeViewportHeightIsTheSamePicture) {
    const Camera camera = testCamera();
    const Reflected whole = reflectBoxes(viewDesc(camera));
    ViewDesc flipped = viewDesc(camera);
    flipped.projection[5] = -flipped.projection[5];
    flipped.viewport.y = flipped.viewport.height;
    flipped.viewport.height = -flipped.viewport.height;
    const Reflected other = reflectBoxes(flipped);
    size_t differing = 0;
    for (size_t i = 0; i < whole.info.size(); ++i)
        differing += reflectionClass(whole.info[i]) != reflectionClass(other.info[i]);
    EXPECT_LE(differing, 2u);
}

TEST_F(Planar, CrossingThePlaneInSmallStepsAgreesWithTheTruth) {
    size_t clipped = 0, unclipped = 0, hits = 0;
    for (int step = -8; step <= 8; ++step) {
        Camera camera = testCamera();
        camera.width = 160;
        camera.height = 90;
        camera.eye.y = step * 2.5e-4;
        const ViewDesc view = viewDesc(camera);
        const PlanarView mirrored = handOut(view);
        (mirrored.obliqueClip ? clipped : unclipped) += 1;
        const Reflected result =
            reflectDrawn(view, mirrored, draw(mirrored, projectionMatrix(camera), harbourOfBoxes()));
        for (const float value : result.info) ASSERT_TRUE(std::isfinite(value)) << camera.eye.y;
        if (step <= 0) continue;
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        size_t wrong = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            if (traced.truth[i] == Truth::none) continue;
            const bool hit = reflectionClass(result.info[i]) == ReflectionClass::hit;
            wrong += hit != (traced.truth[i] != Truth::sky);
            hits += hit;
        }
        EXPECT_LE(wrong, 2u) << camera.eye.y << " m";
    }
    EXPECT_GT(clipped, 4u);
    EXPECT_GT(unclipped, 2u);
    EXPECT_GT(hits, 100u);
}

TEST_F(Planar, WhatCouldNotBeClippedIsNotMirrored) {
    Camera camera = testCamera();
    camera.eye = {0, 0.05, 9};
    camera.target = {0, 0.05, 0};
    camera.near = 4;
    camera.fovDegrees = 90;
    camera.width = 8;
    camera.height = 540;
    const ViewDesc view = viewDesc(camera);
    const PlanarView mirrored = handOut(view);
    ASSERT_FALSE(mirrored.obliqueClip);
    const std::vector<Box> shoal = {{{-20, -3, 0}, {20, -0.02, 4}}};
    const Drawn drawn = draw(mirrored, projectionMatrix(camera), shoal);
    const Reflected result = reflectDrawn(view, mirrored, drawn);
    size_t seen = 0;
    for (size_t i = 0; i < drawn.depth.size(); ++i) {
        seen += drawn.depth[i] != mirrored.clearDepth;
        EXPECT_NE(reflectionClass(result.info[i]), ReflectionClass::hit) << "row " << i / camera.width;
    }
    EXPECT_GT(seen, 100u);
}

TEST_F(Planar, StaysFiniteAtTheExtremes) {
    for (const Camera& camera : extremeCameras()) {
        const ViewDesc view = viewDesc(camera);
        const PlanarView mirrored = handOut(view);
        for (int i = 0; i < 16; ++i) {
            EXPECT_TRUE(std::isfinite(mirrored.view[i])) << camera.eye.y;
            EXPECT_TRUE(std::isfinite(mirrored.projection[i])) << camera.eye.y;
        }
        const Reflected result =
            reflectDrawn(view, mirrored, draw(mirrored, projectionMatrix(camera), harbourOfBoxes()));
        const auto finite = [](float v) { return std::isfinite(v); };
        EXPECT_TRUE(std::ranges::all_of(result.color, finite)) << camera.eye.y;
        EXPECT_TRUE(std::ranges::all_of(result.info, finite)) << camera.eye.y;
    }
}

TEST_F(Planar, HoldsItsOwnKernelAlone) {
    useOwnContext();
    spiedCalls().clear();
    handOut(viewDesc(testCamera()));
    EXPECT_EQ(countSpied("CreateComputePipelines"), 2u); // and the blur's
    EXPECT_EQ(countSpied("CreateImage"), 3u);            // colour, info, depth
    EXPECT_EQ(countSpied("CreateBuffer"), 0u);
    const ReflectorDesc desc = planarDesc();
    Reflector* second = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &second), Status::ok) << message();
    EXPECT_EQ(countSpied("CreateComputePipelines"), 2u);
    destroyReflector(second);
}

TEST_F(Planar, TheEstimateIsWhatIsAllocatedAndDispatched) {
    Camera camera = testCamera();
    camera.width = 640;
    camera.height = 360;
    ReflectorDesc desc = planarDesc();
    ViewDesc view = viewDesc(camera);
    reflectBoxes(view); // makes uniform blocks
    for (const float temporal : {0.0f, 0.9f}) {
        desc.reflection.temporal = temporal;
        Estimate estimated;
        ASSERT_EQ(estimate(context(), &desc.reflection, {camera.width, camera.height}, &estimated),
                  Status::ok)
            << message();
        destroyReflector(reflector());
        use(desc);
        spiedCalls().clear();
        handOut(view);
        EXPECT_EQ(bytesSpied(), estimated.bytesPerView);
        reflectBoxes(view);
        EXPECT_EQ(countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect"), estimated.dispatchesPerView);
    }
}

TEST_F(Planar, OtherTechniquesHoldNoneOfIt) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    spiedCalls().clear();
    ReflectionTest::reflectScene(camera, traced);
    EXPECT_EQ(countSpied("CreateImage"), 2u);
}

TEST_F(Planar, IsRefusedByReflectorsThatAreNotPlanar) {
    ReflectorDesc desc;
    Reflector* sspr = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &sspr), Status::ok) << message();
    const ViewDesc view = viewDesc(testCamera());
    PlanarView out;
    EXPECT_EQ(planarView(sspr, &view, &out), Status::invalidArgument);
    EXPECT_NE(message().find("technique"), std::string::npos) << message();
    EXPECT_EQ(planarView(static_cast<Reflector*>(nullptr), &view, &out), Status::invalidArgument);
    EXPECT_EQ(planarView(reflector(), nullptr, &out), Status::invalidArgument);
    EXPECT_EQ(planarView(reflector(), &view, nullptr), Status::invalidArgument);
    ViewDesc bad = view;
    bad.viewport.width = 0;
    EXPECT_EQ(planarView(reflector(), &bad, &out), Status::invalidArgument);
    EXPECT_NE(message().find("viewport"), std::string::npos) << message();
    destroyReflector(sspr);
}

TEST_F(Planar, ReflectsOnlyWhatWasHandedOut) {
    const Camera camera = testCamera();
    const ViewDesc view = viewDesc(camera);
    Reflector* const one = reflector();
    const auto expectRefused = [&](const ViewDesc& v) {
        frame([&](VkCommandBuffer commands) {
            EXPECT_MISUSE(reflect(commands, &one, 1, &v), "reflect: planarView", message());
        });
    };
    expectRefused(view);
    reflectBoxes(view);
    expectRefused(view); // a second time
    handOut(view);
    Camera larger = camera;
    larger.width = camera.width + 8;
    expectRefused(viewDesc(larger)); // another size
}

} // namespace
