#include "host/files/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "scene/input_limits.h"

namespace demos {
namespace {

constexpr uint32_t multiPart = 0x1000;
/// Bytes of types that OpenEXR reads whole, whatever their attribute is said to hold.
struct Sized {
    std::string_view type;
    int64_t bytes;
};
constexpr std::array<Sized, 24> sizedTypes = {{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};
/// Rows that each of OpenEXR's compressions packs together, from NO_COMPRESSION to DWAB_COMPRESSION.
constexpr std::array<int64_t, 10> rowsOfBlock = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
        stream_.seekg(0, std::ios::end);
        size_ = stream_.tellg();
        stream_.seekg(0);
    }
    int64_t left() { return size_ - stream_.tellg(); }
    int64_t size() const { return size_; }
    void skip(int64_t bytes) { stream_.seekg(bytes, std::ios::cur); }
    bool ok() const { return !stream_.fail(); }
    /// Little-endian, as the file is.
    uint32_t word() {
        std::array<unsigned char, 4> bytes{};
        stream_.read(reinterpret_cast<char*>(bytes.data()), 4);
        return bytes[0] | uint32_t(bytes[1]) << 8 | uint32_t(bytes[2]) << 16 | uint32_t(bytes[3]) << 24;
    }
    int64_t integer() { return static_cast<int32_t>(word()); }
    int64_t byte() { return stream_.get(); }
    std::string name() {
        std::string text;
        std::getline(stream_, text, '\0');
        if (text.size() > limits::exrNameBytes) stream_.setstate(std::ios::failbit);
        return text;
    }

    std::string text(int64_t bytes) {
        std::string out(std::min(static_cast<size_t>(bytes), limits::exrNameBytes), '\0');
        stream_.read(out.data(), static_cast<std::streamsize>(out.size()));
        return out;
    }

  private:
    std::ifstream stream_;
    int64_t size_ = 0;
};

struct PartSize {
    int64_t width = 0, height = 0, rows = 1, channels = 0;
};

/// What is wrong, empty when nothing is.
std::string countChannels(Reader& reader, int64_t bytes, int64_t& count) {
    constexpr int64_t types = 3; // whole numbers, halves and floats
    const int64_t end = reader.left() - bytes;
    while (reader.ok() && reader.left() > end && !reader.name().empty()) {
        if (reader.word() >= types) return "has a channel of an unknown type";
        reader.skip(12); // linearity, sampling
        ++count;
    }
    // OpenEXR goes by the empty name alone, and would read on from elsewhere.
    return reader.left() == end ? "" : "has a list of channels that is not as long as it says";
}

/// What is wrong with how much an attribute is said to hold; empty when nothing is.
std::string sizeProblem(Reader& reader, const std::string& type, int64_t bytes) {
    const auto* const sized = std::find_if(sizedTypes.begin(), sizedTypes.end(),
                                           [&](const Sized& known) { return known.type == type; });
    int64_t expected = sized == sizedTypes.end() ? bytes : sized->bytes;
    if (type == "preview") {
        const int64_t width = reader.word(), height = reader.word();
        expected = width < limits::pictureSide && height < limits::pictureSide ? 8 + 4 * width * height : -1;
        reader.skip(-8);
    }
    return bytes == expected ? "" : "is said to hold " + std::to_string(bytes) + " bytes, of type " + type;
}

/// Of other parts OpenEXR checks nothing.
bool isTypeOfPart(const std::string& type) {
    return type == "scanlineimage" || type == "tiledimage" || type == "deepscanline" || type == "deeptile";
}

/// Reads an attribute, and may stop short of its end.
std::string take(Reader& reader, const std::string& name, int64_t bytes, PartSize& part) {
    if (name == "channels") return countChannels(reader, bytes, part.channels);
    if (name == "type" && !isTypeOfPart(reader.text(bytes))) return "has a part of an unknown type";
    if (name == "compression") {
        const auto kind = static_cast<size_t>(reader.byte());
        if (kind < rowsOfBlock.size()) part.rows = rowsOfBlock[kind];
    }
    if (name == "chunkCount" && reader.integer() > reader.size() / 8)
        return "says that it has more chunks than bytes";
    if (name == "dataWindow" || name == "displayWindow") {
        const int64_t left = reader.integer(), top = reader.integer();
        const int64_t width = reader.integer() - left + 1, height = reader.integer() - top + 1;
        if (width < 1 || height < 1 || width > limits::pictureSide || height > limits::pictureSide)
            return "is " + std::to_string(width) + "x" + std::to_string(height) +
                   ", expected 1 to 16384 each way";
        if (name == "dataWindow") part.width = width;
    }
    if (name == "tiles") {
        const int64_t width = reader.word(), height = reader.word();
        if (width > limits::pictureSide || height > limits::pictureSide ||
            width * height > limits::tilePixels)
            return "has tiles of " + std::to_string(width) + "x" + std::to_string(height) +
                   ", expected at most 2^24 pixels";
    }
    return "";
}

/// `more`: whether a part was read, and another may follow.
std::string partProblem(Reader& reader, bool& more) {
    PartSize part;
    more = false;
    int attributes = 0;
    for (std::string name = reader.name(); reader.ok() && !name.empty(); name = reader.name()) {
        more = true;
        if (++attributes > limits::exrAttributes)
            return "has over " + std::to_string(limits::exrAttributes) + " attributes in a part";
        const std::string type = reader.name();
        const int64_t bytes = reader.word(), left = reader.left();
        if (!reader.ok() || bytes > left)
            return "attribute '" + name + "' is said to hold " + std::to_string(bytes) +
                   " bytes, expected at most what the file has";
        if (const std::string wrong = sizeProblem(reader, type, bytes); !wrong.empty())
            return "attribute '" + name + "' " + wrong;
        const std::string problem = take(reader, name, bytes, part);
        if (!problem.empty()) return problem;
        reader.skip(reader.left() - (left - bytes));
    }
    if (!reader.ok()) return "its header is cut off, expected a whole file";
    if (part.width * part.rows * part.channels * 4 > limits::exrBlockBytes)
        return "has " + std::to_string(part.channels) + " channels in blocks of " +
               std::to_string(part.width) + "x" + std::to_string(part.rows) + ", expected at most 2^29 bytes";
    return "";
}

} // namespace

std::string exrHeaderProblem(const std::filesystem::path& file) {
    Reader reader(file);
    reader.skip(4);
    const uint32_t version = reader.word();
    std::string problem;
    bool more = true;
    while (problem.empty() && more) {
        problem = partProblem(reader, more);
        if ((version & multiPart) == 0) break;
    }
    return problem;
}

} // namespace demos
