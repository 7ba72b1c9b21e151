// Floors whose picture has a closed form, written out here on its own.
#include <gtest/gtest.h>

#include "tests/reference/box_world.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;
using tests::Box;

constexpr double tolerance = 1e-4;
const glm::dvec3 sky(0.5, 0.7, 0.9), shine(2.0, 0.3, 0.1);
const Box box = {{-1, 0, -3}, {1, 1.5, -2}};

FloorDesc wideFloor() {
    FloorDesc floor;
    floor.widthM = floor.lengthM = 400;
    floor.color = {0.5, 0.4, 0.3};
    floor.reflectance = 0.1;
    return floor;
}

/// A pixel's ray from (0, 2, 6), by the camera's own angles.
glm::dvec3 rayOf(const reference::FrameDesc& desc, uint32_t x, uint32_t y) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(0, 0.8, -6) - glm::dvec3(0, 2, 6));
    const glm::dvec3 right(1, 0, 0), up = glm::cross(right, forward);
    const double perPixel = 2 * std::tan(glm::radians(desc.camera.verticalFovDeg) / 2) / desc.height;
    return glm::normalize(forward + right * ((x + 0.5 - desc.width / 2.0) * perPixel) +
                          up * ((desc.height / 2.0 - y - 0.5) * perPixel));
}

/// Under a sky of one colour, which alone lights the floor, with one shining box on it.
bool makeWorld(const FloorDesc& floor, bool withBox, reference::World& world) {
    if (!tests::lightWorld(glm::vec3(sky), world)) return false;
    if (withBox) tests::addMesh("box", tests::shiningBoxes({box}, glm::vec3(shine)), world);
    Error error;
    const bool made = reference::setFloor(floor, world, error);
    EXPECT_TRUE(made) << error.text;
    return made;
}

TEST(Floor, MirrorsSkyAndThingsBySchlick) {
    const FloorDesc floor = wideFloor();
    reference::World world;
    ASSERT_TRUE(makeWorld(floor, true, world));
    const reference::FrameDesc desc = tests::smallFrame();
    const reference::Pictures pictures = tests::traced(world, desc, true);
    int skies = 0, boxes = 0;
    for (uint32_t y = 0; y < desc.height; ++y)
        for (uint32_t x = 0; x < desc.width; ++x) {
            const glm::dvec3 eye(0, 2, 6), d = rayOf(desc, x, y);
            const double t = eye.y / -d.y;
            const size_t at = (size_t(y) * desc.width + x) * 4;
            if (std::abs(d.y) < 0.02) continue; // the far edge
            if (d.y > 0 || tests::hitDistance(box, eye, d) < t) {
                EXPECT_EQ(pictures.truth.rgba[at], 0.0f);
                continue;
            }
            const glm::dvec3 mirrored(d.x, -d.y, d.z), point = eye + d * t;
            const bool hits = std::isfinite(tests::hitDistance(box, point + 1e-6 * mirrored, mirrored));
            const bool edge = std::isfinite(tests::hitDistance({box.low - 0.05, box.high + 0.05},
                                                               point + 1e-6 * mirrored, mirrored)) != hits;
            if (edge) continue;
            const double f = 0.1 + 0.9 * std::pow(1 + d.y, 5);
            for (int c = 0; c < 3; ++c) {
                const double ground = floor.color[static_cast<size_t>(c)] * sky[c];
                const double expected = (1 - f) * ground + f * (hits ? shine[c] : sky[c]);
                EXPECT_NEAR(static_cast<double>(pictures.color.rgba[at + static_cast<size_t>(c)]), expected,
                            10 * tolerance)
                    << x << " " << y << (hits ? " box" : " sky");
            }
            const auto kind = static_cast<reference::TruthClass>(static_cast<int>(pictures.truth.rgba[at]));
            EXPECT_EQ(kind == reference::TruthClass::sky, !hits) << x << " " << y;
            (hits ? boxes : skies) += 1;
        }
    EXPECT_GT(skies, 500);
    EXPECT_GT(boxes, 30);
}

TEST(Floor, IsThereFromItsFrontAlone) {
    FloorDesc floor = wideFloor();
    floor.normal = {0, -3, 0};
    reference::World world;
    ASSERT_TRUE(makeWorld(floor, false, world));
    const reference::Pictures pictures = tests::traced(world, tests::smallFrame(), true);
    for (size_t i = 0; i < pictures.truth.rgba.size(); i += 4) {
        EXPECT_EQ(pictures.truth.rgba[i], 0.0f);
        EXPECT_NEAR(static_cast<double>(pictures.color.rgba[i]), sky[0], 1e-3);
    }
}

TEST(Floor, AWallShowsWhatStandsBeforeIt) {
    FloorDesc wall = wideFloor();
    wall.pointM = {0, 0, -8};
    wall.normal = {0, 0, 1};
    wall.reflectance = 1;
    wall.color = {0, 0, 0};
    reference::World world;
    ASSERT_TRUE(makeWorld(wall, true, world));
    reference::FrameDesc desc = tests::smallFrame();
    desc.width *= 2;
    desc.height *= 2;
    const Picture picture = tests::traced(world, desc).color;
    int boxes = 0;
    for (uint32_t y = 0; y < desc.height; ++y)
        for (uint32_t x = 0; x < desc.width; ++x) {
            const glm::dvec3 eye(0, 2, 6), d = rayOf(desc, x, y), mirrored(d.x, d.y, -d.z);
            if (std::isfinite(tests::hitDistance(box, eye, d))) continue;
            const glm::dvec3 point = eye + d * ((-8 - eye.z) / d.z);
            const Box inner = {box.low + 0.05, box.high - 0.05};
            if (!std::isfinite(tests::hitDistance(inner, point, mirrored))) continue;
            const size_t at = (size_t(y) * desc.width + x) * 4;
            EXPECT_NEAR(static_cast<double>(picture.rgba[at]), shine[0], 2e-3) << x << " " << y;
            ++boxes;
        }
    EXPECT_GT(boxes, 5);
}

/// Share of the light that a white mirror of this roughness returns, as the sampled facets find it.
double returned(double roughness) {
    FloorDesc floor = wideFloor();
    floor.color = {0, 0, 0};
    floor.reflectance = 1;
    floor.roughness = roughness;
    reference::World world;
    EXPECT_TRUE(makeWorld(floor, false, world));
    reference::FrameDesc desc = tests::smallFrame();
    desc.camera.positionM = {0, 2, 0};
    desc.camera.targetM = {0, 0, -0.01};
    desc.camera.verticalFovDeg = 10;
    desc.samples = 32;
    const Picture picture = tests::traced(world, desc).color;
    double sum = 0;
    for (size_t i = 0; i < picture.rgba.size(); i += 4) sum += static_cast<double>(picture.rgba[i]);
    return sum / (static_cast<double>(picture.rgba.size()) / 4) / sky[0];
}

/// What a single bounce off GGX facets returns straight up: a midpoint rule over the half vectors' angle.
double expectedReturn(double alpha) {
    const double a2 = alpha * alpha, pi = glm::pi<double>();
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double h = (i + 0.5) / steps * pi / 4; // steeper facets mirror it down
        const double c = std::cos(h), out = std::cos(2 * h);
        const double denominator = c * c * (a2 - 1) + 1, density = a2 / (pi * denominator * denominator);
        const double masking = 2 * out / (out + std::sqrt(a2 + (1 - a2) * out * out));
        sum += density * masking * c * 2 * pi * std::sin(h) * (pi / 4 / steps);
    }
    return sum;
}

TEST(Floor, RoughMirrorsReturnWhatTheirFacetsDo) {
    for (const double roughness : {0.2, 0.5, 0.8, 1.0})
        EXPECT_NEAR(returned(roughness), expectedReturn(roughness * roughness), 4e-3) << roughness;
}

TEST(Floor, TheSamePictureComesFromAnyNumberOfThreads) {
    FloorDesc floor = wideFloor();
    floor.roughness = 0.4;
    reference::World world;
    ASSERT_TRUE(makeWorld(floor, true, world));
    reference::FrameDesc desc = tests::smallFrame();
    desc.samples = 4;
    desc.threads = 1;
    const Picture one = tests::traced(world, desc).color;
    desc.threads = 3;
    EXPECT_EQ(tests::traced(world, desc).color.rgba, one.rgba);
}

} // namespace
