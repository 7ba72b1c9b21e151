// What PNG and JPEG files unpack beside their pixels, counted before a library does it: compressed texts that
// nobody reads, and scans of which each goes over the whole picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace demos {

/// What is wrong with a PNG or JPEG, in words that do not name it; empty when nothing is, and for other
/// kinds.
std::string unpackingProblem(std::span<const uint8_t> bytes);
std::string unpackingProblem(const std::filesystem::path& file);

} // namespace demos
