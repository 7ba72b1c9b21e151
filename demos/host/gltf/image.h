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

/// What it is, its first bytes say. False with a `problem` where it is of another kind, broken, over 8192
/// pixels wide or high, or over `mostPixels`: then none is decoded. `out` has its size once that is known.
bool decodeImage(std::span<const uint8_t> bytes, uint64_t mostPixels, Pixels& out, std::string& problem);

} // namespace demos::gltf
