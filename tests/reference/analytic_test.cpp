// Flat water over and under things whose picture has a closed form, written out here on its own.
#include <gtest/gtest.h>

#include "tests/reference/box_world.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;
using tests::Box;

constexpr double tolerance = 1e-4;
constexpr double index = 1.333;

/// Fresnel's equations for each polarisation, by both angles, where the code has Born and Wolf's single form.
double fresnel(double cosine) {
    const double sine = std::sqrt(1 - cosine * cosine), inside = std::sqrt(1 - sine * sine / (index * index));
    const double s = (cosine - index * inside) / (cosine + index * inside);
    const double p = (index * cosine - inside) / (index * cosine + inside);
    return (s * s + p * p) / 2;
}

struct Eye {
    glm::dvec3 position, forward, right, up;
    double tangent = 0;
    uint32_t width = 0, height = 0;

    explicit Eye(const reference::FrameDesc& desc) : width(desc.width), height(desc.height) {
        position = {desc.camera.positionM[0], desc.camera.positionM[1], desc.camera.positionM[2]};
        const glm::dvec3 target(desc.camera.targetM[0], desc.camera.targetM[1], desc.camera.targetM[2]);
        forward = glm::normalize(target - position);
        right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
        up = glm::cross(right, forward);
        tangent = std::tan(glm::radians(desc.camera.verticalFovDeg) / 2);
    }
    glm::dvec3 through(double x, double y) const {
        const double perPixel = 2 * tangent / height;
        return glm::normalize(forward + right * ((x - width / 2.0) * perPixel) +
                              up * ((height / 2.0 - y) * perPixel));
    }
    glm::dvec3 pixelOf(const glm::dvec3& point) const {
        const glm::dvec3 d = point - position;
        const double along = glm::dot(d, forward), perPixel = 2 * tangent / height;
        return {glm::dot(d, right) / along / perPixel + width / 2.0,
                height / 2.0 - glm::dot(d, up) / along / perPixel, along};
    }
};

WaterDesc clearWater() {
    WaterDesc water;
    water.refraction = RefractionDesc{};
    return water;
}

TEST(Analytic, FresnelUnderAnEvenSky) {
    const glm::dvec3 sky(0.5, 0.7, 0.9);
    reference::World world;
    ASSERT_TRUE(tests::lightWorld(glm::vec3(sky), world));
    Error error;
    ASSERT_TRUE(reference::setWater(clearWater(), world, error));
    const reference::FrameDesc desc = tests::smallFrame();
    const Eye eye(desc);
    const Picture picture = tests::traced(world, desc).color;
    const RefractionDesc optics;
    int checked = 0;
    for (uint32_t y = 0; y < desc.height; ++y)
        for (uint32_t x = 0; x < desc.width; ++x) {
            const glm::dvec3 d = eye.through(x + 0.5, y + 0.5);
            const double reflectance = d.y < 0 ? fresnel(-d.y) : 1;
            if (std::abs(d.y) < 1e-3) continue;
            for (int c = 0; c < 3; ++c) {
                const auto i = static_cast<size_t>(c);
                // Deep water: 0.33 bb / (a + bb) of what enters, 0.98 / n^2 of which leaves.
                const double backscatter = optics.backscatterPerM[i], absorption = optics.absorptionPerM[i];
                const double glow =
                    sky[c] * 0.934 * 0.33 * backscatter / (absorption + backscatter) * 0.98 / (index * index);
                const double expected = reflectance * sky[c] + (1 - reflectance) * glow;
                EXPECT_NEAR(static_cast<double>(picture.rgba[(size_t(y) * desc.width + x) * 4 + i]), expected,
                            tolerance)
                    << "pixel " << x << ", " << y << " channel " << c;
            }
            checked += d.y < 0 ? 1 : 0;
        }
    EXPECT_GT(checked, 1500);
}

/// Whether a ray's nearest box is the same for rays a little beside it, and how far it is.
struct Sure {
    bool sure = true;
    double distance = 0;
};
Sure surely(const std::vector<Box>& boxes, const glm::dvec3& from, const glm::dvec3& towards) {
    Sure s;
    s.distance = tests::nearestHit(boxes, from, towards);
    const glm::dvec3 beside[] = {
        {2e-4, 1e-4, 1e-4}, {-2e-4, -1e-4, 1e-4}, {1e-4, 2e-4, -1e-4}, {-1e-4, -2e-4, -1e-4}};
    for (const glm::dvec3& b : beside) {
        const double other = tests::nearestHit(boxes, from, glm::normalize(towards + b));
        s.sure &= std::isfinite(other) == std::isfinite(s.distance) &&
                  !(std::isfinite(other) && std::abs(other - s.distance) > 0.02 * s.distance);
    }
    return s;
}

TEST(Analytic, ReflectionRefractionAndBeerLambert) {
    // Light from a box in the air and a bed below; the sky is black, so that only they are seen.
    const std::vector<Box> inAir = {{{-1.5, 0.3, -4}, {1, 1.6, -3}}};
    const double bedDepth = 1.25;
    const std::vector<Box> bed = {{{-4000, -3, -4000}, {4000, -bedDepth, 4000}}};
    const glm::dvec3 boxRadiance(0.8, 0.4, 0.2), bedRadiance(0.5, 0.6, 0.7);
    reference::World world;
    ASSERT_TRUE(tests::lightWorld(glm::vec3(0), world));
    tests::addMesh("box", tests::shiningBoxes(inAir, glm::vec3(boxRadiance)), world);
    tests::addMesh("bed", tests::shiningBoxes(bed, glm::vec3(bedRadiance)), world);
    Error error;
    ASSERT_TRUE(reference::setWater(clearWater(), world, error));
    const reference::FrameDesc desc = tests::smallFrame();
    const Eye eye(desc);
    const Picture picture = tests::traced(world, desc).color;
    const RefractionDesc optics;
    int mirrored = 0, through = 0;
    for (uint32_t y = 0; y < desc.height; ++y)
        for (uint32_t x = 0; x < desc.width; ++x) {
            const glm::dvec3 d = eye.through(x + 0.5, y + 0.5);
            const Sure direct = surely(inAir, eye.position, d);
            const double toWater = d.y < 0 ? -eye.position.y / d.y : INFINITY;
            if (!direct.sure || std::abs(d.y) < 2e-2) continue;
            glm::dvec3 expected(0);
            if (direct.distance < toWater) {
                expected = boxRadiance;
            } else if (d.y < 0) {
                const glm::dvec3 at = eye.position + d * toWater;
                const Sure up = surely(inAir, at, {d.x, -d.y, d.z});
                if (!up.sure) continue;
                const double reflectance = fresnel(-d.y);
                const double down = std::sqrt(1 - (1 - d.y * d.y) / (index * index)); // Snell
                for (int c = 0; c < 3; ++c) {
                    const auto i = static_cast<size_t>(c);
                    const double attenuation = optics.absorptionPerM[i] + optics.backscatterPerM[i];
                    const double seen =
                        bedRadiance[c] * std::exp(-attenuation * bedDepth / down) / (index * index);
                    expected[c] = (1 - reflectance) * seen +
                                  (std::isfinite(up.distance) ? reflectance * boxRadiance[c] : 0);
                }
                ++(std::isfinite(up.distance) ? mirrored : through);
            }
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(static_cast<double>(
                                picture.rgba[(size_t(y) * desc.width + x) * 4 + static_cast<size_t>(c)]),
                            expected[c], tolerance)
                    << "pixel " << x << ", " << y << " channel " << c;
        }
    EXPECT_GT(mirrored, 60);
    EXPECT_GT(through, 1000);
}

reference::TruthClass classOf(const std::vector<Box>& boxes, const Eye& eye, const glm::dvec3& at,
                              const glm::dvec3& direction, double distance) {
    const glm::dvec3 p = at + direction * distance;
    const glm::dvec3 seen = eye.pixelOf(p);
    if (seen.z <= 0 || seen.x < 0 || seen.y < 0 || seen.x >= eye.width || seen.y >= eye.height)
        return reference::TruthClass::offScreen;
    const glm::dvec3 towards = glm::normalize(p - eye.position);
    const double first = tests::nearestHit(boxes, eye.position, towards), far = glm::length(p - eye.position);
    if (first > far - 1e-6) return reference::TruthClass::recoverable;
    // Seen from the eye, the point lies on the far side of its own box: only its back is there.
    for (const Box& box : boxes) {
        const glm::dvec3 inside = glm::clamp(p, box.low, box.high);
        if (glm::length(inside - p) > 1e-6) continue;
        const glm::dvec3 before = p - towards * 1e-4;
        if (glm::all(glm::greaterThan(before, box.low)) && glm::all(glm::lessThan(before, box.high)))
            return reference::TruthClass::backFacing;
    }
    return reference::TruthClass::hidden;
}

bool flatWaterUnder(const std::vector<Box>& boxes, reference::World& world) {
    Error error;
    if (!tests::lightWorld(glm::vec3(0.5f), world)) return false;
    tests::addMesh("boxes", tests::shiningBoxes(boxes, glm::vec3(1)), world);
    return reference::setWater(WaterDesc{}, world, error);
}

reference::FrameDesc wideFrame() {
    reference::FrameDesc desc = tests::smallFrame();
    desc.width = 160;
    desc.height = 90;
    return desc;
}

TEST(Analytic, ClassesOfTruth) {
    std::vector<Box> boxes = tests::harbourOfBoxes();
    reference::World world;
    ASSERT_TRUE(flatWaterUnder(boxes, world));
    reference::FrameDesc desc = wideFrame();
    desc.camera.verticalFovDeg = 38; // the tower's top is out of the picture
    const Eye eye(desc);
    const Picture truth = tests::traced(world, desc, true).truth;
    int counted[8] = {}, unsure = 0;
    for (uint32_t y = 0; y < desc.height; ++y)
        for (uint32_t x = 0; x < desc.width; ++x) {
            const float* const found = &truth.rgba[(size_t(y) * desc.width + x) * 4];
            const auto kind = static_cast<reference::TruthClass>(static_cast<int>(found[0]));
            const glm::dvec3 d = eye.through(x + 0.5, y + 0.5);
            const Sure direct = surely(boxes, eye.position, d);
            const double toWater = d.y < 0 ? -eye.position.y / d.y : INFINITY;
            if (!direct.sure || std::abs(d.y) < 2e-2) continue;
            if (direct.distance < toWater || d.y >= 0) {
                EXPECT_EQ(kind, reference::TruthClass::none) << x << ", " << y;
                continue;
            }
            const glm::dvec3 at = eye.position + d * toWater, up(d.x, -d.y, d.z);
            const Sure mirrored = surely(boxes, at, up);
            const double distance = mirrored.distance;
            if (!mirrored.sure) continue;
            if (!std::isfinite(distance)) {
                EXPECT_EQ(kind, reference::TruthClass::sky) << x << ", " << y;
                ++counted[static_cast<int>(kind)];
                continue;
            }
            const reference::TruthClass expected = classOf(boxes, eye, at, up, distance);
            // Where the mirrored point lies on the border between two classes, either is right.
            bool border = false;
            for (const double nudge : {-2e-3, 2e-3})
                for (const glm::dvec3& side : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
                    const glm::dvec3 turned = glm::normalize(up + nudge * side);
                    const double other = tests::nearestHit(boxes, at, turned);
                    border |= !std::isfinite(other) || classOf(boxes, eye, at, turned, other) != expected;
                }
            if (border) {
                ++unsure;
                continue;
            }
            // What lies in the middle of a class is sampled there.
            EXPECT_EQ(kind, expected) << x << ", " << y;
            ++counted[static_cast<int>(kind)];
            const glm::dvec3 pixel = eye.pixelOf(at + up * distance);
            if (pixel.z > 0) {
                EXPECT_NEAR(static_cast<double>(found[1]), pixel.x, 0.01 + 1e-4 * std::abs(pixel.x))
                    << x << ", " << y;
                EXPECT_NEAR(static_cast<double>(found[2]), pixel.y, 0.01 + 1e-4 * std::abs(pixel.y))
                    << x << ", " << y;
            }
            EXPECT_NEAR(static_cast<double>(found[3]), distance, 1e-3 * distance + 1e-3) << x << ", " << y;
        }
    for (const reference::TruthClass kind :
         {reference::TruthClass::sky, reference::TruthClass::recoverable, reference::TruthClass::offScreen,
          reference::TruthClass::hidden, reference::TruthClass::backFacing})
        EXPECT_GT(counted[static_cast<int>(kind)], 10) << "class " << static_cast<int>(kind);
    EXPECT_LT(unsure, 600);
}

// The underside of a deck just above the eye: seen at less than a pixel's height, mirrored at half the
// picture's.
TEST(Analytic, WhatNoPixelShowsIsUnsampled) {
    const std::vector<Box> boxes = {{{-20, 2.003, -30}, {20, 2.2, -5}}};
    reference::World world;
    ASSERT_TRUE(flatWaterUnder(boxes, world));
    reference::FrameDesc desc = wideFrame();
    desc.camera.positionM = {0, 2, 0};
    desc.camera.targetM = {0, 2, -10};
    const Picture truth = tests::traced(world, desc, true).truth;
    int counted[8] = {};
    for (size_t i = 0; i < truth.rgba.size(); i += 4) ++counted[static_cast<int>(truth.rgba[i])];
    const int unsampled = counted[static_cast<int>(reference::TruthClass::unsampled)];
    EXPECT_GT(unsampled, 500);
    EXPECT_LT(counted[static_cast<int>(reference::TruthClass::recoverable)], unsampled / 4);
}

// Likewise from farther off, where the deck's front is closer to the plane of its underside than depths tell:
// what no pixel shows is another face, however near.
TEST(Analytic, AFaceIsNotSampledByTheOneBesideIt) {
    const std::vector<Box> boxes = {{{-20, 2.003, -90}, {20, 2.2, -60}}};
    reference::World world;
    ASSERT_TRUE(flatWaterUnder(boxes, world));
    reference::FrameDesc desc = wideFrame();
    desc.camera.positionM = {0, 2, 0};
    desc.camera.targetM = {0, 2, -10};
    desc.camera.verticalFovDeg = 10;
    const Picture truth = tests::traced(world, desc, true).truth;
    const auto rowMirroring = [&](double heightAndEye, double away) {
        const double slope = heightAndEye / away / std::tan(glm::radians(desc.camera.verticalFovDeg) / 2);
        return static_cast<uint32_t>((1 + slope) * desc.height / 2);
    };
    const uint32_t first = rowMirroring(4.003, 90) + 1, front = rowMirroring(4.003, 60);
    ASSERT_GT(front, first + 5);
    for (uint32_t y = first; y < front; ++y)
        EXPECT_EQ(
            static_cast<reference::TruthClass>(truth.rgba[4 * (size_t{y} * desc.width + desc.width / 2)]),
            reference::TruthClass::unsampled)
            << "row " << y;
}

} // namespace
