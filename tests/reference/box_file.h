// Boxes as a file that a scene can name.
#pragma once

#include <filesystem>
#include <string>

#include "tests/gpu/traced_scene.h"

namespace tests {

/// glTF in the folder for tests: rough, of one albedo.
std::filesystem::path writeBoxes(const std::string& name, const std::vector<Box>& boxes, double albedo);

} // namespace tests
