#pragma once

#include <string_view>

namespace demos::reading {

/// Whether keys are as short as those of scenes: toml++ recurses into each part of a dotted one.
bool hasShortKeys(std::string_view text);

} // namespace demos::reading
