#include "program/compare/compare_options.h"

#include <CLI/CLI.hpp>

#include "program/compare/values.h"

namespace demos {

namespace {

constexpr const char* footer =
    R"(Without a limit, any difference of colour is one too many. A mean forgives a spot: give --max-diff
and --max-share beside --max-flip. NaN or infinity in either picture always fails. Only colour is compared:
of an EXR its unnamed layer, or the one of a beauty pass' name; what else it holds is listed. A PNG's gamma and
primaries are brought to sRGB and named; a colour profile is named alone.

Examples:
  seaglass compare golden.png mine.png --max-flip 0.02 --max-diff 0.1 --max-share 0.001
  seaglass compare before.exr after.exr --report out/report

Exit codes: 0 the same within the limits, 1 different, 2 bad input, or no room for what was to be written.)";

/// Sets `out` if the option is there.
bool checkNumber(const char* option, const std::string& text, double most, const char* expected,
                 std::optional<double>& out, Error& error) {
    if (text.empty()) return true;
    out = parseNumber(option, text, 0, most, expected, error);
    return out.has_value();
}

} // namespace

void describeCompare(CLI::App& command, RawCompare& raw) {
    command.footer(footer);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command.add_option("REFERENCE", raw.reference, "PNG (display-encoded), or EXR or HDR (linear)");
    command.add_option("TEST", raw.test, "The picture to judge, of the same kind and size");
    command.add_option("--max-flip", raw.maxFlip, "Mean FLIP may be X, 0 to 1")->type_name("X");
    command
        .add_option("--max-diff", raw.maxDiff,
                    "Channels may differ by X (of 0 to 1 in a PNG, of light in an EXR), 0 if only "
                    "--max-share is given")
        ->type_name("X");
    command
        .add_option("--max-share", raw.maxShare,
                    "The share P of pixels, 0 to 1, may differ by more, 0 if only --max-diff is given")
        ->type_name("P");
    command
        .add_option("--layer", raw.layers,
                    "Of EXRs with several layers of colour; given twice, the reference's and the test's")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        .add_option(
            "--report", raw.report,
            "Write a page with both pictures and the FLIP map: DIR/index.html; DIR is made if need be")
        ->type_name("DIR");
    command
        .add_option(
            "--exposure", raw.exposure,
            "Exposure of the report's EXR or HDR pictures; the median becomes middle grey if not given")
        ->type_name("EV");
    command.add_flag(
        "--large", raw.large,
        "Take pictures of up to 2^25 pixels from files of any size: 4 GiB of memory and a minute");
    command.add_option("--json", raw.json, "Write the measures as JSON")->type_name("FILE");
    command.allow_extras();
}

std::optional<CompareOptions> checkCompare(const RawCompare& raw, Error& error) {
    if (raw.reference.empty() || raw.test.empty()) {
        error.text = "no two pictures, expected seaglass compare REFERENCE TEST";
        return std::nullopt;
    }
    CompareOptions options;
    options.reference = raw.reference;
    options.test = raw.test;
    options.report = raw.report;
    options.json = raw.json;
    options.large = raw.large;
    if (raw.layers.size() > 2) {
        error.text = "--layer is given " + std::to_string(raw.layers.size()) +
                     " times, expected one for both pictures, or the reference's and the test's";
        return std::nullopt;
    }
    if (!raw.layers.empty()) {
        options.referenceLayer = raw.layers.front();
        options.testLayer = raw.layers.back();
    }
    std::optional<double> over, share;
    if (!checkNumber("--max-flip", raw.maxFlip, 1, "a mean FLIP, 0 to 1", options.limits.flipMean, error) ||
        !checkNumber("--max-diff", raw.maxDiff, 1e9, "a difference, 0 to 1e9", over, error) ||
        !checkNumber("--max-share", raw.maxShare, 1, "a share of the pixels, 0 to 1", share, error)) {
        return std::nullopt;
    }
    if (over || share || !options.limits.flipMean) {
        options.limits.shares = {{over.value_or(0), share.value_or(0)}};
    }
    if (raw.exposure.empty()) return options;
    options.exposureEv = parseNumber("--exposure", raw.exposure, -100, 100, "stops, -100 to 100", error);
    if (!options.exposureEv) return std::nullopt;
    if (!options.report.empty()) return options;
    error.text = "--exposure is given without --report, expected both";
    return std::nullopt;
}

} // namespace demos
