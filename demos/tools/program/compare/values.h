// Numbers and sizes of the command line, checked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace demos {

constexpr uint32_t longestSide = 16384; ///< of a picture, in pixels
constexpr uint32_t mostSamples = 65536; ///< of each of its pixels

struct Size {
    uint32_t width = 1280, height = 720;
};

/// `expected` is the error's end: "a number of seconds, 0 to 10".
std::optional<double> parseNumber(const std::string& option, const std::string& text, double least,
                                  double most, std::string_view expected, Error& error);
std::optional<uint32_t> parseCount(const std::string& option, const std::string& text, uint32_t most,
                                   Error& error);
/// "1280x720", each side 1 to 16384.
std::optional<Size> parseSize(const std::string& option, const std::string& text, Error& error);
/// Of --supersample: 1 to 4, and a picture of `size` times that is no larger than any may be.
std::optional<uint32_t> parseSupersample(const std::string& text, const Size& size, Error& error);

} // namespace demos
