#include "program/compare/compare_options.h"

#include <CLI/CLI.hpp>

#include "program/compare/values.h"

namespace demos {

namespace {

constexpr const char* compareExamples =
    R"(Without a limit, any difference of colour is one too many. --tolerant allows what rounding does, and no lost
mast; a limit that is given as well counts instead of its own. A mean forgives a spot: --max-pixel and --max-blob
do not. NaN or infinity in either picture always fails. Only colour is compared: of an EXR its unnamed layer, or
the one of a beauty pass' name; what else it holds is listed. A PNG's gamma and
primaries are brought to sRGB and named; a colour profile is named alone.

Of two folders all pictures are compared, those in folders of theirs too, by their names; what is in one alone
differs. Numbered pictures, such as color_0000.png, are a sequence, whose changes are compared as well. Of
intermediates in a picture's folder the first that differs is named.

Examples:
  seaglass compare golden.png mine.png --max-flip 0.02 --max-diff 0.1 --max-share 0.001
  seaglass compare before.exr after.exr --report out/report
  seaglass compare screenshots/ out/ --tolerant --junit out/compared.xml

Exit codes: 0 the same within the limits, 1 different, 2 bad input, or no room for what was to be written.)";

/// Of sequences, with --tolerant.
constexpr double tolerantFlicker = 0.2;

/// Sets `out` if the option is there.
bool checkNumber(const char* option, const std::string& text, double most, const char* expected,
                 std::optional<double>& out, Error& error) {
    if (text.empty()) return true;
    out = parseNumber(option, text, 0, most, expected, error);
    return out.has_value();
}

bool checkLimits(const RawCompare& raw, CompareOptions& options, Error& error) {
    Limits& limits = options.limits;
    std::optional<double> over, share, wrong;
    constexpr const char *flip = "a FLIP, 0 to 1", *pixels = "a share of the pixels, 0 to 1";
    if (!checkNumber("--max-flip", raw.maxFlip, 1, "a mean FLIP, 0 to 1", limits.flipMean, error) ||
        !checkNumber("--max-p99", raw.maxP99, 1, flip, limits.flipP99, error) ||
        !checkNumber("--max-local", raw.maxLocal, 1, flip, limits.flipLocal, error) ||
        !checkNumber("--max-pixel", raw.maxPixel, 1, flip, limits.flipMax, error) ||
        !checkNumber("--wrong", raw.wrong, 1, flip, wrong, error) ||
        !checkNumber("--max-wrong", raw.maxWrong, 1, pixels, limits.wrong.share, error) ||
        !checkNumber("--max-diff", raw.maxDiff, 1e9, "a difference, 0 to 1e9", over, error) ||
        !checkNumber("--max-data", raw.maxData, 1e9, "a difference, 0 to 1e9", options.data, error) ||
        !checkNumber("--max-share", raw.maxShare, 1, pixels, share, error)) {
        return false;
    }
    if (!checkNumber("--max-flicker", raw.maxFlicker, 1, "a share of the reference's change, 0 to 1",
                     options.flicker, error))
        return false;
    if (raw.tolerant && !options.flicker) options.flicker = tolerantFlicker;
    if (!raw.maxBlob.empty()) {
        const std::optional<uint32_t> blob = parseCount("--max-blob", raw.maxBlob, 1u << 25, error);
        if (!blob) return false;
        limits.wrong.blob = *blob;
    }
    if (wrong && !limits.wrong.share && !limits.wrong.blob && !raw.tolerant) {
        error.text = "--wrong is given alone, expected --max-wrong, --max-blob or --tolerant beside it";
        return false;
    }
    if (options.data && !raw.tolerant) {
        error.text = "--max-data is given without --tolerant, expected both";
        return false;
    }
    limits.wrong.over = wrong.value_or(limits.wrong.over);
    const bool none = !raw.tolerant && !limits.flipMean && !limits.flipP99 && !limits.flipMax &&
                      !limits.flipLocal && !limits.wrong.share && !limits.wrong.blob;
    if (over || share || none) limits.shares = {{over.value_or(0), share.value_or(0)}};
    return true;
}

void describeScreenshots(CLI::App& command, RawCompare& raw) {
    command
        .add_option("--max-flicker", raw.maxFlicker,
                    "The change from frame to frame of a sequence in folders may be more or less than the "
                    "reference's by the share P of it, 0 to 1; 0.2 if --tolerant")
        ->type_name("P");
    command
        .add_option("--ignore", raw.ignored,
                    "Leave out a rectangle: WIDTHxHEIGHT+LEFT+TOP in pixels; may be given several times")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false)
        ->type_name("RECT");
    command
        .add_option(
            "--mask", raw.mask,
            "Leave out what is black in a PNG of the pictures' size; that beside the reference if not "
            "given: NAME.mask.png for NAME.png, NAME.exr and NAME_0000.png")
        ->type_name("FILE");
    command
        .add_option("--stages", raw.stages,
                    "What intermediates beside a picture are called, in the order in which they are made: "
                    "depth,shadow,color; the names of seaglass render --aov if not given")
        ->delimiter(',')
        ->type_name("NAMES");
    command
        .add_option(
            "--driver", raw.driver,
            "What made the test's pictures; 'auto' is this machine's first Vulkan device, 'auto:NAME' the "
            "first of that name. Where references are of another driver, differences are advice: exit "
            "code 0")
        ->type_name("TEXT");
}

} // namespace

void describeCompare(CLI::App& command, RawCompare& raw) {
    command.footer(compareExamples);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command.add_option("REFERENCE", raw.reference, "PNG (display-encoded), EXR or HDR (linear), or a folder");
    command.add_option("TEST", raw.test, "The picture to judge, of the same kind and size, or a folder");
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
    command.add_flag("--tolerant", raw.tolerant,
                     "Limits for one renderer on one driver before and after a change, where none is given");
    command.add_option("--max-p99", raw.maxP99, "99 % of pixels may have a FLIP of X, 0 to 1")
        ->type_name("X");
    command.add_option("--max-local", raw.maxLocal, "Any 16x16 pixels may have a mean FLIP of X, 0 to 1")
        ->type_name("X");
    command.add_option("--max-pixel", raw.maxPixel, "Any pixel may have a FLIP of X, 0 to 1")->type_name("X");
    command
        .add_option("--wrong", raw.wrong,
                    "Pixels of a FLIP over X are wrong, for the next two; 0.15 if not given")
        ->type_name("X");
    command.add_option("--max-wrong", raw.maxWrong, "The share P of pixels, 0 to 1, may be wrong")
        ->type_name("P");
    command.add_option("--max-blob", raw.maxBlob, "N wrong pixels may touch each other")->type_name("N");
    command
        .add_option("--max-data", raw.maxData,
                    "With --tolerant: a hundredth of depth, height, normals, foam and classes may be off by "
                    "more than X, 0.02 if not given")
        ->type_name("X");
    describeScreenshots(command, raw);
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
    command.add_option("--junit", raw.junit, "Write what failed as JUnit's XML, for CI")->type_name("FILE");
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
    options.junit = raw.junit;
    options.tolerant = raw.tolerant;
    options.leftOut.mask = raw.mask;
    for (const std::string& text : raw.ignored) {
        const std::optional<Region> region = parseRegion("--ignore", text, error);
        if (!region) return std::nullopt;
        options.leftOut.regions.push_back(*region);
    }
    options.stages = Stages(raw.stages);
    options.driver = raw.driver;
    if (raw.layers.size() > 2) {
        error.text = "--layer is given " + std::to_string(raw.layers.size()) +
                     " times, expected one for both pictures, or the reference's and the test's";
        return std::nullopt;
    }
    if (!raw.layers.empty()) {
        options.referenceLayer = raw.layers.front();
        options.testLayer = raw.layers.back();
    }
    if (!checkLimits(raw, options, error)) return std::nullopt;
    if (raw.exposure.empty()) return options;
    options.exposureEv = parseNumber("--exposure", raw.exposure, -100, 100, "stops, -100 to 100", error);
    if (!options.exposureEv) return std::nullopt;
    if (!options.report.empty()) return options;
    error.text = "--exposure is given without --report, expected both";
    return std::nullopt;
}

} // namespace demos
