// Scenes back into files.
#pragma once

#include "scene/scene.h"

namespace demos {

/// TOML that loadScene() reads back as the same scene from a file in `folder`. Files are named from there.
/// Values that are the defaults are left out.
std::string sceneText(Scene scene, const std::filesystem::path& folder);

/// Writes that whole or not at all.
bool saveScene(const Scene& scene, const std::filesystem::path& file, Error& error);

} // namespace demos
