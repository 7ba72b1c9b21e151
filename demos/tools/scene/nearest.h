// Known words, as errors name them: all of them, or the nearest, for "did you mean".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

struct Error;

/// Damerau-Levenshtein distance (optimal string alignment), ASCII case ignored: how many letters to insert,
/// delete, replace or swap with their neighbour. Words longer than 64 letters are cut.
size_t editDistance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, the first of equals; empty when nothing is known.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& known);

/// "a, b or c".
std::string oneOf(std::span<const std::string_view> choices);

/// False with `error` set when the option's `word` is none of the known ones.
bool isOneOf(const std::string& option, const std::string& word, std::span<const std::string_view> known,
             Error& error);

} // namespace demos
