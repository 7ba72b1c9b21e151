// The command that makes a reference, for messages.
#pragma once

#include <filesystem>
#include <string>

namespace demos {

/// "seaglass bless REFERENCE TEST WHAT", to be pasted into a shell whatever the names hold.
std::string blessing(const std::filesystem::path& reference, const std::filesystem::path& test,
                     const std::string& what);

} // namespace demos
