// The techniques that are measured: a later one is a row of the table in technique.cpp and no more.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace demos::measure {

/// What a technique says of the reflection at a pixel of water.
enum class Answers {
    sky,     ///< the sky, everywhere
    classes, ///< what Aov::reflectionClass shows
};

struct Technique {
    std::string name, quality;
    std::vector<std::string> overrides; ///< of the scene, as --set takes them
    Answers answers = Answers::classes;
    bool part = true; ///< whether the water has a reflection at all; without, it mirrors the sky as well
};

std::span<const Technique> techniques();

/// A scene as one technique draws it.
struct Variant {
    const Technique* technique = nullptr;
    std::string file; ///< as it was named
    Scene scene;
};

/// One for each technique; all else is as the file has it. Null with `error` set when the file cannot be read
/// or has no water.
std::optional<std::vector<Variant>> variantsOf(const std::filesystem::path& file, Error& error);

} // namespace demos::measure
