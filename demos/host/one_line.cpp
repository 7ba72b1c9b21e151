#include "host/one_line.h"

#include <algorithm>
#include <cstdint>

namespace demos {

namespace {

unsigned byteAt(const std::string& text, size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

/// Bytes of the character of UTF-8 at `at` that XML may hold, too; 0 where there is none.
size_t characterLength(const std::string& text, size_t at) {
    const unsigned first = byteAt(text, at);
    if (first < 0x80) return 1;
    const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    uint32_t character = first & (0x7fu >> length);
    for (size_t i = 1; i < length; ++i) {
        const unsigned byte = byteAt(text, at + i);
        if ((byte & 0xc0u) != 0x80) return 0;
        character = character << 6u | (byte & 0x3fu);
    }
    constexpr uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool known = first >= 0xc0 && character >= least[length] && character <= 0x10ffff;
    const bool surrogate = character >= 0xd800 && character < 0xe000;
    return known && !surrogate && (character & 0xfffeu) != 0xfffe ? length : 0;
}

} // namespace

std::string oneLine(const std::string& text) {
    std::string kept;
    for (size_t at = 0; at < text.size();) {
        const size_t length = characterLength(text, at);
        kept += length == 0 ? "?" : text.substr(at, length);
        at += std::max<size_t>(length, 1);
    }
    for (char& c : kept) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : '?';
    }
    return kept;
}

} // namespace demos
