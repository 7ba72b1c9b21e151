#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace demos {

/// Writes text whole or not at all.
bool writeText(const std::filesystem::path& file, const std::string& text, Error& error);

} // namespace demos
