#include "measure/picture_error.h"

#include <algorithm>
#include <cmath>

#include "host/timing/pass_samples.h"
#include "metrics/finite.h"
#include "metrics/flip.h"
#include "metrics/psnr.h"

namespace demos::measure {

namespace {

using reference::TruthClass;

constexpr double wrongBy = 0.05;

bool isSound(const Picture& picture, const std::string& name, Error& error) {
    const uint64_t broken = countNotFinite({picture.width, picture.height, picture.rgba});
    if (broken == 0) return true;
    error.text =
        "NaN or infinity in " + std::to_string(broken) + " pixels of the " + name + ", expected none";
    return false;
}

struct Off {
    double squares = 0, most = 0; ///< over red, green and blue
};

Off offAt(size_t pixel, const std::vector<float>& a, const std::vector<float>& b, size_t pixelOfB) {
    Off off;
    for (size_t c = 0; c < 3; ++c) {
        const double by = static_cast<double>(std::abs(a[4 * pixel + c] - b[4 * pixelOfB + c]));
        off.squares += by * by;
        off.most = std::max(off.most, by);
    }
    return off;
}

Off offAt(size_t pixel, const std::vector<float>& a, const std::vector<float>& b) {
    return offAt(pixel, a, b, pixel);
}

enum class Claim { nothing, sky, hit };

/// The class of Aov::reflectionSource.
Claim claimAt(const Picture& sources, size_t pixel) {
    return static_cast<Claim>(std::lround(sources.rgba[4 * pixel + 3]));
}

bool isSolid(TruthClass kind) {
    return kind == TruthClass::recoverable || kind == TruthClass::offScreen || kind == TruthClass::hidden ||
           kind == TruthClass::backFacing || kind == TruthClass::unsampled;
}

TruthClass kindAt(const Picture& classes, size_t pixel) {
    return static_cast<TruthClass>(std::lround(classes.rgba[4 * pixel]));
}

/// Whether all pixels around, too, mirror the sky.
bool isInsideSky(const Picture& classes, size_t pixel) {
    const size_t x = pixel % classes.width, y = pixel / classes.width;
    for (size_t v = y - std::min<size_t>(y, 1); v <= std::min<size_t>(y + 1, classes.height - 1); ++v)
        for (size_t u = x - std::min<size_t>(x, 1); u <= std::min<size_t>(x + 1, classes.width - 1); ++u)
            if (kindAt(classes, v * classes.width + u) != TruthClass::sky) return false;
    return true;
}

class Share {
  public:
    void count(bool is) {
        ++of_;
        if (is) ++among_;
    }
    std::optional<double> value() const {
        if (of_ == 0) return std::nullopt;
        return static_cast<double>(among_) / static_cast<double>(of_);
    }

  private:
    uint64_t among_ = 0, of_ = 0;
};

class Mean {
  public:
    void add(double value) {
        sum_ += value;
        ++count_;
    }
    std::optional<double> value() const {
        if (count_ == 0) return std::nullopt;
        return sum_ / count_;
    }
    /// Of sums of three squares. Not there when nothing differs: no number is infinite.
    std::optional<double> psnr() const {
        if (sum_ == 0) return std::nullopt;
        return psnrDb(sum_ / (3 * count_), 1);
    }

  private:
    double sum_ = 0, count_ = 0;
};

/// In pixels, between where the mirrored point is and where it was taken from.
double positionError(const Picture& truth, const Picture& sources, size_t pixel) {
    const float* const is = &truth.rgba[4 * pixel + 1];
    const float* const found = &sources.rgba[4 * pixel];
    return std::hypot(static_cast<double>(is[0] - found[0]), static_cast<double>(is[1] - found[1]));
}

/// The pixel of the picture in which the mirrored point is seen.
size_t seenAt(const Picture& truth, size_t pixel) {
    const auto at = [](float position, uint32_t size) {
        return static_cast<size_t>(std::clamp(position, 0.0f, static_cast<float>(size) - 1));
    };
    const float* const is = &truth.rgba[4 * pixel + 1];
    return at(is[1], truth.height) * truth.width + at(is[0], truth.width);
}

/// Everything that is counted pixel by pixel.
class Counts {
  public:
    void picture(double flip, const Off& off) {
        flipPicture_.add(flip);
        squaresPicture_.add(off.squares);
    }
    void surface(double flip, const Off& off) {
        flip_.add(flip);
        squaresSurface_.add(off.squares);
        wrong_.count(off.most > wrongBy);
    }
    void insideSky(Claim claim) { falseHitsInside_.count(claim == Claim::hit); }
    void claim(TruthClass kind, Claim claim) {
        if (kind == TruthClass::recoverable) covered_.count(claim == Claim::hit);
        if (kind == TruthClass::sky) falseHits_.count(claim == Claim::hit);
        if (isSolid(kind)) calledSky_.count(claim == Claim::sky);
    }
    void recoverable(const Off& off, const Off& ofExactPlace) {
        squares_.add(off.squares);
        squaresExact_.add(ofExactPlace.squares);
    }
    void found(const Off& off, double positionPx) {
        squaresFound_.add(off.squares);
        positions_.push_back(positionPx);
    }

    PictureError summary() const {
        PictureError error;
        error.flip = flip_.value();
        error.psnrDb = squares_.psnr();
        error.psnrValidDb = squaresFound_.psnr();
        error.psnrExactDb = squaresExact_.psnr();
        error.psnrSurfaceDb = squaresSurface_.psnr();
        error.flipPicture = flipPicture_.value();
        error.psnrPictureDb = squaresPicture_.psnr();
        error.coverage = covered_.value();
        error.falseSkyHits = falseHits_.value();
        error.falseSkyHitsInside = falseHitsInside_.value();
        error.skyOnGeometry = calledSky_.value();
        error.wrongShare = wrong_.value();
        if (positions_.empty()) return error;
        error.positionPxP50 = quantile(positions_, 0.5);
        error.positionPxP95 = quantile(positions_, 0.95);
        error.positionPxMax = quantile(positions_, 1);
        return error;
    }

  private:
    Mean flip_, flipPicture_;
    Mean squares_, squaresFound_, squaresExact_, squaresSurface_, squaresPicture_;
    Share covered_, falseHits_, falseHitsInside_, calledSky_, wrong_;
    std::vector<double> positions_;
};

} // namespace

std::vector<float> displayed(const Picture& picture, double exposureEv) {
    const std::vector<uint8_t> rgb = toneMap(picture, exposureEv);
    std::vector<float> rgba(picture.rgba.size(), 1.0f);
    for (size_t i = 0; i < rgb.size(); ++i) rgba[i / 3 * 4 + i % 3] = static_cast<float>(rgb[i]) / 255;
    return rgba;
}

std::optional<PictureError> errorOf(const reference::Pictures& truth, const Shots& shots, double exposureEv,
                                    Error& error) {
    if (!isSound(truth.color, "reference", error) ||
        !isSound(truth.mirrored, "reference's reflection", error) ||
        !isSound(shots.color, "picture", error) || !isSound(shots.reflection, "reflection", error) ||
        !isSound(shots.sources, "reflection's sources", error) || !isSound(shots.scene, "scene", error))
        return std::nullopt;
    const Picture& classes = truth.truth;
    const std::vector<float> reference = displayed(truth.color, exposureEv),
                             test = displayed(shots.color, exposureEv),
                             mirrored = displayed(truth.mirrored, exposureEv),
                             reflection = displayed(shots.reflection, exposureEv),
                             scene = displayed(shots.scene, exposureEv);
    const std::vector<float> flips =
        flip({classes.width, classes.height, reference}, {classes.width, classes.height, test});
    Counts counts;
    for (size_t i = 0; i < flips.size(); ++i) {
        const auto flipped = static_cast<double>(flips[i]);
        const Off off = offAt(i, reference, test);
        counts.picture(flipped, off);
        const TruthClass kind = kindAt(classes, i);
        if (kind == TruthClass::none) continue;
        const Claim claim = claimAt(shots.sources, i);
        counts.surface(flipped, off);
        counts.claim(kind, claim);
        if (isInsideSky(classes, i)) counts.insideSky(claim);
        if (kind != TruthClass::recoverable) continue;
        const Off mirrorOff = offAt(i, mirrored, reflection);
        counts.recoverable(mirrorOff, offAt(i, mirrored, scene, seenAt(classes, i)));
        if (claim == Claim::hit) counts.found(mirrorOff, positionError(classes, shots.sources, i));
    }
    return counts.summary();
}

} // namespace demos::measure
