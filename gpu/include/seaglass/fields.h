// Descriptions as tables of their settings, for a host's panels, consoles and files. The library checks by
// the same tables: beyond its range a field is `invalidArgument`.
//
//   for (const Field& field : fieldsOf(body.mesh))
//       if (field.type == FieldType::float32 && field.count == 1)
//           slider(field.name, field.low, field.high, field.get(&body.mesh, 0));
#pragma once

#include <cstdint>
#include <limits>

namespace seaglass {

/// What a field is in C++.
enum class FieldType : uint32_t {
    boolean = 0, ///< bool; as a number 0 or 1
    integer,     ///< uint32_t, or one of Vulkan's flags
    float32,     ///< float
    float64,     ///< double
    choice,      ///< an enum of uint32_t; as a number its value
};

/// What of its range a field may hold.
enum class FieldRule : uint32_t {
    within = 0,   ///< low..high, ends included
    zeroOrWithin, ///< that, or 0
    powerOfTwo,   ///< within, and a power of two
};

constexpr uint32_t fieldGrades = 4;                                      ///< a number for each Quality
constexpr double mostFinite = double{std::numeric_limits<float>::max()}; ///< as an end: any finite number

/// One field of a description.
struct Field {
    const char* name = nullptr;           ///< in C++
    FieldType type = FieldType::boolean;  ///< of each of its values
    uint32_t count = 1;                   ///< values in a row: 3 of a colour
    double low = 0;                       ///< of each value, as its type holds it
    double high = 1;                      ///< likewise; only an infinite end lets infinity in
    FieldRule rule = FieldRule::within;   ///< of numbers
    const char* unit = "";                ///< m, s, m/s, 1/m, rad, pixel; or of no unit
    const char* about = nullptr;          ///< one sentence
    const char* const* choices = nullptr; ///< of a choice: names of the values low..high
    uint32_t readBy = 0;                  ///< bit i: where the table's first field is i; 0: always
    bool graded = false;                  ///< setQuality() sets it,
    double grades[fieldGrades] = {};      ///< to these, from the lowest to the highest
    double (*get)(const void* desc, uint32_t index) = nullptr;       ///< of what the table is of
    void (*set)(void* desc, uint32_t index, double value) = nullptr; ///< unchecked
};

/// Fields of a description, but pointers and what has a table of its own; lives as long as the program.
struct FieldTable {
    const char* desc = nullptr;                                   ///< its name in C++
    const Field* fields = nullptr;                                ///< in the header's order
    uint32_t count = 0;                                           ///< of fields
    constexpr const Field* begin() const { return fields; }       ///< for loops
    constexpr const Field* end() const { return fields + count; } ///< likewise
};

/// The settings of a description that docs/reference/settings.md lists; for others it does not link.
template<typename Desc>
FieldTable fieldsOf(const Desc&);

/// Whether a field may hold a value.
inline bool isInRange(const Field& field, double value) {
    if (field.rule == FieldRule::zeroOrWithin && value == 0) return true;
    // Ends are rounded as the field is: 0.1f is not 0.1.
    const bool rounded = field.type == FieldType::float32;
    const double low = rounded ? double{static_cast<float>(field.low)} : field.low;
    const double high = rounded ? double{static_cast<float>(field.high)} : field.high;
    if (!(value >= low && value <= high)) return false;
    if (field.rule != FieldRule::powerOfTwo) return true;
    const auto whole = static_cast<uint32_t>(value); // no such range is beyond its own
    return (whole & (whole - 1)) == 0;
}

} // namespace seaglass
