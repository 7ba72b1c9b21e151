// The scenes that come with the program. Wants SEAGLASS_SCENES defined.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace tests {

inline std::filesystem::path demoScene(const std::string& name) {
    return std::filesystem::path(SEAGLASS_SCENES) / (name + ".toml");
}
inline std::filesystem::path demoTexture(const char* name) {
    return std::filesystem::path(SEAGLASS_SCENES) / "../../textures" / name;
}

/// Their files, by name.
inline std::vector<std::filesystem::path> demoScenes() {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(SEAGLASS_SCENES))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

} // namespace tests
