// Says what the files of a scene's meshes hold and its pictures do not show.
#pragma once

#include "scene/scene.h"

namespace demos {

/// A line to stderr for each of Host::leftOut(); with `strict`, false with `error` set where there is any.
bool sayLeftOut(const std::vector<std::string>& leftOut, const Scene& scene, bool strict, Error& error);

} // namespace demos
