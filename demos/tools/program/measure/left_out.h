// Says what a scene has by former names, and what the files of its meshes hold and its pictures do not show.
#pragma once

#include "scene/scene.h"

namespace demos {

/// A line to stderr for each of Scene::notes and of Host::leftOut(); with `strict`, false with `error` set
/// where anything is left out.
bool sayLeftOut(const std::vector<std::string>& leftOut, const Scene& scene, bool strict, Error& error);

} // namespace demos
