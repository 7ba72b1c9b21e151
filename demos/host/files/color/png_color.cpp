#include "host/files/color/png_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <vector>

#include "host/ascii.h"
#include "host/big_endian.h"

namespace demos {
namespace {

constexpr size_t mostChunks = 1000;
constexpr uint32_t mostBytes = 96; ///< of a chunk that are looked at: a profile's name has 79
constexpr double sRgbGamma = 0.45455;

using Bytes = std::vector<uint8_t>;

struct Chunks {
    Bytes cicp, iccp, srgb, gama, chrm; ///< their first bytes; empty: not there
};

Bytes readBytes(std::ifstream& stream, size_t count) {
    Bytes bytes(count);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<size_t>(stream.gcount()));
    return bytes;
}

/// Those that stand before the pixels.
Chunks readChunks(const std::filesystem::path& file) {
    Chunks chunks;
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(8);
    for (size_t i = 0; i < mostChunks; ++i) {
        const Bytes head = readBytes(stream, 8);
        if (head.size() < 8) break;
        const std::string name(head.begin() + 4, head.end());
        const uint32_t length = bigEndianAt(head, 0);
        if (name == "IDAT") break;
        const std::streamoff next = std::streamoff{stream.tellg()} + length + 4;
        Bytes* const known = name == "cICP"   ? &chunks.cicp
                             : name == "iCCP" ? &chunks.iccp
                             : name == "sRGB" ? &chunks.srgb
                             : name == "gAMA" ? &chunks.gama
                             : name == "cHRM" ? &chunks.chrm
                                              : nullptr;
        if (known) *known = readBytes(stream, std::min(length, mostBytes));
        stream.seekg(next);
    }
    return chunks;
}

/// Rec. 709's primaries by sRGB's curve, full range (ITU-T H.273).
bool isSRgb(const Bytes& cicp) {
    return cicp[0] == 1 && cicp[1] == 13 && cicp[2] == 0 && cicp[3] == 1;
}

std::string nameInChunk(const Bytes& iccp) {
    return printable({iccp.begin(), std::find(iccp.begin(), iccp.end(), uint8_t{0})});
}

/// Gammas within 5 % of sRGB's stand for its curve, as libpng has it.
double gammaOf(const Bytes& gama) {
    const double gamma = gama.size() >= 4 ? bigEndianAt(gama, 0) / 1e5 : 0;
    return std::abs(gamma / sRgbGamma - 1) < 0.05 ? 0 : gamma;
}

/// White comes first in the file.
std::optional<Primaries> primariesOf(const Bytes& chrm) {
    Primaries out{};
    if (chrm.size() < 4 * out.size()) return std::nullopt;
    for (size_t i = 0; i < out.size(); ++i) out[(i + 6) % 8] = bigEndianAt(chrm, 4 * i) / 1e5;
    return out;
}

} // namespace

PngColor readPngColor(const std::filesystem::path& file) {
    const Chunks chunks = readChunks(file);
    if (chunks.cicp.size() >= 4) {
        if (isSRgb(chunks.cicp)) return {};
        std::string text = "cICP";
        for (size_t i = 0; i < 4; ++i) text += (i ? "/" : " ") + std::to_string(chunks.cicp[i]);
        return {0, std::nullopt, text, std::nullopt};
    }
    if (!chunks.iccp.empty()) return {0, std::nullopt, "", nameInChunk(chunks.iccp)};
    if (!chunks.srgb.empty()) return {};
    return {gammaOf(chunks.gama), primariesOf(chunks.chrm), "", std::nullopt};
}

} // namespace demos
