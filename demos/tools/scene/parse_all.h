#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace demos {

/// A number that is all of the text; null if it is none, or fits no T.
template<class T>
std::optional<T> parseAll(std::string_view text) {
    T value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

} // namespace demos
