// What the viewer shows, as plain data.
#pragma once

#include "host/host.h"
#include "scene/motion/motion.h"
#include "view/fly_camera.h"
#include "view/split.h"

namespace demos {

struct ViewState {
    Scene scene;
    CameraDesc camera;
    double timeS = 0;
    double timeScale = 1; ///< seconds of the waves to one
    bool paused = false;
    Aov aov = Aov::color;
    double whiteHeightM = 1; ///< shown as white where heights are
    bool panel = true;
    bool lens = false; ///< bloom and antialiasing, of colour in one picture
    std::optional<Split> split;
};

/// What passes from one frame to the next.
inline void advance(ViewState& state, const FlyInput& input, double seconds) {
    // Whoever flies leaves the camera's own path, from where that has come to.
    if (moves(input)) state.camera = cameraAt(state.camera, state.timeS);
    fly(state.camera, input, seconds);
    if (!state.paused) state.timeS += seconds * state.timeScale;
}

/// The outputs that the viewer can show: those whose picture needs nothing of the CPU.
constexpr bool isViewable(Aov aov) {
    return aov != Aov::depth && aov != Aov::reflectionSource;
}

} // namespace demos
