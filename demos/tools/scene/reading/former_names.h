// Keys of earlier versions in a scene file, and in --set.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/fields.h"
#include "scene/former_keys.h"
#include "scene/reading/toml.h"

namespace demos::reading {

std::string calledNow(const std::string& where, const std::string& path, std::string_view key,
                      std::string_view now);
std::string isGone(const std::string& where, const std::string& path, const GoneKey& gone);

/// Gives the file's former keys their present names, but where both are there, and drops those that went.
void renameFormer(toml::table& table, const Section& section, const std::string& path,
                  const std::string& file, std::vector<std::string>& notes);

} // namespace demos::reading
