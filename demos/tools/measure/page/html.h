// What the pages of reports share.
#pragma once

#include <string>

namespace demos {

/// Text as HTML and SVG show it, whatever it holds; '@' too, which the templates' names to fill in begin
/// with.
std::string escaped(const std::string& text);

} // namespace demos
