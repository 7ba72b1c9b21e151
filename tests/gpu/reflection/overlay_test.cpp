// The debug overlay must say what the rig knows to be true, and look different when the camera is told wrong.
#include <array>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/overlay_target.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

using Rgb = std::array<double, 3>;

// As reflection.h tells them.
constexpr Rgb noDepth = {1, 0, 1};
constexpr Rgb farPlane = {0.5, 0.75, 1};
constexpr Rgb noMirror = {0.06, 0.07, 0.1};
constexpr Rgb mirrorSeen = {0.1, 0.35, 0.8};
constexpr Rgb low = {0.2, 0.55, 0.25};
constexpr Rgb high = {0.95, 0.95, 0.85};

Rgb mixed(const Rgb& a, const Rgb& b, double t) {
    Rgb out;
    for (size_t i = 0; i < 3; ++i) out[i] = a[i] + (b[i] - a[i]) * t;
    return out;
}

Rgb distanceColor(double metres) {
    constexpr Rgb decades[] = {
        {1, 1, 1}, {1, 0.85, 0.2}, {0.1, 0.65, 0.6}, {0.35, 0.15, 0.6}, {0.08, 0.05, 0.2}};
    const double at = std::clamp(std::log10(metres) + 1, 0.0, 3.999);
    Rgb color = mixed(decades[static_cast<int>(at)], decades[static_cast<int>(at) + 1], at - std::floor(at));
    int bands = 0;
    for (double decade = 1e-6; decade < 1e6; decade *= 10)
        for (const double edge : {decade, 2 * decade, 5 * decade}) bands += metres >= edge;
    for (double& value : color) value *= bands % 2 == 1 ? 1 : 0.8;
    return color;
}

struct Look {
    uint32_t width = 0;
    std::vector<float> rgba;
    Rgb at(size_t i) const { return {double{rgba[i * 4]}, double{rgba[i * 4 + 1]}, double{rgba[i * 4 + 2]}}; }
};

bool near(const Rgb& a, const Rgb& b, double tolerance = 0.01) {
    for (size_t i = 0; i < 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
    return true;
}

/// What the eye sees at a pixel: how far it is, infinite for the sky.
struct Seen {
    glm::dvec3 ray;
    double distance;
};

class Truths {
  public:
    explicit Truths(const Camera& camera)
        : camera_(camera), inverse_(glm::inverse(projectionMatrix(camera) * viewMatrix(camera))) {}
    Seen at(uint32_t x, uint32_t y) const {
        const glm::dvec2 ndc =
            (glm::dvec2(x, y) + 0.5) / glm::dvec2(camera_.width, camera_.height) * 2.0 - 1.0;
        const glm::dvec4 p = inverse_ * glm::dvec4(ndc, 0.5, 1);
        const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w - camera_.eye);
        return {ray, nearestHit(boxes_, camera_.eye, ray)};
    }
    double ahead(const Seen& seen) const {
        return seen.distance * glm::dot(seen.ray, glm::normalize(camera_.target - camera_.eye));
    }
    double height(const Seen& seen) const { return camera_.eye.y + seen.distance * seen.ray.y; }

  private:
    Camera camera_;
    glm::dmat4 inverse_;
    std::vector<Box> boxes_ = harbourOfBoxes();
};

class Overlay : public ReflectionTest {
  protected:
    /// Reflects the boxes and draws an overlay of them; `told` are the matrices that the library is given.
    Look look(OverlayKind kind, const TracedView& traced, ViewDesc told, const ReflectorDesc& desc = {}) {
        const demos::Image target = overlayTarget({traced.width, traced.height});
        const SceneOnDevice scene = upload(traced, told);
        OverlayDesc overlay;
        overlay.kind = kind;
        overlay.target = described(target);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &told), Status::ok) << message();
            toGeneral(commands, target);
            EXPECT_EQ(recordOverlay(commands, reflector, &told, &overlay), Status::ok) << message();
            toSampled(commands, target);
        });
        const ReflectionImages images = reflectionImages(reflector, told.viewIndex);
        if (images.color) {
            reflected_ = {download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                          download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
        }
        Look out{traced.width, download(target.image.get(), target.format, target.extent)};
        destroyReflector(reflector);
        frame([](VkCommandBuffer) {});
        frame([](VkCommandBuffer) {});
        return out;
    }

    /// Of the last look(), for a whole picture.
    const Reflected& reflected() const { return reflected_; }

  private:
    Reflected reflected_;
};

std::vector<Camera> conventions() {
    std::vector<Camera> cameras;
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 1000.0}) {
            Camera camera = testCamera();
            camera.reversed = reversed;
            camera.far = far;
            cameras.push_back(camera);
        }
    return cameras;
}

TEST_F(Overlay, DepthIsTheDistanceAheadWhateverTheConvention) {
    for (const Camera& camera : conventions()) {
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        const Look shown = look(OverlayKind::depth, traced, viewDesc(camera));
        const Truths truths(camera);
        size_t wrong = 0, skies = 0;
        for (uint32_t y = 0, i = 0; y < camera.height; ++y)
            for (uint32_t x = 0; x < camera.width; ++x, ++i) {
                const Seen seen = truths.at(x, y);
                const bool sky = std::isinf(seen.distance);
                skies += sky;
                wrong += !near(shown.at(i), sky ? farPlane : distanceColor(truths.ahead(seen)));
            }
        EXPECT_GT(skies, 1000u);
        // Of what lies on a band's edge, rounding decides.
        EXPECT_LE(wrong, traced.depth.size() / 1000) << camera.reversed << " " << camera.far;
    }
}

TEST_F(Overlay, ThePlaneIsWhereTheTruthSeesIt) {
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Look shown = look(OverlayKind::plane, traced, viewDesc(pose.camera));
        size_t wrong = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            const Rgb color = shown.at(i);
            Rgb darker = mirrorSeen;
            for (double& value : darker) value *= 0.8;
            const bool blue = near(color, mirrorSeen) || near(color, darker);
            wrong += blue != (traced.truth[i] != Truth::none);
        }
        // What the plane cuts off may fall on either side of it within its contact height.
        EXPECT_LE(wrong, traced.truth.size() / 500) << pose.name;
    }
}

TEST_F(Overlay, ContoursAreHeightsAboveThePlane) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const Look shown = look(OverlayKind::plane, traced, viewDesc(camera));
    const Truths truths(camera);
    const auto bandAt = [&](uint32_t x, uint32_t y) {
        const Seen seen = truths.at(std::min(x, camera.width - 1), std::min(y, camera.height - 1));
        return std::isinf(seen.distance) ? -1 : static_cast<int>(std::floor(truths.height(seen)));
    };
    size_t above = 0, lines = 0, wrong = 0;
    for (uint32_t y = 0, i = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x, ++i) {
            const Seen seen = truths.at(x, y);
            const double height = truths.height(seen);
            if (std::isinf(seen.distance) || height < 0.01) continue;
            ++above;
            const int here = bandAt(x, y), right = bandAt(x + 1, y), below = bandAt(x, y + 1);
            const bool line = (right >= 0 && right != here) || (below >= 0 && below != here);
            lines += line;
            wrong += !near(shown.at(i), line ? Rgb{0, 0, 0} : mixed(low, high, std::min(height / 10, 1.0)));
        }
    EXPECT_GT(above, 5000u);
    EXPECT_GT(lines, 100u);
    EXPECT_LE(wrong, above / 200);
}

TEST_F(Overlay, WhatIsKnownIsWhatReflectLeft) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const auto expectShown = [&](OverlayKind kind, auto&& expected) {
        const Look shown = look(kind, traced, viewDesc(camera));
        size_t wrong = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            const Rgb color = traced.truth[i] == Truth::none ? noMirror : expected(i);
            wrong += !near(shown.at(i), color);
        }
        EXPECT_LE(wrong, traced.truth.size() / 500) << static_cast<int>(kind);
    };
    expectShown(OverlayKind::classes, [&](size_t i) {
        const ReflectionClass known = reflectionClass(reflected().info[i]);
        if (known == ReflectionClass::hit) return Rgb{0, 1, 0};
        return known == ReflectionClass::sky ? Rgb{0, 0, 1} : Rgb{1, 0, 0};
    });
    expectShown(OverlayKind::confidence, [&](size_t i) {
        return mixed({0.6, 0, 0.1}, {0.95, 0.95, 0.9}, double{reflected().color[i * 4 + 3]});
    });
    expectShown(OverlayKind::hitDistance, [&](size_t i) {
        const float info = reflected().info[i];
        if (info > 0) return distanceColor(double{info});
        return info < 0 ? farPlane : Rgb{1, 0, 0};
    });
}

TEST_F(Overlay, AHalfResolutionReflectionIsShownAtFullSize) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ReflectorDesc desc;
    desc.reflection.downscale = 2;
    const Look shown = look(OverlayKind::classes, traced, viewDesc(camera), desc);
    size_t wrong = 0;
    for (uint32_t y = 0, i = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x, ++i) {
            if (traced.truth[i] == Truth::none) continue;
            const float info = reflected().info[size_t{y / 2} * (camera.width / 2) + x / 2];
            wrong += near(shown.at(i), {0, 1, 0}) != (info > 0);
        }
    EXPECT_LE(wrong, traced.truth.size() / 500);
}

TEST_F(Overlay, ARegionOfALargerTargetIsTheSamePicture) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ViewDesc view = viewDesc(camera);
    const Look whole = look(OverlayKind::plane, traced, view);
    view.viewport.x = 37;
    view.viewport.y = 19;
    const Look part = look(OverlayKind::plane, framed(traced, 37, 19), view);
    size_t differing = 0;
    for (uint32_t y = 0, i = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x, ++i)
            differing += part.at(size_t{y + 19} * part.width + x + 37) != whole.at(i);
    EXPECT_EQ(differing, 0u);
}

TEST_F(Overlay, AFlippedProjectionMirrorsInTheSky) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ViewDesc flipped = viewDesc(camera);
    flipped.projection[5] = -flipped.projection[5];
    const Look shown = look(OverlayKind::plane, traced, flipped);
    const Rgb top = shown.at(camera.width / 2), bottom = shown.at(traced.depth.size() - camera.width / 2);
    EXPECT_GT(top[2], 1.5 * top[1]);
    EXPECT_TRUE(near(bottom, farPlane));
}

TEST_F(Overlay, DepthTakenTheWrongWayRoundHasNoFarPlane) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    Camera wrong = camera;
    wrong.reversed = false;
    const Look shown = look(OverlayKind::depth, traced, viewDesc(wrong));
    for (size_t i = 0; i < traced.depth.size(); ++i) {
        EXPECT_FALSE(near(shown.at(i), farPlane));
        if (traced.depth[i] == 0) {
            EXPECT_TRUE(near(shown.at(i), distanceColor(camera.near * 1.0001)));
        }
    }
}

TEST_F(Overlay, NoDepthIsMagenta) {
    const Camera camera = testCamera();
    TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    traced.depth[0] = NAN;
    traced.depth[1] = 1.5f;
    traced.depth[2] = -0.5f;
    for (const OverlayKind kind : {OverlayKind::depth, OverlayKind::plane, OverlayKind::classes}) {
        const Look shown = look(kind, traced, viewDesc(camera));
        for (size_t i = 0; i < 3; ++i) EXPECT_TRUE(near(shown.at(i), noDepth)) << i;
        EXPECT_FALSE(near(shown.at(3), noDepth));
    }
}

TEST_F(Overlay, CostsNothingUntilItIsAskedFor) {
    useOwnContext();
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const demos::Image target = overlayTarget({traced.width, traced.height});
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    ReflectorDesc desc;
    desc.reflection.technique = ReflectionTechnique::sky;
    spiedCalls().clear();
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    EXPECT_EQ(countSpied("CreateComputePipelines"), 0u);
    OverlayDesc overlay;
    overlay.target = described(target);
    for (int round = 0; round < 2; ++round)
        frame([&](VkCommandBuffer commands) {
            toGeneral(commands, target);
            EXPECT_EQ(recordOverlay(commands, reflector, &view, &overlay), Status::ok) << message();
        });
    EXPECT_EQ(countSpied("CreateComputePipelines"), 1u);
    EXPECT_EQ(countSpied("CmdDispatch"), 2u);
    EXPECT_EQ(countSpied("CreateImage"), 0u);
    destroyReflector(reflector);
}

TEST_F(Overlay, BadDescriptionsAreNamed) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, {}).run();
    const demos::Image target = overlayTarget({traced.width, traced.height});
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    const ReflectorDesc desc;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    const auto refused = [&](auto&& spoil) {
        OverlayDesc overlay;
        overlay.target = described(target);
        ViewDesc spoiled = view;
        spoil(overlay, spoiled);
        spiedCalls().clear();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(recordOverlay(commands, reflector, &spoiled, &overlay), Status::invalidArgument);
        });
        EXPECT_EQ(countSpied("CreateComputePipelines") + countSpied("CmdDispatch"), 0u);
        return message();
    };
    const auto names = [](const std::string& text, const char* field) {
        return text.find(field) != std::string::npos;
    };
    EXPECT_TRUE(names(refused([](OverlayDesc& d, ViewDesc&) { d.kind = OverlayKind(9); }), "kind"));
    EXPECT_TRUE(names(refused([](OverlayDesc& d, ViewDesc&) { d.contourSpacing = 0; }), "contourSpacing"));
    EXPECT_TRUE(names(refused([](OverlayDesc& d, ViewDesc&) { d.contourSpacing = NAN; }), "contourSpacing"));
    EXPECT_TRUE(
        names(refused([](OverlayDesc& d, ViewDesc&) { d.target.view = VK_NULL_HANDLE; }), "target.view"));
    EXPECT_TRUE(names(refused([](OverlayDesc& d, ViewDesc&) { d.target.format = VK_FORMAT_R8G8B8A8_UNORM; }),
                      "format"));
    EXPECT_TRUE(names(refused([](OverlayDesc& d, ViewDesc&) { d.target.layout = VK_IMAGE_LAYOUT_UNDEFINED; }),
                      "layout"));
    EXPECT_TRUE(
        names(refused([](OverlayDesc& d, ViewDesc&) { d.target.extent.width -= 1; }), "smaller than the"));
    EXPECT_TRUE(
        names(refused([](OverlayDesc&, ViewDesc& v) { v.projection[0] = NAN; }), "ViewDesc.projection"));
    EXPECT_TRUE(
        names(refused([](OverlayDesc& d, ViewDesc&) { d.kind = OverlayKind::classes; }), "reflect()"));
    EXPECT_EQ(recordOverlay(VK_NULL_HANDLE, reflector, &view, nullptr), Status::invalidArgument);
    destroyReflector(reflector);
}

} // namespace
