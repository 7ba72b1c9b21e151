// A camera that flies. CPU only.
#pragma once

#include "scene/scene.h"

namespace demos {

/// What is held down while a frame passes, and how the mouse moved in it.
struct FlyInput {
    double right = 0, up = 0, forward = 0;  ///< -1 to 1; up is the world's, the others the camera's
    double turnRightPx = 0, turnDownPx = 0; ///< of the mouse, while it looks around
    bool fast = false;
};

inline bool moves(const FlyInput& input) {
    return input.right != 0 || input.up != 0 || input.forward != 0 || input.turnRightPx != 0 ||
           input.turnDownPx != 0;
}

constexpr double flySpeedMps = 4, fastFlySpeedMps = 24;
constexpr double flyTurnDegPerPx = 0.15;
constexpr double flySteepestDeg = 89; ///< above or below the horizon

/// Moves and turns the camera; what no input touches keeps its bits, so that a camera left alone stays the
/// scene's own.
void fly(CameraDesc& camera, const FlyInput& input, double seconds);

} // namespace demos
