#include "measure/picture_error.h"

#include <algorithm>
#include <cmath>

#include "metrics/flip.h"
#include "metrics/psnr.h"
#include "reference/truth.h"

namespace demos::measure {

namespace {

using reference::TruthClass;

constexpr double wrongBy = 0.05;

std::vector<float> displayed(std::span<const uint8_t> rgb) {
    std::vector<float> rgba(rgb.size() / 3 * 4, 1.0f);
    for (size_t i = 0; i < rgb.size(); ++i) rgba[i / 3 * 4 + i % 3] = static_cast<float>(rgb[i]) / 255;
    return rgba;
}

enum class Claim { nothing, sky, hit };

Claim claimAt(const Shots& shots, Answers answers, size_t pixel) {
    if (answers == Answers::sky) return Claim::sky;
    const float* const color = &shots.classes->rgba[pixel * 4]; // green a hit, blue the sky, red unknown
    if (color[1] > 0.5f) return Claim::hit;
    return color[2] > 0.5f ? Claim::sky : Claim::nothing;
}

bool isSolid(TruthClass kind) {
    return kind == TruthClass::recoverable || kind == TruthClass::offScreen || kind == TruthClass::hidden ||
           kind == TruthClass::backFacing;
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

/// FLIP and PSNR over some pixels.
class Mean {
  public:
    void add(double flip, double squares) {
        flip_ += flip;
        squares_ += squares;
        ++pixels_;
    }
    std::optional<double> flip() const {
        if (pixels_ == 0) return std::nullopt;
        return flip_ / pixels_;
    }
    /// Not there when nothing differs: no number is infinite.
    std::optional<double> psnr() const {
        if (squares_ == 0) return std::nullopt;
        return psnrDb(squares_ / (3 * pixels_), 1);
    }

  private:
    double flip_ = 0, squares_ = 0, pixels_ = 0;
};

} // namespace

PictureError errorOf(const Shots& shots, Answers answers) {
    const Picture& truth = *shots.truth;
    const std::vector<float> reference = displayed(shots.reference), test = displayed(shots.test);
    const std::vector<float> flips =
        flip({truth.width, truth.height, reference}, {truth.width, truth.height, test});
    Mean water, whole;
    Share covered, falseHits, calledSky, wrong;
    for (size_t i = 0; i < flips.size(); ++i) {
        double squares = 0, most = 0;
        for (size_t c = 4 * i; c < 4 * i + 3; ++c) {
            const double by = static_cast<double>(std::abs(reference[c] - test[c]));
            squares += by * by;
            most = std::max(most, by);
        }
        whole.add(static_cast<double>(flips[i]), squares);
        const auto kind = static_cast<TruthClass>(std::lround(truth.rgba[4 * i]));
        if (kind == TruthClass::none) continue;
        water.add(static_cast<double>(flips[i]), squares);
        wrong.count(most > wrongBy);
        const Claim claim = claimAt(shots, answers, i);
        if (kind == TruthClass::recoverable) covered.count(claim == Claim::hit);
        if (kind == TruthClass::sky) falseHits.count(claim == Claim::hit);
        if (isSolid(kind)) calledSky.count(claim == Claim::sky);
    }
    PictureError error;
    error.flip = water.flip();
    error.psnrDb = water.psnr();
    error.flipPicture = whole.flip();
    error.psnrPictureDb = whole.psnr();
    error.coverage = covered.value();
    error.falseSkyHits = falseHits.value();
    error.skyOnGeometry = calledSky.value();
    error.wrongShare = wrong.value();
    return error;
}

} // namespace demos::measure
