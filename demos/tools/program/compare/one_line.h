// Texts of any bytes, as names of files and messages of libraries are.
#pragma once

#include <string>

namespace demos {

/// In UTF-8 and on one line: a space for control characters, '?' for what is no character.
std::string oneLine(const std::string& text);

} // namespace demos
