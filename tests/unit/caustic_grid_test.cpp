// Over which rows of a picture caustics are cast: those that may show what is below the horizon, and no more.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/cameras.h"
#include "water/below/caustics.h"

namespace {

using namespace seaglass;
using tests::Camera;

constexpr int height = 192;

CausticGrid gridOf(double pitchDegrees, double rollDegrees, double eyeHeight, uint32_t step = 1) {
    const double pitch = tests::radians(pitchDegrees);
    Camera camera;
    camera.eye = {0, eyeHeight, 0};
    camera.target = camera.eye + glm::dvec3(0, std::sin(pitch), std::cos(pitch));
    camera.rollDegrees = rollDegrees;
    camera.width = 320;
    camera.height = height;
    ViewGeometry view;
    EXPECT_STREQ(readCamera(tests::viewDesc(camera), view).text(), "");
    ShadingDesc shading;
    shading.causticStep = step;
    return causticGrid(shading, view, eyeHeight);
}

TEST(CausticGrid, EndsAtALevelHorizon) {
    const CausticGrid level = gridOf(0, 0, 2);
    EXPECT_NEAR(level.firstRow, height / 2, 2);
    EXPECT_EQ(level.endRow, height + level.margin);
    const CausticGrid coarse = gridOf(0, 0, 2, 4);
    EXPECT_NEAR(coarse.firstRow, height / 8, 2);
    EXPECT_EQ(coarse.endRow, (height + coarse.margin) / 4);
    const CausticGrid upsideDown = gridOf(0, 180, 2);
    EXPECT_EQ(upsideDown.firstRow, -upsideDown.margin);
    EXPECT_NEAR(upsideDown.endRow, height / 2, 2);
}

TEST(CausticGrid, HasAllRowsWhereEachMayShowTheBed) {
    for (const CausticGrid& grid : {gridOf(-80, 0, 2), gridOf(0, 90, 2), gridOf(30, 0, -1)}) {
        EXPECT_EQ(grid.firstRow, -grid.margin);
        EXPECT_EQ(grid.endRow, height + grid.margin);
    }
}

TEST(CausticGrid, HasARowOfTheViewWhereNoneDoes) {
    for (const double roll : {0.0, 180.0}) {
        const CausticGrid grid = gridOf(70, roll, 2);
        const int first = std::max(grid.firstRow, 0), end = std::min(grid.endRow, height);
        EXPECT_GE(end - first, 1) << roll;
        EXPECT_LE(end - first, 2) << roll;
    }
}

// By Snell's law: a small slope, along the sun's way and across it, turns a ray aside by so much on each
// metre down.
TEST(SunInWater, IsTurnedAsSnellSays) {
    constexpr double index = 1.333, slope = 1e-5;
    for (const double up : {1.0, 0.8, 0.4, 0.1}) {
        const glm::dvec3 toSun(std::sqrt(1 - up * up), up, 0);
        const auto aside = [&](const glm::dvec2& tilt) {
            const glm::dvec3 ray =
                glm::refract(-toSun, glm::normalize(glm::dvec3(-tilt.x, 1, -tilt.y)), 1 / index);
            return glm::dvec2(ray.x, ray.z) / -ray.y;
        };
        const SunInWater sun = sunInWater(toSun);
        const glm::dvec2 still = aside({0, 0});
        EXPECT_NEAR(glm::distance(aside({slope, 0}), still) / slope, sun.turnedAlong, 1e-3 * sun.turnedAlong)
            << up;
        EXPECT_NEAR(glm::distance(aside({0, slope}), still) / slope, sun.turnedAcross,
                    1e-3 * sun.turnedAcross)
            << up;
        EXPECT_NEAR(still.x, -sun.from.x / sun.from.y, 1e-9) << up;
    }
}

} // namespace
