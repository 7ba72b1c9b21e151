#pragma once

#include "scene/scene.h"

namespace demos {

/// Null with `error` set when the scene has no camera of this name; an empty one takes its first, "random:7"
/// the seventh of random_camera.h.
std::optional<CameraDesc> chooseCamera(const Scene& scene, const std::string& name, Error& error);

} // namespace demos
