// The scene's fields of what the library's tables describe.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "scene/fields.h"
#include "seaglass/fields.h"

namespace demos {

/// Names of an enum's values, as the library has them.
template<const auto& names>
constexpr auto wordsOf = [] {
    std::array<std::string_view, std::size(names)> words;
    std::copy(std::begin(names), std::end(names), words.begin());
    return words;
}();

/// A key, as it is made of a name.
struct Key {
    std::array<char, 40> text{};
    size_t length = 0;

    constexpr void add(std::string_view letters) {
        for (const char letter : letters) text[length++] = letter;
    }
    constexpr std::string_view view() const { return {text.data(), length}; }
};

/// How units end a key.
constexpr std::string_view unitInKeys(std::string_view unit) {
    constexpr std::pair<std::string_view, std::string_view> ends[] = {
        {"m", "_m"}, {"1/m", "_per_m"}, {"s", "_s"}, {"m/s", "_m_s"}, {"pixel", "_px"}};
    for (const auto& [name, end] : ends)
        if (name == unit) return end;
    return "";
}

/// What scenes call a field: marchThickness in metres is march_thickness_m. Without so many letters of its
/// name.
constexpr Key keyOf(const seaglass::Field& field, size_t without) {
    Key key;
    const std::string_view name = field.name;
    for (const char letter : name.substr(std::min(without, name.size()))) {
        const bool capital = letter >= 'A' && letter <= 'Z';
        if (capital && key.length > 0) key.add("_");
        const char small[] = {static_cast<char>(capital ? letter - 'A' + 'a' : letter), '\0'};
        key.add(small);
    }
    key.add(unitInKeys(field.unit));
    return key;
}

/// A field that a table describes.
constexpr Field described(const seaglass::FieldTable& table, const seaglass::Field& row, std::string_view key,
                          Target (*target)(void* owner), std::span<const std::string_view> choices = {}) {
    using seaglass::FieldRule;
    Field field{key, target, row.low, row.high, row.unit, row.about};
    if (row.rule == FieldRule::zeroOrWithin) field.rule = Rule::zeroOrRange;
    if (row.rule == FieldRule::powerOfTwo) field.rule = Rule::powerOfTwo;
    field.choices = choices;
    field.table = &table;
    field.row = &row;
    return field;
}

/// A table's row by its name, which must be there.
consteval const seaglass::Field& rowOf(const seaglass::FieldTable& table, std::string_view name) {
    for (const seaglass::Field& row : table)
        if (row.name == name) return row;
    throw "no such field";
}

template<class T>
T& there(T& value) {
    return value;
}
template<class T>
T& there(std::optional<T>& value) {
    return *value;
}

/// All of a table, or the rows that are named, as fields of what holds its description: in `member`, or, if
/// that is null, itself.
template<const seaglass::FieldTable& table, class Owner, auto member = nullptr>
class Settings {
  public:
    /// A row by its name, under a key of its own.
    static consteval Field one(std::string_view name, std::string_view key) {
        Field found;
        each([&]<size_t i>() {
            if (table.fields[i].name == name)
                found = described(table, table.fields[i], key, &target<i>, words<i>);
        });
        if (!found.row) throw "no such field";
        return found;
    }

    /// All but those named.
    template<size_t left = 0>
    static consteval auto allBut(const std::array<std::string_view, left>& names = {}) {
        std::array<Field, table.count - left> fields;
        size_t next = 0;
        each([&]<size_t i>() {
            if (std::ranges::find(names, table.fields[i].name) == names.end())
                fields[next++] = described(table, table.fields[i], key<i>.view(), &target<i>, words<i>);
        });
        return fields;
    }

    /// Those of a part, whose names begin with its own, under keys without it: causticStep is step_px.
    template<const std::string_view& part>
    static consteval auto of() {
        std::array<Field, countOf(part)> fields;
        size_t next = 0;
        each([&]<size_t i>() {
            if (isOf(i, part))
                fields[next++] =
                    described(table, table.fields[i], key<i, part.size()>.view(), &target<i>, words<i>);
        });
        return fields;
    }

    /// All that are of none of these parts.
    template<const std::string_view&... parts>
    static consteval auto butOf() {
        std::array<Field, table.count - (... + countOf(parts))> fields;
        size_t next = 0;
        each([&]<size_t i>() {
            if (!(... || isOf(i, parts)))
                fields[next++] = described(table, table.fields[i], key<i>.view(), &target<i>, words<i>);
        });
        return fields;
    }

  private:
    static constexpr bool isOf(size_t i, std::string_view part) {
        return std::string_view(table.fields[i].name).starts_with(part);
    }
    static constexpr size_t countOf(std::string_view part) {
        size_t count = 0;
        for (size_t i = 0; i < table.count; ++i) count += isOf(i, part);
        return count;
    }

    template<size_t i, size_t without = 0>
    static constexpr Key key = keyOf(table.fields[i], without);

    template<size_t i>
    static constexpr auto words = [] {
        constexpr const seaglass::Field& row = table.fields[i];
        std::array<std::string_view,
                   row.type == seaglass::FieldType::choice ? static_cast<size_t>(row.high - row.low) + 1 : 0>
            names;
        for (size_t n = 0; n < names.size(); ++n) names[n] = row.choices[n];
        return names;
    }();

    template<size_t i>
    static Target target(void* owner) {
        static_assert(table.fields[i].count == 1, "a Setting is one number");
        if constexpr (std::is_null_pointer_v<decltype(member)>)
            return Setting{&table.fields[i], static_cast<Owner*>(owner)};
        else
            return Setting{&table.fields[i], &there(static_cast<Owner*>(owner)->*member)};
    }

    template<class Each>
    static consteval void each(const Each& visit) {
        [&]<size_t... i>(std::index_sequence<i...>) {
            (..., visit.template operator()<i>());
        }
        (std::make_index_sequence<table.count>());
    }
};

/// Fields in a row.
template<size_t... count>
consteval auto joined(const std::array<Field, count>&... parts) {
    std::array<Field, (... + count)> all;
    size_t next = 0;
    const auto add = [&](const auto& part) {
        for (const Field& field : part) all[next++] = field;
    };
    (..., add(parts));
    return all;
}

} // namespace demos
