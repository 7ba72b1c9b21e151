// What the chunks of a PNG say of its colours (PNG, third edition, 4.3). Read here because OpenImageIO leaves
// out cHRM and cICP and rounds gAMA.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/files/color/primaries.h"

namespace demos {

struct PngColor {
    double gamma = 0; ///< of what is stored, light to that power; 0: it is by sRGB's curve
    std::optional<Primaries> primaries;
    std::string unread;                 ///< what says something else, which is not followed; empty: nothing
    std::optional<std::string> profile; ///< an ICC profile's name in the file; that says all
};

/// Of a file that is a PNG. What is missing or broken says nothing.
PngColor readPngColor(const std::filesystem::path& file);

} // namespace demos
