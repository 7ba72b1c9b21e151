// Numbers in files that hold their highest byte first.
#pragma once

#include <cstddef>
#include <cstdint>

namespace demos {

/// Of so many of these bytes; 0 beyond their end.
template<typename Bytes>
uint32_t bigEndianAt(const Bytes& bytes, size_t at, size_t count = 4) {
    if (at > bytes.size() || bytes.size() - at < count) return 0;
    uint32_t number = 0;
    for (size_t i = 0; i < count; ++i) number = number << 8 | static_cast<uint8_t>(bytes[at + i]);
    return number;
}

} // namespace demos
