// The scene file's fields as one table: loading, checking, "did you mean" and overrides all read it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "seaglass/fields.h"

namespace demos {

/// One number of a description of the library's, that its table describes.
struct Setting {
    const seaglass::Field* field;
    void* desc;

    double get() const { return field->get(desc, 0); }
    void set(double value) const { field->set(desc, 0, value); }
};

/// Where a field's value lives. The type says what a file may hold there.
using Target = std::variant<double*, Vec2*, Vec3*, std::vector<Vec2>*, uint32_t*, uint64_t*, bool*,
                            std::string*, std::filesystem::path*, Setting>;

/// What a field may hold beyond its type.
enum class Rule {
    none,
    zeroOrRange, ///< 0, or within the range
    powerOfTwo,
    positive,   ///< within the range, its lower end excluded
    identifier, ///< letters, digits, _ and -
};

struct Field {
    std::string_view key;
    Target (*target)(void* owner) = nullptr;
    double least =
        -std::numeric_limits<double>::infinity(); ///< numbers only, ends included; of each component
    double most = std::numeric_limits<double>::infinity();
    std::string_view unit = {};
    std::string_view about = {}; ///< what it is, in a few words
    bool required = false;
    Rule rule = Rule::none;
    std::span<const std::string_view> choices = {}; ///< texts only; empty takes any
    const seaglass::FieldTable* table = nullptr;    ///< of the library, which has
    const seaglass::Field* row = nullptr;           ///< this row for it; null: it is the scene's alone
};

struct Section;

/// How a table within a table is reached. What comes back is what its fields live in.
struct Access {
    void* (*open)(void* owner);               ///< makes the child, or another element of it
    std::vector<void*> (*there)(void* owner); ///< what there is: of an array all, of an optional one or none
};

/// A table within a table, or an array of tables ([[camera]]).
struct Child {
    const Section* section;
    Access access;
    bool repeated = false;
    bool required = false;
};

struct Section {
    std::string_view key; ///< empty for the whole file
    std::span<const Field> fields;
    std::span<const Child> children;
    std::string_view about = {};
};

/// The whole file. Its targets take a Scene*.
const Section& sceneSection();

/// A table in the file by its path, such as water.reflection, which must be there.
const Section& sectionOf(std::string_view path);

/// What a field of words may hold, by its path, such as water.reflection.technique; empty when any.
std::span<const std::string_view> choicesOf(std::string_view path);

/// Of its name, which must be one.
seaglass::ReflectionTechnique techniqueNamed(std::string_view name);

/// What a field may hold, in words: "0 to 60 m/s". The target is the field's own.
std::string expectation(const Field& field, const Target& target);

} // namespace demos
