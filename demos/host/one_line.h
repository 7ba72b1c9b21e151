// Texts of any bytes, as names of files and messages of libraries are.
#pragma once

#include <string>

namespace demos {

/// In UTF-8 and on one line, as terminals and XML want it: a space for the end of a line and for a tab, '?'
/// for other control characters and for what is no character.
std::string oneLine(const std::string& text);

} // namespace demos
