// The bytes that a URI within a glTF file stands for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace demos::gltf {

/// Of a data URI, or of a file below `folder`: its name may be percent-encoded or not, and may have
/// backslashes for slashes, as exporters write it. False with a `problem` that names it.
bool readUri(const std::filesystem::path& folder, const std::string& uri, uint64_t most,
             std::vector<uint8_t>& out, std::string& problem);

} // namespace demos::gltf
