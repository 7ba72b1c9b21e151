// Refraction that looks at a picture of the bed: it finds there what the scene's own picture hides or ends
// before, where Snell's law says, whatever the host's conventions.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/gtc/packing.hpp>
#include <glm/matrix.hpp>

#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double index = 1.333;
constexpr double reach = 16; ///< of the bed from its middle, along x and z [m]

/// Tells where it is: x, one, z.
glm::vec3 radianceAt(const glm::dvec3& point) {
    return {1 + point.x / (2 * reach), 1, 1 + point.z / (2 * reach)};
}

/// A plane without end, in the world: n.p + d = 0. It has no underside.
struct BedPlane {
    glm::dvec4 plane{0, 1, 0, 2};

    Drawn seenBy(const PlanarView& view) const {
        Drawn out;
        const glm::dmat4 worldFromClip = glm::inverse(matrix(view.projection) * matrix(view.view));
        const bool fromAbove = glm::dot(plane, glm::inverse(matrix(view.view))[3]) > 0;
        for (uint32_t y = 0; y < view.extent.height; ++y)
            for (uint32_t x = 0; x < view.extent.width; ++x) {
                const glm::dvec2 ndc(
                    (x + 0.5 - double{view.viewport.x}) / double{view.viewport.width} * 2 - 1,
                    (y + 0.5 - double{view.viewport.y}) / double{view.viewport.height} * 2 - 1);
                // Points of the plane: plane . worldFromClip . (ndc, depth, 1) = 0.
                const glm::dvec4 row = plane * worldFromClip;
                const double depth = -(row.x * ndc.x + row.y * ndc.y + row.w) / row.z;
                const glm::dvec4 p = worldFromClip * glm::dvec4(ndc, depth, 1);
                const bool seen = fromAbove && depth > 0 && depth < 1 && p.w > 0;
                out.depth.push_back(seen ? static_cast<float>(depth) : view.clearDepth);
                // Where nothing was drawn there may be anything.
                constexpr float none = std::numeric_limits<float>::quiet_NaN();
                const glm::vec3 color = seen ? radianceAt(glm::dvec3(p) / p.w) : glm::vec3(none);
                out.color.push_back(glm::packHalf4x16(glm::vec4(color, 0.25f)));
            }
        return out;
    }

    glm::dvec3 over(const glm::dvec2& xz) const {
        return {xz.x, -(plane.x * xz.x + plane.z * xz.y + plane.w) / plane.y, xz.y};
    }

    glm::dvec3 metBy(const glm::dvec3& from, const glm::dvec3& ray) const {
        return from -
               ray * ((glm::dot(glm::dvec3(plane), from) + plane.w) / glm::dot(glm::dvec3(plane), ray));
    }
};

class Beds : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        desc_.refraction = &refraction_;
        desc_.bed = &bed_;
        desc_.shading.refractionSamples = 16;
        camera_.eye = {1, 2.5, 6};
        camera_.target = {0.5, -0.5, 0};
        camera_.width = 120;
        camera_.height = 80;
    }

    /// So that a pixel is longer along the line of sight than the search for the bed is exact; in water that
    /// dims what is taken for deep.
    void lookFromAfar() {
        camera_.eye = {-30, 24, 36};
        camera_.target = {0, 0, 0};
        camera_.fovDegrees = 10;
        camera_.width = 480;
        camera_.height = 320;
        std::ranges::fill(refraction_.absorption, 1.0f);
    }

    /// A host that draws the bed; the scene's own picture is of another, brighter and deeper one.
    void drawBed(Body* body, const BedPlane& bed) {
        Camera from = camera_;
        from.eye += beside_;
        from.target += beside_;
        ViewDesc view = viewDesc(from);
        if (changeView) changeView(view);
        PlanarView wanted;
        ASSERT_EQ(bedView(body, &view, &wanted), Status::ok) << message();
        ASSERT_TRUE(wanted.visible);
        EXPECT_FALSE(wanted.windingFlipped);
        oblique_ = wanted.obliqueClip;
        buffers_ = std::make_unique<DrawnBuffers>(bed.seenBy(wanted));
        beforeReflection = [this, wanted](VkCommandBuffer commands) {
            recordDrawing(commands, wanted, *buffers_);
        };
    }

    SceneBehind otherBed() const { return planeBelow(camera_, -40, 40.0f); }

    /// Of all pixels, where the bed shows against where Snell's law says.
    void expectTruth(const BedPlane& bed, const glm::dvec4& surface = {0, 1, 0, 0}, size_t shareOfAll = 3) {
        Body* const body = makeBody(desc_);
        drawBed(body, bed);
        const WaterPicture got = picture({body}, camera_, 0, SurfaceOutput::shaded, otherBed());
        EXPECT_TRUE(std::ranges::all_of(got.color, [](float c) { return std::isfinite(c); }));
        const WaterPicture mirrored = mirroredAlone();
        double most = 0;
        size_t compared = 0;
        for (uint32_t y = 0; y < got.height; ++y)
            for (uint32_t x = 0; x < got.width; ++x) {
                const size_t pixel = size_t{y} * got.width + x;
                if (!got.covered(pixel)) continue;
                glm::dvec3 sent;
                for (int c = 0; c < 3; ++c)
                    sent[c] = double{got.color[pixel * 4 + static_cast<size_t>(c)]} -
                              double{mirrored.color[pixel * 4 + static_cast<size_t>(c)]};
                const glm::dvec3 ray = rayThrough(camera_, x, y), normal(surface);
                const glm::dvec3 from =
                    camera_.eye - ray * ((glm::dot(normal, camera_.eye) + surface.w) / glm::dot(normal, ray));
                const glm::dvec3 truth = bed.metBy(from, glm::refract(ray, normal, 1 / index));
                const bool dry = glm::dot(normal, truth - from) > -0.05;
                if (dry || std::max(std::abs(truth.x), std::abs(truth.z)) > 0.9 * reach) continue;
                ASSERT_GT(sent.y, 0) << "nothing shines through";
                const glm::dvec3 shown = bed.over(2 * reach * (glm::dvec2(sent.x, sent.z) / sent.y - 1.0));
                // Both pictures were halves, of 11 bits.
                double halves = 0;
                for (size_t c = 0; c < 3; ++c)
                    halves = std::max(halves, double{got.color[pixel * 4 + c]} / 2048);
                const double unsure = 5 * reach * halves / sent.y / glm::distance(truth, camera_.eye);
                most = std::max(most, glm::distance(glm::normalize(shown - camera_.eye),
                                                    glm::normalize(truth - camera_.eye)) -
                                          unsure);
                ++compared;
            }
        std::printf("%zu pixels, at most %.4f rad off\n", compared, most);
        EXPECT_GT(compared, size_t{got.width} * got.height / shareOfAll);
        EXPECT_LT(most, 0.007); // a pixel is 0.011
    }

    /// Nothing shines through.
    WaterPicture mirroredAlone() {
        RefractionDesc opaque = refraction_;
        std::fill_n(opaque.absorption, 3, 100.0f);
        BodyDesc desc = desc_;
        desc.refraction = &opaque;
        desc.bed = nullptr;
        beforeReflection = nullptr;
        return picture({makeBody(desc)}, camera_);
    }

    Camera camera_;
    RefractionDesc refraction_{{0, 0, 0}, {0, 0, 0}};
    BedDesc bed_;
    BodyDesc desc_;
    bool oblique_ = false;
    glm::dvec3 beside_{0}; ///< the eye, as the bed is drawn [m]

  private:
    std::unique_ptr<DrawnBuffers> buffers_;
};

// Rays bend towards the lower border and past it; the scene's own picture is a wall.
TEST_F(Beds, ShowWhereSnellSaysBehindAndBeyondThePicture) {
    expectTruth({});
    EXPECT_TRUE(oblique_);
}

TEST_F(Beds, ShowThereInAnyPose) {
    for (const double roll : {37.0, 90.0, 180.0}) {
        camera_.rollDegrees = roll;
        expectTruth({});
    }
    camera_.rollDegrees = 0;
    camera_.eye = {0, 7, 0.5};
    camera_.target = {0, 0, 0};
    expectTruth({});
}

TEST_F(Beds, ShowThereWithAFarPlane) {
    camera_.far = 200;
    expectTruth({});
}

TEST_F(Beds, ShowThereOnASlope) {
    expectTruth({{0.1, 0.97, -0.2, 3}});
}

TEST_F(Beds, ShowThereFromAfar) {
    lookFromAfar();
    for (const uint32_t samples : {6u, 8u, 16u}) {
        desc_.shading.refractionSamples = samples;
        for (const double slope : {0.05, 0.1, 0.2}) expectTruth({{0, 1, slope, 2}});
    }
}

// What lies between its pixels is seen, too.
TEST_F(Beds, ShowThereByFewerPixels) {
    for (const uint32_t downscale : {2u, 3u}) {
        desc_.shading.bedDownscale = downscale;
        expectTruth({});
        expectTruth({{0.1, 0.97, -0.2, 3}});
    }
}

// It falls away more steeply than the eye looks down, which would see its underside.
TEST_F(Beds, ShowThereBehindTheBankThatTheEyeStandsOn) {
    camera_.eye = {1, 2.5, 6};
    camera_.target = {0.5, -0.5, -4};
    expectTruth({{0, 1, -0.8, 0.8}}, {0, 1, 0, 0}, 6);
}

TEST_F(Beds, ShowThereThroughATiltedSurface) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 1, 0.1));
    const double plane[] = {normal.x, normal.y, normal.z, 0.3};
    std::ranges::copy(plane, desc_.plane);
    expectTruth({{0, 1, 0, 4}}, {normal, 0.3});
}

TEST_F(Beds, ShowThereInAJitteredView) {
    camera_.jitter = {0.4, -0.3};
    expectTruth({});
}

// As by a host that draws it a frame ahead.
TEST_F(Beds, ShowThereWhenDrawnFromBesideTheEye) {
    beside_ = {0.2, 0.1, -0.1};
    expectTruth({});
}

// By a viewport of negative height.
TEST_F(Beds, ShowTheSameWithYUpInClipSpace) {
    Body* const body = makeBody(desc_);
    drawBed(body, {});
    const WaterPicture whole = picture({body}, camera_, 0, SurfaceOutput::shaded, otherBed());
    changeView = [](ViewDesc& view) {
        for (int column = 0; column < 4; ++column) view.projection[column * 4 + 1] *= -1;
        view.viewport.y = view.viewport.height;
        view.viewport.height *= -1;
    };
    drawBed(body, {});
    const WaterPicture flipped = picture({body}, camera_, 0, SurfaceOutput::shaded, otherBed());
    ASSERT_EQ(whole.color.size(), flipped.color.size());
    for (size_t i = 0; i < whole.color.size(); ++i) ASSERT_NEAR(whole.color[i], flipped.color[i], 1e-3f) << i;
}

// The surface keeps its pixels, at any roll and tilt, and the eye is raised as far as bent rays seem to come
// from higher.
TEST_F(Beds, AreDrawnFromAboveTheEye) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.2, 1, 0.1));
    const glm::dvec4 plane(up, 0.3);
    for (int i = 0; i < 4; ++i) desc_.plane[i] = plane[i];
    bed_.margin = 0;
    Body* const body = makeBody(desc_);
    for (const double roll : {0.0, 37.0, 90.0}) {
        camera_.rollDegrees = roll;
        const ViewDesc view = viewDesc(camera_);
        PlanarView wanted;
        frame([&](VkCommandBuffer) { ASSERT_EQ(bedView(body, &view, &wanted), Status::ok) << message(); });
        const glm::dmat4 seen = matrix(view.projection) * matrix(view.view),
                         drawn = matrix(wanted.projection) * matrix(wanted.view);
        for (int i = 0; i < 9; ++i) {
            const glm::dvec3 across = glm::dvec3(i % 3, 0, i / 3) - glm::dvec3(1, 0, 1);
            const glm::dvec3 point = across - up * (glm::dot(up, across) + plane.w);
            const glm::dvec4 a = seen * glm::dvec4(point, 1), b = drawn * glm::dvec4(point, 1);
            EXPECT_NEAR(a.x / a.w, b.x / b.w, 1e-9);
            EXPECT_NEAR(a.y / a.w, b.y / b.w, 1e-9);
        }
        const glm::dvec4 eye = glm::inverse(matrix(wanted.view))[3];
        const double height = glm::dot(plane, glm::dvec4(camera_.eye, 1));
        EXPECT_LT(glm::distance(glm::dvec3(eye) - up * (glm::dot(plane, eye) - height), camera_.eye), 1e-9);
        // Straight lines from there meet the bed where rays do that calm water bends, halfway from the
        // picture's steepest to the horizon.
        double steepest = 0;
        for (int i = 0; i < 9; ++i) {
            const glm::dvec4 p = glm::inverse(seen) * glm::dvec4(i % 3 - 1, i / 3 - 1, 0.5, 1);
            const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w - camera_.eye);
            steepest = std::max(steepest, -std::asin(glm::dot(ray, up)));
        }
        const double inAir = radians(90) - steepest / 2, inWater = std::asin(std::sin(inAir) / 1.333);
        EXPECT_NEAR(glm::dot(plane, eye) / height, std::tan(inAir) / std::tan(inWater), 1e-3);
    }
}

// Straight through, the bed is seen from where the eye is.
TEST_F(Beds, ThatAreNotDistortedAreDrawnFromTheEye) {
    refraction_.distortion = 0;
    Body* const body = makeBody(desc_);
    const ViewDesc view = viewDesc(camera_);
    PlanarView wanted;
    frame([&](VkCommandBuffer) { ASSERT_EQ(bedView(body, &view, &wanted), Status::ok) << message(); });
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(wanted.view[i], view.view[i], 1e-9);
}

// The picture of the bed ends somewhere too: there it is made up, and stays near to what is around.
TEST_F(Beds, WithoutAMarginEndWithThePicture) {
    bed_.margin = 0;
    Body* const body = makeBody(desc_);
    drawBed(body, {});
    const WaterPicture got = picture({body}, camera_, 0, SurfaceOutput::shaded, otherBed());
    for (size_t i = 0; i < size_t{got.width} * got.height; ++i) {
        if (!got.covered(i)) continue;
        ASSERT_TRUE(std::isfinite(got.color[i * 4]));
        ASSERT_LT(got.color[i * 4], 5) << "the wall shows";
    }
}

TEST_F(Beds, AreNotAskedForByAnEyeInTheWaterOrAwayFromIt) {
    UnderwaterDesc underwater;
    desc_.underwater = &underwater;
    Body* const body = makeBody(desc_);
    PlanarView wanted;
    const auto isWanted = [&](const Camera& camera) {
        frame([&](VkCommandBuffer) {
            const ViewDesc view = viewDesc(camera);
            EXPECT_EQ(bedView(body, &view, &wanted), Status::ok) << message();
        });
        return wanted.visible;
    };
    EXPECT_TRUE(isWanted(camera_));
    Camera below = camera_;
    below.eye.y = -3;
    below.target.y = -3;
    EXPECT_FALSE(isWanted(below));
    Camera away = camera_;
    away.target = {1, 20, 6.5};
    EXPECT_FALSE(isWanted(away));
}

// An eye that is half in the water: rays that the surface turns down meet the scene, whose pixels are not the
// bed's.
TEST_F(Beds, AreNotLookedAtWhereTheSurfaceIsSeenFromTheWater) {
    const UnderwaterDesc underwater{0};
    const ReflectionDesc reflection;
    desc_.underwater = &underwater;
    desc_.reflection = &reflection;
    camera_.eye = {0, -0.02, 0};
    camera_.target = camera_.eye + glm::dvec3(0, 0.2, -1);
    constexpr float radiance = 4;
    const SceneBehind scene = planeBelow(camera_, -4, radiance);
    Body* const body = makeBody(desc_);
    drawBed(body, {});
    const WaterPicture got = picture({body}, camera_, 0, SurfaceOutput::shaded, scene);
    beforeReflection = nullptr;
    desc_.bed = nullptr;
    const WaterPicture without = picture({makeBody(desc_)}, camera_, 0, SurfaceOutput::shaded, scene);
    EXPECT_EQ(got.color, without.color);
    EXPECT_GT(*std::ranges::max_element(got.color), 0.5f * radiance) << "nothing of the bed is mirrored";
}

TEST_F(Beds, CostWhatTheEstimateSays) {
    const auto bytes = [&] {
        Estimate estimated;
        EXPECT_EQ(estimate(context(), &desc_, {200, 100}, &estimated), Status::ok);
        return estimated.bytesPerView;
    };
    const VkDeviceSize with = bytes();
    desc_.shading.bedDownscale = 7;
    const VkDeviceSize fewer = bytes();
    desc_.bed = nullptr;
    EXPECT_GE(with - bytes(), 240u * 120u * (8u + 4u));
    EXPECT_GE(fewer - bytes(), 35u * 18u * (8u + 4u));
}

TEST_F(Beds, OfBadDescriptionsAreRefused) {
    for (const float margin : {-0.01f, 1.01f, std::numeric_limits<float>::quiet_NaN()}) {
        bed_.margin = margin;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument);
        EXPECT_EQ(message(), "BedDesc.margin is out of range, expected 0 to 1");
        EXPECT_EQ(body, nullptr);
    }
    bed_ = {};
    for (const uint32_t downscale : {0u, 9u}) {
        desc_.shading.bedDownscale = downscale;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument);
        EXPECT_EQ(message(), "ShadingDesc.bedDownscale is out of range, expected 1 to 8");
    }
    desc_.shading.bedDownscale = 1;
    desc_.refraction = nullptr;
    Body* body = nullptr;
    EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument);
    EXPECT_EQ(message(), "BodyDesc.bed needs BodyDesc.refraction");
}

TEST_F(Beds, ThatNobodyDrewAreNamed) {
    Body* const body = makeBody(desc_);
    Status shaded = Status::ok;
    beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& view) {
        EXPECT_MISUSE(shaded = shade(commands, &body, 1, &view, &lighting), "bedView\\(\\) and reflect\\(\\)",
                      message());
        return Status::ok;
    };
    drawing = [](VkCommandBuffer, Target*, const ViewDesc&) { return Status::ok; };
    picture({body}, camera_);
}

TEST_F(Beds, OfABodyWithoutOneAreRefused) {
    desc_.bed = nullptr;
    Body* const body = makeBody(desc_);
    const ViewDesc view = viewDesc(camera_);
    PlanarView wanted;
    frame([&](VkCommandBuffer) { EXPECT_EQ(bedView(body, &view, &wanted), Status::invalidArgument); });
    EXPECT_EQ(message(), "bedView: the body has no BodyDesc.bed");
    EXPECT_EQ(bedView(body, nullptr, &wanted), Status::invalidArgument);
    EXPECT_EQ(bedView(nullptr, &view, &wanted), Status::invalidArgument);
}

} // namespace
