// What a report leaves beside its page, of which a page of several reports is made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "program/compare/judged.h"

namespace demos {

constexpr const char* gatheredName = "report.json";

std::string gatherable(const std::vector<Judged>& all);

/// Of all folders in `folder`, by name. What cannot be read is named as bad input.
std::vector<Judged> gathered(const std::filesystem::path& folder);

} // namespace demos
