#include "scene/reading/reader.h"

#include <algorithm>
#include <bit>
#include <system_error>

#include "scene/input_limits.h"
#include "scene/reading/input_file.h"
#include "scene/reading/nearest_path.h"
#include "scene/reading/places.h"

namespace demos::reading {

namespace fs = std::filesystem;

namespace {

bool isKnown(const Section& section, std::string_view key) {
    return std::any_of(section.fields.begin(), section.fields.end(),
                       [key](const Field& field) { return field.key == key; }) ||
           std::any_of(section.children.begin(), section.children.end(),
                       [key](const Child& child) { return child.section->key == key; });
}

std::string heading(const Child& child, const std::string& path) {
    return child.repeated ? "[[" + path + "]]" : "[" + path + "]";
}

/// Every range is finite, so that NaN and infinity are in none.
bool inRange(const Field& field, double value) {
    if (field.rule == Rule::zeroOrRange && value == 0) return true;
    if (field.rule == Rule::positive && value == field.least) return false;
    return field.least <= value && value <= field.most;
}

bool convert(const toml::node& node, const Field& field, double& out) {
    // value<double>() has none for a whole number that no double is.
    if (node.is_integer())
        out = static_cast<double>(node.as_integer()->get());
    else if (node.is_floating_point())
        out = node.as_floating_point()->get();
    else
        return false;
    return inRange(field, out);
}

template<size_t count>
bool convert(const toml::node& node, const Field& field, std::array<double, count>& out) {
    const toml::array* numbers = node.as_array();
    if (!numbers || numbers->size() != out.size()) return false;
    for (size_t i = 0; i < out.size(); ++i) {
        if (!convert((*numbers)[i], field, out[i])) return false;
    }
    return true;
}

bool convert(const toml::node& node, const Field& field, std::vector<Vec2>& out) {
    const toml::array* pairs = node.as_array();
    if (!pairs) return false;
    out.resize(pairs->size());
    for (size_t i = 0; i < out.size(); ++i) {
        if (!convert((*pairs)[i], field, out[i])) return false;
    }
    return true;
}

bool convert(const toml::node& node, const Field& field, uint64_t& out) {
    const auto* integer = node.as_integer();
    if (!integer || integer->get() < 0) return false;
    out = static_cast<uint64_t>(integer->get());
    return inRange(field, static_cast<double>(out));
}

bool convert(const toml::node& node, const Field& field, uint32_t& out) {
    uint64_t wide = 0;
    if (!convert(node, field, wide)) return false;
    out = static_cast<uint32_t>(wide);
    if (field.rule == Rule::powerOfTwo) return std::has_single_bit(out);
    return true;
}

bool convert(const toml::node& node, const Field&, bool& out) {
    if (!node.is_boolean()) return false;
    out = node.as_boolean()->get();
    return true;
}

bool convert(const toml::node& node, const Field& field, std::string& out) {
    if (!node.is_string()) return false;
    out = node.as_string()->get();
    if (field.rule == Rule::identifier) {
        return !out.empty() && out.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                     "0123456789_-") == out.npos;
    }
    return field.choices.empty() ||
           std::find(field.choices.begin(), field.choices.end(), out) != field.choices.end();
}

bool convert(const toml::node& node, const Field&, fs::path& out) {
    if (!node.is_string() || node.as_string()->get().empty()) return false;
    out = node.as_string()->get();
    return true;
}

template<class Value>
bool convertTo(const toml::node& node, const Field& field, const Setting& out) {
    Value value{};
    if (!convert(node, field, value)) return false;
    out.set(static_cast<double>(value));
    return true;
}

bool choose(const toml::node& node, const Field& field, const Setting& out) {
    std::string word;
    if (!convert(node, field, word)) return false;
    const auto index = std::ranges::find(field.choices, word) - field.choices.begin();
    out.set(out.field->low + static_cast<double>(index));
    return true;
}

bool convert(const toml::node& node, const Field& field, const Setting& out) {
    switch (out.field->type) {
    case seaglass::FieldType::boolean:
        return convertTo<bool>(node, field, out);
    case seaglass::FieldType::integer:
        return convertTo<uint32_t>(node, field, out);
    case seaglass::FieldType::choice:
        return choose(node, field, out);
    default:
        return convertTo<double>(node, field, out);
    }
}

template<class Value>
bool convert(const toml::node& node, const Field& field, Value* out) {
    return convert(node, field, *out);
}

} // namespace

bool Reader::read(const toml::table& table, const Section& section, void* owner, const std::string& path,
                  const std::string& schemaPath) {
    for (const auto& [key, node] : table) {
        if (!isKnown(section, key.str())) return unknown(node, key, path, schemaPath);
    }
    for (const Field& field : section.fields) {
        const toml::node* node = table.get(field.key);
        if (!node && field.required) return missing(table, field, owner, path);
        if (node && !readField(*node, field, field.target(owner), join(path, field.key))) return false;
    }
    for (const Child& child : section.children) {
        if (!readChild(table, child, owner, path, schemaPath)) return false;
    }
    return true;
}

bool Reader::fail(const std::string& where, const std::string& what) {
    error_.text = where + ": " + what;
    return false;
}

bool Reader::unknown(const toml::node& node, const toml::key& key, const std::string& path,
                     const std::string& schemaPath) {
    const toml::source_region& source = key.source().path ? key.source() : node.source();
    return fail(place(source, file_), join(path, key.str()) + " is not a known key, the nearest is " +
                                          nearestPath(join(schemaPath, key.str())));
}

bool Reader::missing(const toml::table& table, const Field& field, void* owner, const std::string& path) {
    return fail(place(table, file_),
                join(path, field.key) + " is missing, expected " + expectation(field, field.target(owner)));
}

bool Reader::wrong(const toml::node& node, const std::string& path, const std::string& expected) {
    return fail(place(node, file_), path + " is " + quote(node) + ", expected " + expected);
}

bool Reader::readChild(const toml::table& parent, const Child& child, void* owner, const std::string& path,
                       const std::string& schemaPath) {
    const std::string_view key = child.section->key;
    const std::string childPath = join(path, key), childSchemaPath = join(schemaPath, key);
    const toml::node* node = parent.get(key);
    if (!node) {
        if (!child.required) return true;
        return fail(file_, childPath + " is missing, expected " + heading(child, childSchemaPath));
    }
    if (!child.repeated) {
        const toml::table* table = node->as_table();
        if (!table) return wrong(*node, childPath, "a table: " + heading(child, childSchemaPath));
        return read(*table, *child.section, child.access.open(owner), childPath, childSchemaPath);
    }
    const toml::array* tables = node->as_array();
    if (!tables) return wrong(*node, childPath, "an array of tables: " + heading(child, childSchemaPath));
    if (tables->empty() && child.required) {
        return wrong(*node, childPath, "at least one: " + heading(child, childSchemaPath));
    }
    if (tables->size() > limits::sceneTables)
        return fail(place(*node, file_),
                    childPath + " has " + std::to_string(tables->size()) + " tables, expected at most 256");
    for (size_t i = 0; i < tables->size(); ++i) {
        const toml::node& element = (*tables)[i];
        const std::string elementPath = join(childPath, std::to_string(i));
        if (!element.is_table())
            return wrong(element, elementPath, "a table: " + heading(child, childSchemaPath));
        if (!read(*element.as_table(), *child.section, child.access.open(owner), elementPath,
                  childSchemaPath))
            return false;
    }
    return true;
}

bool Reader::readField(const toml::node& node, const Field& field, const Target& target,
                       const std::string& path) {
    const bool good = std::visit([&](auto value) { return convert(node, field, value); }, target);
    if (!good) return wrong(node, path, expectation(field, target));
    if (const auto* file = std::get_if<fs::path*>(&target)) return findFile(node, **file, field, path);
    return true;
}

bool Reader::findFile(const toml::node& node, fs::path& file, const Field& field, const std::string& path) {
    file = (folder_ / file).lexically_normal();
    const std::string why = unreadable(file);
    return why.empty() ||
           wrong(node, path, "a " + std::string(field.about) + "; " + file.string() + ": " + why);
}

} // namespace demos::reading
