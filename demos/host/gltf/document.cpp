#include "host/gltf/document.h"

#include <algorithm>
#include <exception>
#include <string_view>

#include "scene/input_limits.h"
#include "scene/reading/input_file.h"

namespace demos::gltf {
namespace {

constexpr const char* extensionsRead[] = {
    "EXT_mesh_gpu_instancing", "EXT_texture_webp",       "KHR_materials_emissive_strength",
    "KHR_materials_unlit",     "KHR_materials_variants", "KHR_materials_pbrSpecularGlossiness",
    "KHR_mesh_quantization",   "KHR_texture_transform",  "KHR_node_visibility",
    "KHR_lights_punctual", // said where it is met
};

std::string_view asText(const std::vector<uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

uint32_t wordAt(const std::vector<uint8_t>& bytes, size_t at) {
    return bytes[at] | uint32_t{bytes[at + 1]} << 8 | uint32_t{bytes[at + 2]} << 16 |
           uint32_t{bytes[at + 3]} << 24;
}

/// Takes a GLB apart (glTF 2.0, 4.4). Chunks of other kinds are passed over.
bool splitBinary(std::vector<uint8_t>&& bytes, std::string& text, std::vector<uint8_t>& bin,
                 std::string& problem) {
    constexpr uint32_t json = 0x4e4f534a, binary = 0x004e4942;
    const auto fail = [&](const std::string& what) {
        problem = what;
        return false;
    };
    if (bytes.size() < 20) return fail("is a binary glTF file cut off within its header");
    if (const uint32_t version = wordAt(bytes, 4); version != 2)
        return fail("is binary glTF " + std::to_string(version) + ", expected 2");
    const size_t length = wordAt(bytes, 8);
    if (length > bytes.size())
        return fail("is cut off: it has " + std::to_string(bytes.size()) + " bytes and says " +
                    std::to_string(length));
    bool hasText = false, hasBin = false;
    for (size_t at = 12; at + 8 <= length;) {
        const size_t size = wordAt(bytes, at);
        const uint32_t kind = wordAt(bytes, at + 4);
        at += 8;
        if (size > length - at) return fail("has a chunk that reaches past its end");
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        const auto to = from + static_cast<std::ptrdiff_t>(size);
        if (kind == json && !hasText) {
            text.assign(from, to);
            hasText = true;
        } else if (kind == binary && !hasBin) {
            bin.assign(from, to);
            hasBin = true;
        }
        at += size;
    }
    return hasText || fail("is a binary glTF file without its JSON");
}

/// Before a parser makes a tree of it, whose parts are far larger than what they are written with.
bool isModest(std::string_view text, std::string& problem) {
    if (text.size() > limits::gltfTextBytes) {
        problem = "has over 256 MiB of JSON; GLB holds its bytes apart";
        return false;
    }
    size_t depth = 0, deepest = 0, values = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            deepest = std::max(deepest, ++depth);
            ++values;
        } else if (c == '}' || c == ']') {
            depth -= depth > 0 ? 1 : 0;
        } else if (c == ',') {
            ++values;
        }
    }
    if (deepest > limits::gltfNesting) problem = "nests its JSON over 64 levels deep";
    if (values > limits::gltfValues) problem = "has over 2 million values in its JSON";
    return deepest <= limits::gltfNesting && values <= limits::gltfValues;
}

/// The parser's own words without its name and without what it quotes of the file.
std::string reasonOf(const std::exception& thrown) {
    std::string reason = thrown.what();
    if (const size_t name = reason.find("] "); name != std::string::npos) reason.erase(0, name + 2);
    return reason.substr(0, reason.find("; last read"));
}

bool parse(std::string_view text, Json& out, std::string& problem) {
    if (!isModest(text, problem)) return false;
    try {
        out = Json::parse(text.begin(), text.end());
    } catch (const Json::exception& thrown) {
        problem = "is no glTF file: " + reasonOf(thrown);
        return false;
    }
    if (out.is_object()) return true;
    problem = "is no glTF file: its JSON is no object";
    return false;
}

bool isRead(const Json& root, std::string& problem) {
    const Json& asset = member(root, "asset");
    const std::string &version = textOf(asset, "version"), &least = textOf(asset, "minVersion");
    if (version.empty()) {
        problem = "has no asset.version, expected 2.0";
        return false;
    }
    if (!version.starts_with("2.") && version != "2") {
        problem = "is glTF " + quoted(version) + ", expected 2.0";
        return false;
    }
    if (!least.empty() && least != "2.0") {
        problem = "asks for glTF " + quoted(least) + ", expected 2.0";
        return false;
    }
    for (const Json& required : member(root, "extensionsRequired")) {
        const std::string name = required.is_string() ? required.get<std::string>() : "";
        if (std::find(std::begin(extensionsRead), std::end(extensionsRead), name) != std::end(extensionsRead))
            continue;
        problem = "requires the extension " + quoted(name) + ", which is not read";
        return false;
    }
    return true;
}

} // namespace

size_t Document::count(const char* array) const {
    const Json& found = member(root, array);
    return found.is_array() ? found.size() : 0;
}

std::optional<Document> readDocument(const std::filesystem::path& file, Error& error) {
    Document document;
    document.folder = file.parent_path();
    std::string problem;
    std::vector<uint8_t> bytes;
    const auto read = [&] {
        if (!readWhole(file, limits::gltfFileBytes, bytes, problem)) return false;
        document.bytes = bytes.size();
        if (!asText(bytes).starts_with("glTF")) return parse(asText(bytes), document.root, problem);
        std::string text;
        return splitBinary(std::move(bytes), text, document.bin, problem) &&
               parse(text, document.root, problem);
    };
    if (read() && isRead(document.root, problem)) return document;
    error.text = problem;
    return std::nullopt;
}

} // namespace demos::gltf
