#include "demos/tools/view/fly_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using demos::CameraDesc;
using demos::FlyInput;
using demos::Vec3;

constexpr double near = 1e-12;

void expectNear(const Vec3& actual, const Vec3& expected) {
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], near) << "component " << i;
}

CameraDesc towardsMinusZ() {
    CameraDesc camera;
    camera.positionM = {1, 2, 3};
    camera.targetM = {1, 2, -7};
    return camera;
}

CameraDesc flown(const FlyInput& input, double seconds) {
    CameraDesc camera = towardsMinusZ();
    demos::fly(camera, input, seconds);
    return camera;
}

TEST(FlyCamera, LeftAloneKeepsItsBits) {
    CameraDesc camera;
    camera.positionM = {0.1, 2.3, 24.7};
    camera.targetM = {-2.5, 2.1, -10.3};
    const CameraDesc before = camera;
    demos::fly(camera, {}, 0.7);
    EXPECT_EQ(camera.positionM, before.positionM);
    EXPECT_EQ(camera.targetM, before.targetM);
}

TEST(FlyCamera, MovesAlongItsOwnAxes) {
    const double way = demos::flySpeedMps * 0.5;
    expectNear(flown({.forward = 1}, 0.5).positionM, {1, 2, 3 - way});
    expectNear(flown({.forward = 1}, 0.5).targetM, {1, 2, -7 - way});
    expectNear(flown({.right = 1}, 0.5).positionM, {1 + way, 2, 3});
    expectNear(flown({.up = -1}, 0.5).positionM, {1, 2 - way, 3});
}

TEST(FlyCamera, FliesWhereItLooksButRisesWithTheWorld) {
    CameraDesc camera = towardsMinusZ();
    camera.targetM = {1, 2 - 10, 3 - 10}; // 45 degrees down
    CameraDesc risen = camera;
    demos::fly(camera, {.forward = 1}, 1);
    const double way = demos::flySpeedMps / std::numbers::sqrt2;
    expectNear(camera.positionM, {1, 2 - way, 3 - way});
    demos::fly(risen, {.up = 1}, 1);
    expectNear(risen.positionM, {1, 2 + demos::flySpeedMps, 3});
}

TEST(FlyCamera, TwoKeysAreNoFasterThanOneAndShiftIsFaster) {
    const double way = demos::flySpeedMps / std::numbers::sqrt2;
    expectNear(flown({.right = 1, .forward = 1}, 1).positionM, {1 + way, 2, 3 - way});
    expectNear(flown({.forward = 1, .fast = true}, 1).positionM, {1, 2, 3 - demos::fastFlySpeedMps});
}

TEST(FlyCamera, TheMouseTurnsItAboutItsEye) {
    const double px = 90 / demos::flyTurnDegPerPx;
    const CameraDesc right = flown({.turnRightPx = px}, 0.1);
    expectNear(right.positionM, {1, 2, 3});
    expectNear(right.targetM, {11, 2, 3});
    const CameraDesc down = flown({.turnDownPx = 30 / demos::flyTurnDegPerPx}, 0.1);
    expectNear(down.targetM, {1, 2 - 5, 3 - 10 * std::cos(std::numbers::pi / 6)});
}

TEST(FlyCamera, NeverTurnsOverItsHead) {
    const CameraDesc down = flown({.turnDownPx = 1e4}, 0.1);
    const double steepest = demos::flySteepestDeg * std::numbers::pi / 180;
    expectNear(down.targetM, {1, 2 - 10 * std::sin(steepest), 3 - 10 * std::cos(steepest)});
}

} // namespace
