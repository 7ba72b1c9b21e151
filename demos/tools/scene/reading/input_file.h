// Files that are read. Whatever a name stands for, nothing waits for it: a pipe would keep a program for
// ever.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace demos {

/// What a name stands for that is no file, such as "is a folder" or "is a pipe"; empty for a file, and for
/// nothing yet.
std::string noFile(const std::filesystem::path& file);

/// Why a file cannot be read, such as "no such file", "is a folder" or "is a link to nowhere"; empty: it can
/// be.
std::string unreadable(const std::filesystem::path& file);

/// All of a file of `most` bytes at most; false with what is wrong with it.
bool readWhole(const std::filesystem::path& file, uint64_t most, std::string& out, std::string& problem);
bool readWhole(const std::filesystem::path& file, uint64_t most, std::vector<uint8_t>& out,
               std::string& problem);

} // namespace demos
