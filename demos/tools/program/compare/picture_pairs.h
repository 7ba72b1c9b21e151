// The pictures of two folders, side by side.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/scene.h"

namespace demos {

struct PairOfFiles {
    bool inReference = false, inTest = false;
    std::string problem; ///< why one of them cannot be read: known without opening it
};

/// By name within the folder, folders of theirs too; sorted. What is no PNG, EXR or HDR by its name, or is
/// a mask, is left out. The references' folder need not be there yet.
using PicturePairs = std::map<std::filesystem::path, PairOfFiles>;

PicturePairs picturePairs(const std::filesystem::path& reference, const std::filesystem::path& test);

bool isPictureName(const std::filesystem::path& file);

} // namespace demos
