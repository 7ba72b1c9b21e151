// What a picture's file says of the picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace demos {

struct ImageWindow {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const ImageWindow&) const = default;
};

/// "60x40+0+20": its size, and where it begins.
std::string toText(const ImageWindow& window);

struct ImageHeader {
    uint32_t width = 0, height = 0; ///< of the display window, turned upright
    bool integer = false;           ///< values are 0..1, and display-encoded as a rule
    std::string encoding;           ///< what is said of their colours but sRGB, and what is made of it
    bool cubeMap = false;
    double pixelAspect = 1;    ///< width of a pixel over its height, as stored
    ImageWindow data, display; ///< as stored; outside of `data` a picture is black
    std::string layer;         ///< empty: the unnamed one
    std::vector<std::string> color,
        others; ///< channels: those of the picture's colour, and alpha and the rest
};

} // namespace demos
