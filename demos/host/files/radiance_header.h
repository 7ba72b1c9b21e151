// What the header of a Radiance HDR says of its pixels (Ward, "Radiance File Formats"). Read here because
// OpenImageIO keeps one of several EXPOSURE lines, no COLORCORR, and confuses two of the eight orientations.
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "scene/surroundings.h"

namespace demos {

struct RadianceHeader {
    std::array<double, 3> scale{1, 1, 1}; ///< that stored values were multiplied by: EXPOSURE and COLORCORR
    double pixelAspect = 1;               ///< width of a pixel over its height
    std::optional<std::array<double, 8>> primaries; ///< x and y of red, green, blue and white
    int orientation = 1;                            ///< as TIFF's tag of that name
};

/// Null without `error` when the file is no Radiance HDR; with it when it is one of what is not read: XYZ, or
/// gamma-corrected.
std::optional<RadianceHeader> readRadianceHeader(const std::filesystem::path& file, Error& error);

} // namespace demos
