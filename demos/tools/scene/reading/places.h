// What messages about a scene file name: keys, values, and the lines or --set that they come from.
#pragma once

#include <string>
#include <string_view>

#include "scene/reading/toml.h"

namespace demos::reading {

std::string join(const std::string& path, std::string_view key);
/// A value as it would be written, cut to fit on a line.
std::string quote(const toml::node& node);

/// An override's nodes carry its text as their source and no useful line.
constexpr std::string_view overrideMark = "--set ";
bool isOverride(const toml::node& node);

std::string place(const toml::source_region& source, const std::string& file);
std::string place(const toml::node& node, const std::string& file);

} // namespace demos::reading
