#include "scene/reading/places.h"

#include <algorithm>
#include <sstream>

namespace demos::reading {

std::string join(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string quote(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array_of_tables()) return "an array of tables";
    std::ostringstream stream;
    node.visit([&stream](const auto& value) { stream << value; });
    constexpr size_t longestValue = 60;
    std::string text = stream.str();
    std::replace(text.begin(), text.end(), '\n', ' ');
    if (text.size() > longestValue) text.replace(longestValue, std::string::npos, "...");
    return text;
}

bool isOverride(const toml::node& node) {
    const toml::source_region& source = node.source();
    return source.path && source.path->starts_with(overrideMark);
}

std::string place(const toml::source_region& source, const std::string& file) {
    if (!source.path || source.path->empty()) return file;
    if (source.path->starts_with(overrideMark)) return *source.path;
    return *source.path + ":" + std::to_string(source.begin.line);
}

std::string place(const toml::node& node, const std::string& file) {
    return place(node.source(), file);
}

} // namespace demos::reading
