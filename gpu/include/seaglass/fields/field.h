// Tables of what descriptions hold: field, range, unit, meaning. The library checks by them, and a host makes
// of them what it would write by hand: an editor's panel, a console, its scene files. Defaults are those of a
// description as new.
//
//   for (const Field& field : reflectionFields)
//       if (field.type == FieldType::float32 && field.count == 1) slider(field.name, field.low, field.high);
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

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

constexpr uint32_t fieldGrades = 4; ///< a number for each Quality
/// As an end of a range: any finite number.
constexpr double mostFinite = double{std::numeric_limits<float>::max()};

/// One field of a description.
struct Field {
    const char* name = nullptr;          ///< in C++
    FieldType type = FieldType::boolean; ///< of each of its values
    uint32_t count = 1;                  ///< values in a row: 3 of a colour
    double low = 0;                      ///< of each value, as its type holds it
    double high = 1;                     ///< likewise; only an infinite end lets infinity in
    FieldRule rule = FieldRule::within;  ///< of numbers
    const char* unit = "";               ///< m, s, m/s, 1/m, rad, pixel; or of no unit
    const char* about = nullptr;         ///< one sentence
    const char* const* choices =
        nullptr;                     ///< of a choice: names of the values low..high, for files and people
    uint32_t readBy = 0;             ///< bit i: where the table's first field is i; 0: always
    bool graded = false;             ///< setQuality() sets it,
    double grades[fieldGrades] = {}; ///< to these
    double (*get)(const void* desc, uint32_t index) = nullptr;       ///< `desc`: what the table is of
    void (*set)(void* desc, uint32_t index, double value) = nullptr; ///< unchecked

    /// The same, but 0 or within its range.
    constexpr Field orZero() const {
        Field field = *this;
        field.rule = FieldRule::zeroOrWithin;
        return field;
    }
    /// The same, but powers of two alone.
    constexpr Field powersOfTwo() const {
        Field field = *this;
        field.rule = FieldRule::powerOfTwo;
        return field;
    }
    /// The same, but read only where the table's first field is one of these.
    template<typename... Choice>
    constexpr Field onlyFor(Choice... choice) const {
        Field field = *this;
        field.readBy = (... | (1u << static_cast<uint32_t>(choice)));
        return field;
    }
    /// The same, but set by quality, from the lowest to the highest.
    template<typename Value>
    constexpr Field byQuality(Value lowest, Value second, Value third, Value highest) const {
        Field field = *this;
        field.graded = true;
        const Value values[fieldGrades] = {lowest, second, third, highest};
        for (uint32_t i = 0; i < fieldGrades; ++i) field.grades[i] = static_cast<double>(values[i]);
        return field;
    }
};

/// All fields of one description, but pointers and what has a table of its own.
struct FieldTable {
    const char* desc = nullptr;    ///< its name in C++
    const Field* fields = nullptr; ///< in the header's order
    uint32_t count = 0;            ///< of fields

    constexpr const Field* begin() const { return fields; }       ///< for loops
    constexpr const Field* end() const { return fields + count; } ///< likewise
};

/// Of an array of fields.
template<uint32_t count>
constexpr FieldTable fieldTable(const char* desc, const Field (&fields)[count]) {
    return {desc, fields, count};
}

/// How a member is reached through a pointer to its description.
template<auto member>
struct FieldAccess;

/// As FieldAccess, by the types of both.
template<typename DescType, typename Type, Type DescType::*member>
struct FieldAccess<member> {
    using Desc = DescType;                                                         ///< whose member it is
    using Value = std::remove_extent_t<Type>;                                      ///< of each of its values
    static constexpr bool single = !std::is_array_v<Type>;                         ///< not several in a row
    static constexpr uint32_t count = single ? 1u : uint32_t{std::extent_v<Type>}; ///< in a row

    /// Field::get
    static double get(const void* desc, uint32_t index) {
        const Type& value = static_cast<const Desc*>(desc)->*member;
        if constexpr (single)
            return index == 0 ? static_cast<double>(value) : 0;
        else
            return static_cast<double>(value[index]);
    }
    /// Field::set
    static void set(void* desc, uint32_t index, double number) {
        Type& value = static_cast<Desc*>(desc)->*member;
        if constexpr (!single)
            value[index] = static_cast<Value>(number);
        else if constexpr (std::is_enum_v<Value>)
            value = static_cast<Value>(static_cast<uint32_t>(number));
        else if constexpr (std::is_same_v<Value, bool>)
            value = number != 0;
        else
            value = static_cast<Value>(number);
    }
    /// Field::type
    static constexpr FieldType type() {
        if (std::is_same_v<Value, bool>) return FieldType::boolean;
        if (std::is_same_v<Value, float>) return FieldType::float32;
        return std::is_same_v<Value, double> ? FieldType::float64 : FieldType::integer;
    }
};

/// A number or several alike.
template<auto member>
constexpr Field field(const char* name, double low, double high, const char* unit, const char* about) {
    using Access = FieldAccess<member>;
    Field made;
    made.name = name;
    made.type = Access::type();
    made.count = Access::count;
    made.low = low;
    made.high = high;
    made.unit = unit;
    made.about = about;
    made.get = &Access::get;
    made.set = &Access::set;
    return made;
}

/// Yes or no.
template<auto member>
constexpr Field field(const char* name, const char* about) {
    return field<member>(name, 0, 1, "", about);
}

/// One of an enum's values, which run from `first` on.
template<auto member, uint32_t count>
constexpr Field field(const char* name, const char* const (&choices)[count], const char* about,
                      uint32_t first = 0) {
    Field made = field<member>(name, first, first + count - 1, "", about);
    made.type = FieldType::choice;
    made.choices = choices;
    return made;
}

/// Whether a field may hold a value.
inline bool isInRange(const Field& field, double value) {
    if (field.rule == FieldRule::zeroOrWithin && value == 0) return true;
    // Ends are rounded as the field is: 0.1f is not 0.1.
    const bool rounded = field.type == FieldType::float32;
    const double low = rounded ? double{static_cast<float>(field.low)} : field.low;
    const double high = rounded ? double{static_cast<float>(field.high)} : field.high;
    if (!(value >= low && value <= high)) return false;
    if (field.rule != FieldRule::powerOfTwo) return true;
    const auto whole = static_cast<uint32_t>(value);
    return (whole & (whole - 1)) == 0;
}

/// Whether a description's field holds what it may.
inline bool isInRange(const Field& field, const void* desc) {
    for (uint32_t i = 0; i < field.count; ++i)
        if (!isInRange(field, field.get(desc, i))) return false;
    return true;
}

} // namespace seaglass
