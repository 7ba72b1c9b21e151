#include "host/files/unpacking.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

#include "host/big_endian.h"
#include "scene/input_limits.h"

namespace demos {
namespace {

struct PngChunks {
    size_t texts = 0;  ///< bytes of those that are compressed (PNG, third edition, 11.3.3)
    size_t beyond = 0; ///< of one that is said to hold more than the file has: libpng allocates them
};

PngChunks chunksOf(std::string_view png) {
    PngChunks out;
    for (size_t at = 8; at + 8 <= png.size();) {
        const size_t length = bigEndianAt(png, at);
        const std::string_view kind = png.substr(at + 4, 4);
        at += 8;
        if (kind == "IEND") break;
        if (length > png.size() - at) {
            if (kind != "IDAT") out.beyond = length; // those are read piece by piece
            break;
        }
        const std::string_view data = png.substr(at, length);
        const size_t keyword = std::min(data.find('\0'), data.size());
        const bool flagged = keyword + 1 < data.size() && data[keyword + 1] != 0;
        if (kind == "zTXt" || (kind == "iTXt" && flagged)) out.texts += length;
        at += std::min(length + 4, png.size() - at); // and its checksum
    }
    return out;
}

/// Segments are passed over, so that a thumbnail's scans do not count (ITU-T T.81, annex B).
size_t scansOf(std::string_view jpeg) {
    constexpr unsigned char startOfScan = 0xda, endOfImage = 0xd9;
    size_t scans = 0;
    for (size_t at = 2; at + 4 <= jpeg.size();) {
        const auto byte = [&](size_t i) { return static_cast<unsigned char>(jpeg[at + i]); };
        const unsigned char marker = byte(1);
        if (byte(0) != 0xff || marker == 0xff || marker == 0 || (marker >= 0xd0 && marker <= 0xd8)) {
            // Within a scan, where the next 0xff is what may end it.
            at = std::min(jpeg.find('\xff', at + 1), jpeg.size());
            continue;
        }
        if (marker == endOfImage) break;
        scans += marker == startOfScan ? 1 : 0;
        at += 2 + size_t{bigEndianAt(jpeg, at + 2, 2)};
    }
    return scans;
}

} // namespace

std::string unpackingProblem(std::span<const uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const PngChunks chunks = text.starts_with("\x89PNG") ? chunksOf(text) : PngChunks{};
    if (chunks.texts > limits::pngTextBytes)
        return "has " + std::to_string(chunks.texts) + " bytes of compressed texts, expected at most 2^17";
    if (chunks.beyond > 0)
        return "has a chunk of " + std::to_string(chunks.beyond) +
               " bytes, expected at most what the file has";
    if (const size_t scans = text.starts_with("\xff\xd8") ? scansOf(text) : 0; scans > limits::jpegScans)
        return "has " + std::to_string(scans) + " scans, expected at most 64";
    return "";
}

std::string unpackingProblem(const std::filesystem::path& file) {
    std::error_code code;
    const uint64_t size = std::filesystem::file_size(file, code);
    if (code) return code.message();
    std::ifstream stream(file, std::ios::binary);
    std::vector<uint8_t> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    return unpackingProblem(bytes);
}

} // namespace demos
