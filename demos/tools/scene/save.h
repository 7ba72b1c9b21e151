// Scenes back into files.
#pragma once

#include "scene/fields.h"

namespace demos {

/// A field's value, as TOML has it. Files are named as they are.
std::string valueText(const Field& field, void* owner);

/// TOML that loadScene() reads back as the same scene from a file in `folder`. Files are named from there.
/// Values that are the defaults are left out.
std::string sceneText(Scene scene, const std::filesystem::path& folder);

/// Writes that whole or not at all.
bool saveScene(const Scene& scene, const std::filesystem::path& file, Error& error);

} // namespace demos
