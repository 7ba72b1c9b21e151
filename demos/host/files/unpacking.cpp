#include "host/files/unpacking.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "host/big_endian.h"
#include "scene/input_limits.h"

namespace demos {
namespace {

void append(std::string_view what, std::vector<uint8_t>& to) {
    to.insert(to.end(), what.begin(), what.end());
}

/// The chunks without which a picture is another (PNG, third edition, 5.4), and those of its colours.
bool isKept(std::string_view chunk) {
    constexpr std::array<std::string_view, 5> kept = {"tRNS", "gAMA", "cHRM", "sRGB", "iCCP"};
    constexpr char ancillary = 0x20;
    return (chunk[0] & ancillary) == 0 || std::find(kept.begin(), kept.end(), chunk) != kept.end();
}

/// What is wrong, empty when nothing is.
std::string cutPng(std::string_view png, BarePicture& out) {
    constexpr size_t signature = 8, head = 8, checksum = 4;
    append(png.substr(0, signature), out.bytes);
    for (size_t at = signature; at + head <= png.size();) {
        const size_t length = bigEndianAt(png, at), left = png.size() - at - head;
        const std::string_view kind = png.substr(at + 4, 4);
        // libpng allocates what is said; it reads pixels piece by piece.
        if (length > left && kind != "IDAT")
            return "has a chunk of " + std::to_string(length) + " bytes, expected at most what the file has";
        const size_t whole = head + std::min(length, left) + checksum;
        if (isKept(kind)) append(png.substr(at, whole), out.bytes);
        if (kind == "IEND") break;
        at += std::min(whole, png.size() - at);
    }
    return "";
}

/// Goes through the segments of a JPEG as libjpeg does (ITU-T T.81, annex B), and keeps those of its pixels.
class JpegCut {
  public:
    JpegCut(std::string_view jpeg, BarePicture& out) : jpeg_(jpeg), out_(out) {}

    /// What is wrong, empty when nothing is.
    std::string cut() {
        append(jpeg_.substr(0, at_), out_.bytes);
        while (at_ < jpeg_.size() && takeNext()) continue;
        return scans_ > limits::jpegScans ? "has " + std::to_string(scans_) + " scans, expected at most 64"
                                          : "";
    }

  private:
    enum Marker : uint8_t {
        temporary = 0x01,
        huffmanTables = 0xc4,
        reserved = 0xc8,
        arithmeticTables = 0xcc,
        startOfImage = 0xd8,
        endOfImage = 0xd9,
        startOfScan = 0xda,
        app0 = 0xe0,
        comment = 0xfe,
    };

    uint8_t byteAt(size_t at) const { return static_cast<uint8_t>(jpeg_[at]); }
    void keep(size_t from, size_t to) { append(jpeg_.substr(from, to - from), out_.bytes); }

    /// What stands before the next marker, and its segment. False behind the last.
    bool takeNext() {
        const size_t marker = std::min(jpeg_.find('\xff', at_), jpeg_.size());
        if (scanning_) keep(at_, marker);
        const size_t code = std::min(jpeg_.find_first_not_of('\xff', marker), jpeg_.size());
        if (code == jpeg_.size()) return false;
        at_ = code + 1;
        const uint8_t kind = byteAt(code);
        const bool withinScan = kind == 0 || (kind >= 0xd0 && kind < startOfImage);
        if (withinScan && scanning_) keep(marker, at_);
        if (withinScan || kind == temporary) return true;
        if (kind == startOfImage || kind == endOfImage) {
            keep(code - 1, at_);
            return false;
        }
        return takeSegment(kind);
    }

    /// That of a marker that ends at `at_`.
    bool takeSegment(uint8_t kind) {
        const size_t from = at_, end = std::min(from + bigEndianAt(jpeg_, from, 2), jpeg_.size());
        if (kind >= 0xc0 && kind < 0xd0 && kind != huffmanTables && kind != reserved &&
            kind != arithmeticTables) {
            out_.height = std::max(out_.height, bigEndianAt(jpeg_, from + 3, 2));
            out_.width = std::max(out_.width, bigEndianAt(jpeg_, from + 5, 2));
        }
        scanning_ = kind == startOfScan;
        scans_ += scanning_ ? 1 : 0;
        if (isKept(kind, jpeg_.substr(from, end - from).substr(std::min<size_t>(2, end - from))))
            keep(from - 2, end);
        at_ = std::max(end, from + 1);
        return true;
    }

    bool isKept(uint8_t kind, std::string_view content) {
        using namespace std::string_view_literals;
        if (kind == comment) return false;
        if (kind < app0 || kind > app0 + 15) return true;
        const bool exif = kind == app0 + 1 && content.starts_with("Exif\0\0"sv) && !hasExif_;
        hasExif_ = hasExif_ || exif;
        return exif || (kind == app0 && content.starts_with("JFIF\0"sv)) ||
               (kind == app0 + 2 && content.starts_with("ICC_PROFILE\0"sv)) ||
               (kind == app0 + 14 && content.starts_with("Adobe"sv));
    }

    std::string_view jpeg_;
    BarePicture& out_;
    size_t at_ = 2, scans_ = 0;
    bool scanning_ = false, hasExif_ = false;
};

} // namespace

std::optional<BarePicture> barePicture(std::span<const uint8_t> bytes, std::string& problem) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    BarePicture out;
    out.bytes.reserve(bytes.size());
    if (text.starts_with("\x89PNG"))
        problem = cutPng(text, out);
    else if (text.starts_with("\xff\xd8"))
        problem = JpegCut(text, out).cut();
    else
        out.bytes.assign(bytes.begin(), bytes.end());
    return problem.empty() ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace demos
