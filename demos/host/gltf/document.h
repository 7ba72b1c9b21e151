// A glTF or GLB file as JSON and bytes. What it is, its first bytes say, not its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "host/gltf/json.h"

namespace demos::gltf {

struct Document {
    std::filesystem::path folder; ///< of the file, for what it refers to
    Json root;
    std::vector<uint8_t> bin; ///< of a GLB: what its first buffer holds
    uint64_t bytes = 0;       ///< of the whole file

    size_t count(const char* array) const;
    const Json& at(const char* array, size_t index) const { return member(root, array)[index]; }
};

/// Untrusted: size, nesting and number of values are capped before anything is made of them. Other versions
/// than 2 and extensions that are required and not read are errors.
std::optional<Document> readDocument(const std::filesystem::path& file, Error& error);

} // namespace demos::gltf
