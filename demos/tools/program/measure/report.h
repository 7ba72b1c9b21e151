// A page that shows a comparison: DIR/index.html and its pictures beside it, with nothing from elsewhere.
#pragma once

#include <filesystem>

#include "host/host.h"
#include "metrics/compare.h"
#include "program/compare/compare_options.h"

namespace demos {

/// Whether the page can be written: the folder is there or can be made, and neither picture is one of its
/// files.
bool checkReport(const CompareOptions& options, Error& error);

bool writeReport(const CompareOptions& options, PictureKind kind, const Picture& reference,
                 const Picture& test, const Comparison& comparison, Error& error);

} // namespace demos
