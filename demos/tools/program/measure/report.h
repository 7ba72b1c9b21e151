// A page that shows comparisons: DIR/index.html and its pictures beside it, with nothing from elsewhere.
#pragma once

#include "program/compare/judged.h"
#include "program/compare/pair.h"

namespace demos {

/// Whether the page can be written: the folder is there or can be made, and no picture that is read is one of
/// its files.
bool checkReport(const CompareOptions& options, Error& error);

/// Writes the page in the folder, worst first, and what a page of several is made of; says on stdout where it
/// is. Without a title it counts what failed.
bool writeReport(const std::filesystem::path& folder, const std::vector<Judged>& all, Error& error,
                 const std::string& title = {});

/// seaglass report: a page in `folder` of all that writeReport() left in its folders.
ExitCode gatherReports(const std::filesystem::path& folder, Error& error);

} // namespace demos
