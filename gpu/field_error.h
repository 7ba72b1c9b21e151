// What a field may hold, and a line that says so. No Vulkan: the sea has none.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstring>

#include "gpu/interface/fields/rows.h"

namespace seaglass {

/// A line that says what, where and what was expected; false: nothing is wrong. Allocates nothing.
class FieldError {
  public:
    FieldError() = default;
    FieldError(const char* text) {
        if (text) add(text);
    }

    explicit operator bool() const { return length_ > 0; }
    const char* text() const { return text_; }

    FieldError& add(const char* words) {
        const size_t room = sizeof text_ - 1 - length_, more = std::strlen(words);
        std::memcpy(text_ + length_, words, more < room ? more : room);
        length_ += more < room ? more : room;
        return *this;
    }
    FieldError& add(double number) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%g", number);
        return add(digits);
    }

  private:
    char text_[200] = {};
    size_t length_ = 0;
};

/// Adds "0 to 3: hasselmann, mitsuyasu, donelan-banner or cos2s".
inline void addChoices(FieldError& line, const Field& field) {
    line.add(field.low).add(" to ").add(field.high).add(": ");
    const auto count = static_cast<uint32_t>(field.high - field.low) + 1;
    for (uint32_t i = 0; i < count; ++i)
        line.add(i == 0 ? "" : i + 1 == count ? " or " : ", ").add(field.choices[i]);
}

/// Adds what a field may hold: "0 or 8 to 16384 pixel", "1, 2 or 4", "a finite number in rad".
inline void addExpected(FieldError& line, const Field& field) {
    const char* beforeUnit = " ";
    if (field.choices) {
        addChoices(line, field);
    } else if (field.rule == FieldRule::powerOfTwo && field.high <= 16 * field.low) {
        for (double value = field.low; value <= field.high; value *= 2)
            line.add(value == field.low ? "" : value == field.high ? " or " : ", ").add(value);
    } else if (field.high == mostFinite) {
        line.add(field.low == -mostFinite ? "a finite number" : "a finite number, 0 or more");
        beforeUnit = " in ";
    } else {
        if (field.rule == FieldRule::powerOfTwo) line.add("a power of two, ");
        if (field.rule == FieldRule::zeroOrWithin) line.add("0 or ");
        line.add(field.low).add(" to ").add(field.high);
    }
    if (field.unit[0] != '\0') line.add(beforeUnit).add(field.unit);
}

/// Whether all values of a description's field are what it may hold.
inline bool isInRange(const Field& field, const void* desc) {
    for (uint32_t i = 0; i < field.count; ++i)
        if (!isInRange(field, field.get(desc, i))) return false;
    return true;
}

/// The first field that holds what it may not; null: none does.
inline const Field* outOfRange(const FieldTable& table, const void* desc) {
    for (const Field& field : table)
        if (!isInRange(field, desc)) return &field;
    return nullptr;
}

} // namespace seaglass
