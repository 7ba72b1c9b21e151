// Members of glTF's JSON, checked: what is wrong is named by where it stands, as "meshes[2].primitives[0]".
#pragma once

#include <optional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace demos::gltf {

using Json = nlohmann::json;

/// In quotes, without control characters, and not all of it where it is long: files choose their names.
std::string quoted(const std::string& text);

/// "materials[3] "paint"", where it has a name.
std::string placeOf(const char* array, size_t index, const Json& object);

/// A null where there is none.
const Json& member(const Json& object, const char* key);
const Json& extension(const Json& object, const char* name);

/// Whether an extension that is not read changes no picture of a file at rest.
bool isHarmless(const std::string& extension);

/// Empty where it is no text; lies in `object`, which may hold a megabyte of it.
const std::string& textOf(const Json& object, const char* key);
bool isTrue(const Json& object, const char* key);

/// A whole number below `count`.
std::optional<size_t> indexOf(const Json& value, size_t count);
/// An index of something of which there are `count`, or a count below that. Absent leaves `out` as it is.
bool readIndex(const Json& object, const char* key, size_t count, const std::string& where,
               std::optional<size_t>& out, Error& error);
bool readCount(const Json& object, const char* key, const std::string& where, size_t& out, Error& error);
/// As many numbers as `out` has; one alone where that is 1. Absent leaves `out` as it is.
bool readNumbers(const Json& object, const char* key, const std::string& where, std::span<double> out,
                 Error& error);

} // namespace demos::gltf
