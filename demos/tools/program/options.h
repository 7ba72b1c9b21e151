// The command line as plain data.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program/bless/bless_options.h"
#include "program/compare/compare_options.h"
#include "program/measure/measure_options.h"
#include "program/render/render_options.h"
#include "program/screenshots/gather_options.h"
#include "program/sea/sea_options.h"
#include "program/view_options.h"

namespace demos {

struct ReferenceOptions {
    RenderOptions picture; ///< of which what a device, a sequence or a measurement needs stays unset
    uint32_t samples = 1;  ///< of each pixel
    uint64_t seed = 1;
    std::filesystem::path truth;    ///< empty writes none
    std::filesystem::path mirrored; ///< likewise
};

struct Options {
    enum class Command { render, view, reference, compare, bless, report, measure, sea, devices, printed };
    Command command = Command::printed; ///< printed: help or version, and all is done
    RenderOptions render;
    ViewOptions view;
    ReferenceOptions reference;
    CompareOptions compare;
    BlessOptions bless;
    GatherOptions report;
    MeasureOptions measure;
    SeaOptions sea;
};

/// Null with `error` set when the line makes no sense. Prints help and version when asked to.
std::optional<Options> parseOptions(int argc, const char* const* argv, Error& error);

} // namespace demos
