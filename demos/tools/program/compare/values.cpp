#include "program/compare/values.h"

#include <algorithm>
#include <cmath>

#include "scene/parse_all.h"

namespace demos {

namespace {

std::nullopt_t fail(const std::string& option, const std::string& text, std::string_view expected,
                    Error& error) {
    error.text = option + " is '" + text + "', expected " + std::string(expected);
    return std::nullopt;
}

} // namespace

std::optional<double> parseNumber(const std::string& option, const std::string& text, double least,
                                  double most, std::string_view expected, Error& error) {
    const std::optional<double> value = parseAll<double>(text);
    if (value && std::isfinite(*value) && least <= *value && *value <= most) return value;
    return fail(option, text, expected, error);
}

std::optional<uint32_t> parseCount(const std::string& option, const std::string& text, uint32_t most,
                                   Error& error) {
    const std::optional<uint32_t> value = parseAll<uint32_t>(text);
    if (value && 1 <= *value && *value <= most) return value;
    return fail(option, text, "a whole number, 1 to " + std::to_string(most), error);
}

std::optional<Size> parseSize(const std::string& option, const std::string& text, Error& error) {
    const size_t cross = std::min(text.find('x'), text.size());
    const std::optional<uint32_t> width = parseAll<uint32_t>(std::string_view(text).substr(0, cross));
    const std::optional<uint32_t> height =
        parseAll<uint32_t>(std::string_view(text).substr(std::min(cross + 1, text.size())));
    const auto fits = [](std::optional<uint32_t> side) { return side && 1 <= *side && *side <= longestSide; };
    if (fits(width) && fits(height)) return Size{*width, *height};
    return fail(option, text, "WIDTHxHEIGHT, each 1 to " + std::to_string(longestSide), error);
}

std::optional<uint32_t> parseSupersample(const std::string& text, const Size& size, Error& error) {
    const std::string option = "--supersample";
    const std::optional<uint32_t> factor = parseCount(option, text, 4, error);
    if (!factor || std::max(size.width, size.height) * *factor <= longestSide) return factor;
    return fail(option, text, "no more than " + std::to_string(longestSide) + " pixels a side in all", error);
}

} // namespace demos
