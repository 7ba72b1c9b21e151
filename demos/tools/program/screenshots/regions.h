// What of pictures is left out: rectangles of the command line, and masks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/host.h"
#include "metrics/compare.h"

namespace demos {

/// Pixels, from the upper left.
struct Region {
    uint32_t width = 0, height = 0, left = 0, top = 0;
};

/// "96x12+0+40": its size, and how far from the left and from the top.
std::optional<Region> parseRegion(const std::string& option, const std::string& text, Error& error);

struct LeftOut {
    std::vector<Region> regions;
    std::filesystem::path mask; ///< black is left out; empty: that beside the reference, if it is there
};

/// Whether a file is the mask of the picture beside it: color.mask.png of color.png and of color_0003.exr.
bool isMaskName(const std::filesystem::path& file);

/// For a picture of the reference's size; empty where nothing is left out. Null with `error` set when a
/// region is outside of it, or a mask cannot be read or has another size.
std::optional<Mask> maskOf(const LeftOut& leftOut, const std::filesystem::path& reference, uint32_t width,
                           uint32_t height, Error& error);

} // namespace demos
