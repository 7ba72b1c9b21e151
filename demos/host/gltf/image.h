// An image of a glTF file: PNG or JPEG, or WebP where OpenImageIO has it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace demos::gltf {

struct Pixels {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
};

/// What it is, its first bytes say. False with a `problem` where it is of another kind, broken, or over 8192
/// pixels wide or high.
bool decodeImage(std::span<const uint8_t> bytes, Pixels& out, std::string& problem);

} // namespace demos::gltf
