#include "program/compare/pair.h"

#include <algorithm>

#include <cmath>
#include <filesystem>

#include "host/files/image_source.h"
#include "metrics/tolerant.h"
#include "program/compare/blessing.h"
#include "program/compare/picture_pairs.h"
#include "scene/reading/input_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool checkExtension(const fs::path& file, Error& error) {
    if (isPictureName(file)) return true;
    error.text = file.string() + ": '" + file.extension().string() +
                 "' is no known extension, expected .png, .exr or .hdr";
    return false;
}

/// By what the files hold, whatever their names. Null as well when the pictures are of two kinds.
std::optional<PictureKind> commonKind(const CompareOptions& options, const ImageHeader& reference,
                                      const ImageHeader& test, Error& error) {
    if (reference.integer != test.integer) {
        error.text = options.reference.string() + " and " + options.test.string() +
                     ": a PNG is display-encoded, an EXR or HDR linear, expected two of a kind";
        return std::nullopt;
    }
    if (options.exposureEv && reference.integer) {
        error.text = "--exposure is given for PNG, which needs none, expected EXR or HDR";
        return std::nullopt;
    }
    return reference.integer ? PictureKind::display : PictureKind::linear;
}

std::optional<PictureFile> read(const fs::path& file, const std::string& layer, bool large, Error& error,
                                std::vector<float>& spent) {
    const limits::Allowance pixels = large ? limits::largePixels : limits::comparedPixels;
    std::optional<PictureFile> picture =
        readPictureFile(file, {layer, "--layer", true}, pixels, error, std::move(spent));
    // Most errors say what was expected; the libraries' own do not.
    if (!picture && error.text.find(", expected ") == std::string::npos)
        error.text += ", expected a PNG, EXR or HDR picture";
    if (!picture && !large && error.text.ends_with(unpacksFar)) error.text += ", or --large";
    return picture;
}

std::string sizeOf(const Picture& picture) {
    return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

PixelView view(const Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

/// Says what to do about a reference that is not there yet.
bool checkReference(const CompareOptions& options, Error& error) {
    std::error_code code;
    const fs::path& reference = options.reference;
    if (fs::exists(reference, code) || !fs::exists(options.test, code)) return true;
    if (fs::is_symlink(reference, code)) {
        error.text = reference.string() + ": " + unreadable(reference) + ", expected a picture";
        return false;
    }
    error.text = reference.string() +
                 ": no such file, expected a reference: " + blessing(reference, options.test, "--yes") +
                 " makes it";
    return false;
}

using Shares = std::vector<ShareLimit>;

/// Whether a step and the share of pixels that may be off by more are given, and so a limit of their own.
bool isWhole(const Shares& given) {
    return !given.empty() && (given.front().over > 0) == (given.front().share > 0);
}

/// A step alone counts in place of the usual one of any single pixel, a share alone in place of that of
/// noise.
Shares filledShares(const Shares& given, const Shares& usual) {
    if (given.empty()) return usual;
    if (isWhole(given)) return given;
    const ShareLimit& one = given.front();
    Shares shares = usual;
    const auto place = std::find_if(shares.begin(), shares.end(), [&one](const ShareLimit& limit) {
        return (limit.share > 0) == (one.share > 0);
    });
    if (place == shares.end())
        shares.push_back(one);
    else if (one.over > 0)
        place->over = one.over;
    else
        place->share = one.share;
    return shares;
}

/// Of values that are no light, and of which FLIP says nothing: a hundredth may be off by two.
Limits limitsOfData(const CompareOptions& options) {
    Limits limits;
    const Shares& given = options.limits.shares;
    limits.shares = isWhole(given) ? given : Shares{{options.data.value_or(0.02), 0.01}};
    return limits;
}

/// What is given counts before what is tolerated.
Limits limitsOf(const CompareOptions& options, PictureKind kind) {
    if (options.tolerant && kind == PictureKind::linear &&
        isData(options.stages.of(options.reference.filename())))
        return limitsOfData(options);
    Limits limits = options.limits;
    if (!options.tolerant) return limits;
    const Limits tolerant = tolerantLimits(kind);
    const auto fill = [](auto& given, const auto& usual) {
        if (!given) given = usual;
    };
    // Both are of the whole picture: one limit of the user's replaces both.
    if (!limits.flipMean) limits.differenceMean = tolerant.differenceMean;
    fill(limits.flipMean, tolerant.flipMean);
    fill(limits.flipP99, tolerant.flipP99);
    // Likewise of single pixels.
    if (!limits.flipMax) limits.outliers = tolerant.outliers;
    fill(limits.flipMax, tolerant.flipMax);
    fill(limits.flipLocal, tolerant.flipLocal);
    fill(limits.wrong.share, tolerant.wrong.share);
    fill(limits.wrong.blob, tolerant.wrong.blob);
    limits.shares = filledShares(limits.shares, tolerant.shares);
    return limits;
}

/// Sky is as far in both: no distance that could be off.
void levelSky(Picture& a, Picture& b) {
    for (size_t i = 0; i < a.rgba.size(); ++i)
        if (a.rgba[i] == HUGE_VALF && b.rgba[i] == HUGE_VALF) a.rgba[i] = b.rgba[i] = 0;
}

/// Where no objection names a place.
void sayWhere(Pair& pair) {
    const Comparison& found = pair.comparison;
    const auto& blob = pair.limits.wrong.blob;
    const bool named = (blob && found.wrong.largest.pixels > *blob) ||
                       found.notFiniteInReference + found.notFiniteInTest > 0;
    if (pair.objections.empty() || named || found.flipMax == 0) return;
    pair.objections.back() += "; FLIP is greatest at " + toText(found.worst);
}

} // namespace

std::optional<Pair> readPair(const CompareOptions& options, Error& error, SpentPixels spent) {
    if (!checkExtension(options.reference, error) || !checkExtension(options.test, error) ||
        !checkReference(options, error))
        return std::nullopt;
    std::optional<PictureFile> reference =
        read(options.reference, options.referenceLayer, options.large, error, spent.reference);
    if (!reference) return std::nullopt;
    std::optional<PictureFile> test = read(options.test, options.testLayer, options.large, error, spent.test);
    if (!test) return std::nullopt;
    const std::optional<PictureKind> kind = commonKind(options, reference->header, test->header, error);
    if (!kind) return std::nullopt;
    const Picture &expected = reference->picture, &actual = test->picture;
    if (expected.width != actual.width || expected.height != actual.height) {
        error.text = options.reference.string() + " is " + sizeOf(expected) + " and " +
                     options.test.string() + " is " + sizeOf(actual) + ", expected one size";
        return std::nullopt;
    }
    std::optional<Mask> leftOut =
        maskOf(options.leftOut, options.reference, expected.width, expected.height, error);
    if (!leftOut) return std::nullopt;
    Pair pair{std::move(*reference),
              std::move(*test),
              *kind,
              limitsOf(options, *kind),
              std::move(*leftOut),
              {},
              {}};
    if (options.stages.of(options.reference.filename()) == "depth")
        levelSky(pair.reference.picture, pair.test.picture);
    return pair;
}

std::optional<Pair> measurePair(const CompareOptions& options, Error& error, SpentPixels spent) {
    std::optional<Pair> pair = readPair(options, error, std::move(spent));
    if (!pair) return std::nullopt;
    pair->comparison =
        compare(view(pair->expected()), view(pair->actual()), pair->kind, pair->limits, pair->leftOut);
    pair->objections = objections(pair->comparison, pair->limits);
    sayWhere(*pair);
    return pair;
}

std::string joined(const std::vector<std::string>& objections) {
    std::string line;
    for (const std::string& objection : objections) line += (line.empty() ? "" : "; ") + objection;
    return line;
}

} // namespace demos
