#pragma once

#include <string>
#include <vector>

#include "scene/reading/toml.h"
#include "scene/scene.h"

namespace demos::reading {

/// Puts --set into the parsed file, before anything is checked. `notes` gets what is said of former keys.
bool applyOverrides(toml::table& root, const std::vector<std::string>& assignments,
                    std::vector<std::string>& notes, Error& error);

} // namespace demos::reading
