// A page that shows comparisons: DIR/index.html and its pictures beside it, with nothing from elsewhere.
#pragma once

#include "program/compare/judged.h"
#include "program/compare/pair.h"

namespace demos {

/// Whether the page can be written: the folder is there or can be made, and no picture that is read is one of
/// its files.
bool checkReport(const CompareOptions& options, Error& error);

/// Writes the pictures of a pair, in `folder` of the report's, and sets what the page says of them. Several
/// threads may do so at once.
bool addSection(const CompareOptions& options, const Pair& pair, const std::filesystem::path& folder,
                Judged& judged, Error& error);

/// Writes the page, worst first, and says on stdout where it is.
bool writeReport(const CompareOptions& options, const std::vector<Judged>& all, Error& error);

} // namespace demos
