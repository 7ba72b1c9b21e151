#include "host/gltf/uri.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "host/gltf/document.h"
#include "scene/reading/input_file.h"

namespace demos::gltf {
namespace {

std::optional<uint8_t> hexOf(char c) {
    if (c >= '0' && c <= '9') return static_cast<uint8_t>(c - '0');
    const char lower = static_cast<char>(c | 0x20);
    if (lower >= 'a' && lower <= 'f') return static_cast<uint8_t>(lower - 'a' + 10);
    return std::nullopt;
}

std::string percentDecoded(std::string_view text) {
    std::string decoded;
    for (size_t i = 0; i < text.size(); ++i) {
        const std::optional<uint8_t> high = i + 2 < text.size() ? hexOf(text[i + 1]) : std::nullopt,
                                     low = i + 2 < text.size() ? hexOf(text[i + 2]) : std::nullopt;
        if (text[i] != '%' || !high || !low) {
            decoded += text[i];
            continue;
        }
        decoded += static_cast<char>(*high << 4 | *low);
        i += 2;
    }
    return decoded;
}

/// RFC 4648; the padding may be missing, and lines may be broken.
bool decodeBase64(std::string_view text, std::vector<uint8_t>& out) {
    const auto isSpace = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && (text.back() == '=' || isSpace(text.back()))) text.remove_suffix(1);
    out.reserve(text.size() / 4 * 3 + 3);
    uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        if (isSpace(c)) continue;
        uint32_t six = 0;
        if (c >= 'A' && c <= 'Z')
            six = static_cast<uint32_t>(c - 'A');
        else if (c >= 'a' && c <= 'z')
            six = static_cast<uint32_t>(c - 'a') + 26;
        else if (c >= '0' && c <= '9')
            six = static_cast<uint32_t>(c - '0') + 52;
        else if (c == '+' || c == '-')
            six = 62;
        else if (c == '/' || c == '_')
            six = 63;
        else
            return false;
        bits = bits << 6 | six;
        held += 6;
        if (held < 8) continue;
        held -= 8;
        out.push_back(static_cast<uint8_t>(bits >> held));
    }
    return true;
}

bool readData(std::string_view uri, uint64_t most, std::vector<uint8_t>& out, std::string& problem) {
    const size_t comma = uri.find(',');
    problem = "a data URI that is not to be decoded";
    if (comma == std::string_view::npos) return false;
    const std::string_view body = uri.substr(comma + 1);
    if (uri.substr(0, comma).ends_with(";base64")) {
        const bool escaped = body.find('%') != body.npos;
        if (!(escaped ? decodeBase64(percentDecoded(body), out) : decodeBase64(body, out))) return false;
    } else {
        const std::string decoded = percentDecoded(body);
        out.assign(decoded.begin(), decoded.end());
    }
    if (out.size() <= most) return true;
    problem = "a data URI of over " + std::to_string(most) + " bytes";
    return false;
}

bool isData(std::string_view uri) {
    constexpr std::string_view scheme = "data:";
    return uri.size() >= scheme.size() &&
           std::equal(scheme.begin(), scheme.end(), uri.begin(), [](char lower, char c) {
               return lower == std::tolower(static_cast<unsigned char>(c));
           });
}

/// A scheme of two letters at least: one is a drive's.
bool hasScheme(const std::string& uri) {
    const size_t colon = uri.find(':');
    return colon != std::string::npos && colon > 1 &&
           std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                       [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

} // namespace

std::shared_ptr<const std::vector<uint8_t>> UriReader::read(const std::string& uri, uint64_t most,
                                                            std::string& problem) {
    if (isData(uri)) {
        auto data = std::make_shared<std::vector<uint8_t>>();
        return readData(uri, most, *data, problem) ? data : nullptr;
    }
    const std::optional<std::filesystem::path> file = find(uri, problem);
    if (!file) return nullptr;
    auto& known = files_[*file];
    if (known) return known;
    auto bytes = std::make_shared<std::vector<uint8_t>>();
    if (!readWhole(*file, most, *bytes, problem)) {
        problem = quoted(file->filename().string()) + " " + problem;
        return nullptr;
    }
    bytes_ += bytes->size();
    known = std::move(bytes);
    return known;
}

std::optional<std::filesystem::path> UriReader::find(const std::string& uri, std::string& problem) const {
    const std::string decoded = percentDecoded(uri);
    std::string slashed = decoded;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    for (const std::string& name : {decoded, uri, slashed}) {
        std::error_code ignored;
        if (name.find('\0') != std::string::npos ||
            !std::filesystem::is_regular_file(folder_ / name, ignored))
            continue;
        std::filesystem::path file = std::filesystem::canonical(folder_ / name, ignored);
        if (!ignored) return file;
    }
    problem = quoted(decoded) + ": ";
    if (hasScheme(decoded))
        problem += "only files are read";
    else if (decoded.find('\0') != std::string::npos)
        problem += "no such file";
    else
        problem += unreadable(folder_ / decoded);
    return std::nullopt;
}

} // namespace demos::gltf
