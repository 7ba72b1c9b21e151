// The scenes that come with the program. Wants SEAGLASS_SCENES defined.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace tests {

/// Their files, by name.
inline std::vector<std::filesystem::path> demoScenes() {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(SEAGLASS_SCENES))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

} // namespace tests
