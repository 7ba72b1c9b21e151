// What a report's page says of one picture or sequence.
#pragma once

#include <array>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "program/compare/judged.h"
#include "program/compare/pair.h"

namespace demos {

/// What a report calls the pictures of a pair.
constexpr std::array<const char*, 3> reportFiles = {"reference.png", "test.png", "flip.png"};

/// Narrower pictures are enlarged to the page's width, and then show their pixels.
constexpr uint32_t reportWidth = 960;

/// A template with values in place of @NAME@.
std::string filled(std::string text, const std::map<std::string, std::string>& values);

/// Writes the pictures of a pair, in `folder` of the report's, and sets what the page says of them. Several
/// threads may do so at once.
bool addSection(const CompareOptions& options, const Pair& pair, const std::filesystem::path& folder,
                Judged& judged, Error& error);

/// Likewise of a reference and a picture of which one is missing, or which cannot be compared: what can be
/// read is shown.
bool addUnpaired(const CompareOptions& options, const std::filesystem::path& folder, Judged& judged,
                 Error& error);

/// Of a sequence, by the steps that judgedSequence() notes.
std::string sequenceSection(const nlohmann::ordered_json& steps);

} // namespace demos
