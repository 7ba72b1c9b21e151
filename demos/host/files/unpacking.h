// What PNG and JPEG files hold beside their pixels and colours, cut out before a library sees it: texts and
// tags, which it unpacks, descends into and puts together many times over, and nobody reads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace demos {

/// A PNG or JPEG without its texts and tags, but for a JPEG's first Exif, which may turn it. Other kinds are
/// as they were.
struct BarePicture {
    std::vector<uint8_t> bytes;
    /// Of a JPEG's largest frame, 0 of others: libjpeg may allocate all of it before it says how large it is.
    uint32_t width = 0, height = 0;
};

/// Null with a `problem`, in words that do not name the file, where it asks for far more than it holds.
std::optional<BarePicture> barePicture(std::span<const uint8_t> bytes, std::string& problem);

} // namespace demos
