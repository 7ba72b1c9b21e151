// What the command line calls the outputs of a frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/host.h"

namespace demos {

/// Null with `error` set, in which `option` is what the line calls it.
std::optional<Aov> parseAov(const std::string& option, const std::string& text, Error& error);
std::vector<std::string_view> aovNames();

} // namespace demos
