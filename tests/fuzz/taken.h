// Values out of bytes, as many as there are: what is missing is 0.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "tests/fuzz/target.h"

namespace fuzz {

class Taken {
  public:
    explicit Taken(Bytes bytes) : left_(bytes) {}

    template<typename T>
    T value() {
        static_assert(std::is_trivially_copyable_v<T>);
        T out{};
        const Bytes from = bytes(sizeof out);
        if (!from.empty()) std::memcpy(&out, from.data(), from.size());
        return out;
    }
    /// Less than `count`.
    uint32_t below(uint32_t count) { return value<uint8_t>() % count; }
    bool yes() { return below(2) == 1; }
    Bytes bytes(size_t count) {
        const Bytes out = left_.first(count < left_.size() ? count : left_.size());
        left_ = left_.subspan(out.size());
        return out;
    }
    bool empty() const { return left_.empty(); }

  private:
    Bytes left_;
};

} // namespace fuzz
