// A scene's camera, for tests that name one it has; another name fails the test, by an exception.
#pragma once

#include <stdexcept>
#include <string>

#include "scene/camera_choice.h"

namespace tests {

inline demos::CameraDesc cameraOf(const demos::Scene& scene, const std::string& name) {
    demos::Error error;
    const auto camera = demos::chooseCamera(scene, name, error);
    if (!camera) throw std::runtime_error(error.text);
    return *camera;
}

} // namespace tests
