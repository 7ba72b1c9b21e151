#include "host/gltf/json.h"

#include <algorithm>
#include <cmath>

#include "host/one_line.h"

namespace demos::gltf {
namespace {

const Json none;

bool fail(const std::string& where, const char* key, const std::string& expected, Error& error) {
    error.text = where + "." + key + " is wrong, expected " + expected;
    return false;
}

/// A whole number that a double holds exactly.
std::optional<size_t> wholeOf(const Json& value) {
    if (value.is_number_unsigned()) {
        const auto whole = value.get<uint64_t>();
        return whole < (uint64_t{1} << 53) ? std::optional<size_t>(whole) : std::nullopt;
    }
    if (!value.is_number_float()) return std::nullopt;
    const double number = value.get<double>();
    if (!(number >= 0 && number < 0x1p53) || number != std::floor(number)) return std::nullopt;
    return static_cast<size_t>(number);
}

} // namespace

std::string quoted(const std::string& text) {
    constexpr size_t most = 60;
    std::string shown = text.substr(0, most);
    // Not through the middle of a character.
    while (shown.size() < text.size() && !shown.empty() && (text[shown.size()] & 0xc0) == 0x80)
        shown.pop_back();
    shown = oneLine(shown);
    return "\"" + shown + (shown.size() < text.size() ? "...\"" : "\"");
}

std::string placeOf(const char* array, size_t index, const Json& object) {
    const std::string& name = textOf(object, "name");
    return std::string(array) + "[" + std::to_string(index) + "]" + (name.empty() ? "" : " " + quoted(name));
}

const Json& member(const Json& object, const char* key) {
    if (!object.is_object()) return none;
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

const Json& extension(const Json& object, const char* name) {
    return member(member(object, "extensions"), name);
}

bool isHarmless(const std::string& extension) {
    constexpr const char* beginnings[] = {"AGI_articulations",    "AGI_stk_metadata",
                                          "EXT_feature_metadata", "EXT_instance_features",
                                          "EXT_mesh_features",    "EXT_structural_",
                                          "KHR_animation_",       "KHR_audio",
                                          "KHR_interactivity",    "KHR_node_hover",
                                          "KHR_node_select",      "KHR_materials_variants",
                                          "KHR_physics_",         "KHR_xmp",
                                          "MSFT_audio_",          "MSFT_lod",
                                          "MSFT_packing_",        "MSFT_screencoverage"};
    return std::any_of(std::begin(beginnings), std::end(beginnings),
                       [&](const char* beginning) { return extension.starts_with(beginning); });
}

const std::string& textOf(const Json& object, const char* key) {
    static const std::string empty;
    const Json& value = member(object, key);
    return value.is_string() ? value.get_ref<const std::string&>() : empty;
}

bool isTrue(const Json& object, const char* key) {
    const Json& value = member(object, key);
    return value.is_boolean() && value.get<bool>();
}

std::optional<size_t> indexOf(const Json& value, size_t count) {
    const std::optional<size_t> index = wholeOf(value);
    return index && *index < count ? index : std::nullopt;
}

bool readIndex(const Json& object, const char* key, size_t count, const std::string& where,
               std::optional<size_t>& out, Error& error) {
    const Json& value = member(object, key);
    if (value.is_null()) return true;
    const std::optional<size_t> index = indexOf(value, count);
    if (!index) {
        const std::string some = count == 1 ? "0, the only one" : "0 to " + std::to_string(count - 1);
        return fail(where, key, count == 0 ? "none, since the file has none" : some, error);
    }
    out = index;
    return true;
}

bool readCount(const Json& object, const char* key, const std::string& where, size_t& out, Error& error) {
    const Json& value = member(object, key);
    if (value.is_null()) return true;
    const std::optional<size_t> count = wholeOf(value);
    if (!count) return fail(where, key, "a whole number of 0 or more", error);
    out = *count;
    return true;
}

bool readNumbers(const Json& object, const char* key, const std::string& where, std::span<double> out,
                 Error& error) {
    const Json& value = member(object, key);
    if (value.is_null()) return true;
    if (out.size() == 1 && value.is_number()) {
        out[0] = value.get<double>();
        return true;
    }
    const std::string expected = out.size() == 1 ? "a number" : std::to_string(out.size()) + " numbers";
    if (!value.is_array() || value.size() != out.size()) return fail(where, key, expected, error);
    for (size_t i = 0; i < out.size(); ++i) {
        if (!value[i].is_number()) return fail(where, key, expected, error);
        out[i] = value[i].get<double>();
    }
    return true;
}

} // namespace demos::gltf
