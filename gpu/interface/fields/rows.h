// How a row of a table of settings is made of a member: its type, its count and the way to it come from the
// member's own type. Rows stand beside each description's table in `interface/fields`, and are known while
// compiling. No Vulkan: the sea has none.
#pragma once

#include <cstdint>
#include <type_traits>

#include "seaglass/fields.h"

namespace seaglass {

/// How a member is reached through a pointer to its description.
template<auto member>
struct FieldAccess;

template<typename DescType, typename Type, Type DescType::*member>
struct FieldAccess<member> {
    using Desc = DescType;
    using Value = std::remove_extent_t<Type>;
    static constexpr bool single = !std::is_array_v<Type>;
    static constexpr uint32_t count = single ? 1u : uint32_t{std::extent_v<Type>};

    static double get(const void* desc, uint32_t index) {
        const Type& value = static_cast<const Desc*>(desc)->*member;
        if constexpr (single)
            return index == 0 ? static_cast<double>(value) : 0;
        else
            return static_cast<double>(value[index]);
    }
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
    static constexpr FieldType type() {
        if (std::is_same_v<Value, bool>) return FieldType::boolean;
        if (std::is_same_v<Value, float>) return FieldType::float32;
        return std::is_same_v<Value, double> ? FieldType::float64 : FieldType::integer;
    }
};

/// A field, and what may be said of it beside its range.
struct Row {
    Field field;

    constexpr operator Field() const { return field; }

    /// Also 0.
    constexpr Row orZero() const { return ruled(FieldRule::zeroOrWithin); }
    constexpr Row powersOfTwo() const { return ruled(FieldRule::powerOfTwo); }
    /// Read only where the table's first field is one of these.
    template<typename... Choice>
    constexpr Row onlyFor(Choice... choice) const {
        Row row = *this;
        row.field.readBy = (... | (1u << static_cast<uint32_t>(choice)));
        return row;
    }
    /// What setQuality() makes of it.
    template<typename Value>
    constexpr Row byQuality(Value lowest, Value second, Value third, Value highest) const {
        Row row = *this;
        row.field.graded = true;
        const Value values[fieldGrades] = {lowest, second, third, highest};
        for (uint32_t i = 0; i < fieldGrades; ++i) row.field.grades[i] = static_cast<double>(values[i]);
        return row;
    }

  private:
    constexpr Row ruled(FieldRule rule) const {
        Row row = *this;
        row.field.rule = rule;
        return row;
    }
};

/// A number or several alike.
template<auto member>
constexpr Row field(const char* name, double low, double high, const char* unit, const char* about) {
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
    return {made};
}

/// Yes or no.
template<auto member>
constexpr Row field(const char* name, const char* about) {
    return field<member>(name, 0, 1, "", about);
}

/// One of an enum's values, which run from `first` on.
template<auto member, uint32_t count>
constexpr Row field(const char* name, const char* const (&choices)[count], const char* about,
                    uint32_t first = 0) {
    Row made = field<member>(name, first, first + count - 1, "", about);
    made.field.type = FieldType::choice;
    made.field.choices = choices;
    return made;
}

template<uint32_t count>
constexpr FieldTable fieldTable(const char* desc, const Field (&rows)[count]) {
    return {desc, rows, count};
}

} // namespace seaglass
