// All measures of two pictures at once, and whether they are within limits. A mean forgives a spot and a
// maximum forgives nothing, so both are there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/blob.h"
#include "metrics/difference.h"
#include "metrics/flip_hdr.h"
#include "metrics/local.h"
#include "metrics/outlier.h"

namespace demos {

/// Display-encoded 0..1, as in a PNG, or linear light without limit, as in an EXR.
enum class PictureKind { display, linear };

/// At most `share` of the pixels may differ by more than `over` in some channel.
struct ShareLimit {
    double over = 0, share = 0;
    bool around = false; ///< only those that the other picture has nothing like within a pixel
};

/// Of pixels whose FLIP is over `over`, and of those whose alpha is off by more. Those that lie together are
/// a thing that is lost, or one too many.
struct WrongLimit {
    double over = 0.15;
    std::optional<double> share;  ///< of all pixels
    std::optional<uint64_t> blob; ///< pixels that touch each other
};

/// What is not given is not looked at, but for NaN and infinity, which always fail.
struct Limits {
    std::optional<double> flipMean;
    std::optional<double> differenceMean;
    std::vector<ShareLimit> shares;
    std::optional<double> flipP99 = {};
    std::optional<double> flipMax = {};   ///< of any single pixel
    std::optional<double> flipLocal = {}; ///< of the mean of any square of localSide pixels a side
    WrongLimit wrong = {};
    std::optional<uint64_t> outliers = {}; ///< of light: see findOutliers()
};

/// One value a pixel: others than 0 are left out. Empty: none is.
using Mask = std::vector<uint8_t>;

/// "120,45"
std::string toText(const Place& place);

/// Of the squares of Limits::flipLocal, in pixels.
constexpr uint32_t localSide = 16;

struct Comparison {
    bool sameSize = false;                                  ///< else nothing below is filled in
    size_t leftOut = 0;                                     ///< pixels; all measures are of the rest
    uint64_t notFiniteInReference = 0, notFiniteInTest = 0; ///< pixels; the other measures are over the rest
    Place brokenReference, brokenTest;                      ///< the first of those, where there are some
    Difference difference;
    double psnrDb = 0; ///< infinite when equal; of the peak 1, or the reference's greatest when linear
    double flipMean = 0, flipP99 = 0, flipMax = 0;
    Place worst;                ///< where FLIP is greatest
    Square local;               ///< where its mean is
    std::vector<float> flipMap; ///< 1 where there is NaN or infinity
    Wrong wrong;                ///< by Limits::wrong
    double alphaShare = 0;      ///< of pixels whose alpha is off by more than Limits::wrong
    Outliers outliers;          ///< when linear
    ExposureRange exposures;    ///< of HDR-FLIP, when linear
    std::vector<double> shares; ///< of pixels, for each of Limits::shares

    size_t compared() const { return flipMap.size() - leftOut; }
    double wrongShare() const {
        return compared() == 0 ? 0 : static_cast<double>(wrong.pixels) / static_cast<double>(compared());
    }
};

Comparison compare(const PixelView& reference, const PixelView& test, PictureKind kind, const Limits& limits,
                   const Mask& leftOut = {});

/// The greatest of the measures as a multiple of its limit: over 1 where there are objections, infinite where
/// there is NaN or where nothing at all is allowed.
double badness(const Comparison& comparison, const Limits& limits);

/// What is beyond the limits, in words; empty when nothing is.
std::vector<std::string> objections(const Comparison& comparison, const Limits& limits);

} // namespace demos
