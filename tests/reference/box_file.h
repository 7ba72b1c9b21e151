// Boxes as a file that a scene can name.
#pragma once

#include <filesystem>
#include <string>

#include "tests/gpu/rig/traced_scene.h"

namespace tests {

/// glTF in the folder for tests, under the name of the running test and `suffix`, of one albedo.
std::filesystem::path writeBoxes(const std::string& suffix, const std::vector<Box>& boxes, double albedo,
                                 double roughness = 1);

} // namespace tests
