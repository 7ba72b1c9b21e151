#include "metrics/flip/seen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/flip/color_space.h"

namespace demos {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Width of the eye's edge and point detectors, in degrees.
constexpr float featureWidthDegrees = 0.082f;

/// A Gaussian of the contrast sensitivity functions, in frequency: a exp(-b f^2), b in degrees squared.
struct Sensitivity {
    float a, b;
};
constexpr Sensitivity achromaticCsf = {1, 0.0047f}, redGreenCsf = {1, 0.0053f};
constexpr Sensitivity wideCsf = {34.1f, 0.04f}, narrowCsf = {13.5f, 0.025f};

template<class Value>
std::vector<float> sample(size_t radius, const Value& value) {
    std::vector<float> weights;
    for (size_t i = 0; i <= radius; ++i) weights.push_back(value(static_cast<float>(i)));
    return weights;
}

/// Over both sides.
float sum(const std::vector<float>& weights) {
    float total = weights.front();
    for (size_t i = 1; i < weights.size(); ++i) total += 2 * weights[i];
    return total;
}

void scale(std::vector<float>& weights, float by) {
    for (float& weight : weights) weight *= by;
}

/// One axis of the Fourier transform of a Gaussian, which is the filter in space.
std::vector<float> gaussian(const Sensitivity& csf, size_t radius, float pixelsPerDegree) {
    return sample(radius, [&](float i) {
        const float degrees = i / pixelsPerDegree;
        return std::exp(-pi * pi * degrees * degrees / csf.b);
    });
}

/// Sum of the filter over both axes.
float volume(const Sensitivity& csf, size_t radius, float pixelsPerDegree) {
    const float along = sum(gaussian(csf, radius, pixelsPerDegree));
    return csf.a * std::sqrt(pi / csf.b) * along * along;
}

Kernel normalised(const Sensitivity& csf, size_t radius, float pixelsPerDegree) {
    constexpr float unseen = 1e-9f; // of a sum of floats
    Kernel kernel{Kernel::Kind::mean, gaussian(csf, radius, pixelsPerDegree)};
    scale(kernel.weights, 1 / sum(kernel.weights));
    while (kernel.weights.size() > 1 && kernel.weights.back() < unseen) kernel.weights.pop_back();
    return kernel;
}

/// Its positive weights sum to 1, its negative ones to -1.
Kernel balanced(Kernel kernel) {
    const bool opposite = kernel.kind == Kernel::Kind::slope;
    float positive = 0, negative = 0;
    for (size_t i = 0; i < kernel.weights.size(); ++i) {
        const float weight = kernel.weights[i], otherSide = opposite ? -weight : weight;
        (weight > 0 ? positive : negative) += weight;
        if (i > 0) (otherSide > 0 ? positive : negative) += otherSide;
    }
    for (float& weight : kernel.weights) weight /= weight > 0 ? positive : -negative;
    return kernel;
}

size_t ceiled(float value) {
    return static_cast<size_t>(std::ceil(value));
}

size_t wholeBlocks(size_t width) {
    return (width + valuesAtOnce - 1) / valuesAtOnce * valuesAtOnce;
}

void toLength(std::vector<float>& x, const std::vector<float>& y) {
    for (size_t i = 0; i < x.size(); ++i) x[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

} // namespace

EyeFilters::EyeFilters(float pixelsPerDegree) {
    // One radius for all colours: three standard deviations of the widest.
    const size_t ofColor = ceiled(3 * std::sqrt(wideCsf.b / (2 * pi * pi)) * pixelsPerDegree);
    achromatic = normalised(achromaticCsf, ofColor, pixelsPerDegree);
    redGreen = normalised(redGreenCsf, ofColor, pixelsPerDegree);
    blueYellowWide = normalised(wideCsf, ofColor, pixelsPerDegree);
    blueYellowNarrow = normalised(narrowCsf, ofColor, pixelsPerDegree);
    const float ofWide = volume(wideCsf, ofColor, pixelsPerDegree);
    wideShare = ofWide / (ofWide + volume(narrowCsf, ofColor, pixelsPerDegree));

    const float deviation = 0.5f * featureWidthDegrees * pixelsPerDegree;
    const size_t ofFeatures = ceiled(3 * deviation);
    const auto bell = [=](float i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    smooth.weights = sample(ofFeatures, bell);
    scale(smooth.weights, 1 / sum(smooth.weights));
    // Lightness is (Y + 16) / 116: what sums to 0 sees nothing of the 16.
    slope = balanced({Kernel::Kind::slope, sample(ofFeatures, [&](float i) { return -i * bell(i); })});
    bend = balanced({Kernel::Kind::bend, sample(ofFeatures, [&](float i) {
                         return (i * i / (deviation * deviation) - 1) * bell(i);
                     })});
    for (Kernel* const kernel : {&slope, &bend}) scale(kernel->weights, 1 / 116.0f);
    radius = std::max(ofColor, ofFeatures);
}

Seen::Seen(const Strip& strip, const EyeFilters& eye, const ToLight& toLight)
    : strip_(strip), eye_(eye), toLight_(toLight), ring_(2 * eye.radius + 1), at_(2 * eye.radius + 1) {
    const size_t width = wholeBlocks(strip.width);
    for (auto* const rows : {&light_, &opponent_})
        for (std::vector<float>& row : *rows) row.resize(width + 2 * eye.radius);
    for (Filtered& filtered : ring_)
        for (std::vector<float>& row : filtered.rows) row.resize(width);
    for (std::vector<float>& row : lab_) row.resize(width);
    for (std::vector<float>* const row : {&narrow_, &edges_, &points_, &other_}) row->resize(width);
}

void Seen::readRow(size_t y) {
    const size_t last = strip_.picture.width - 1, radius = eye_.radius;
    const float* const row = &strip_.picture.rgba[4 * y * strip_.picture.width];
    for (size_t i = 0; i < light_[0].size(); ++i) {
        // Beyond an edge its pixel goes on.
        const size_t x = std::clamp(strip_.left + i, radius, radius + last) - radius;
        for (size_t channel = 0; channel < 3; ++channel) light_[channel][i] = row[4 * x + channel];
    }
    for (std::vector<float>& channel : light_) toLight_(channel);
    for (size_t i = 0; i < light_[0].size(); ++i) {
        const Opponent opponent = opponentOfXyz(xyzOfRgb({light_[0][i], light_[1][i], light_[2][i]}));
        for (size_t channel = 0; channel < 3; ++channel) opponent_[channel][i] = opponent[channel];
    }
}

void Seen::filterAlongX(size_t y, Filtered& to) {
    if (to.y == y) return;
    to.y = y;
    readRow(y);
    const auto filter = [&](size_t channel, const Kernel& kernel, Plane plane) {
        for (size_t i = 0; i < at_.size(); ++i) at_[i] = &opponent_[channel][i];
        weigh(kernel, &at_[eye_.radius], to.rows[plane].data(), to.rows[plane].size());
    };
    filter(0, eye_.achromatic, achromatic);
    filter(1, eye_.redGreen, redGreen);
    filter(2, eye_.blueYellowWide, wide);
    filter(2, eye_.blueYellowNarrow, narrow);
    filter(0, eye_.smooth, smooth);
    filter(0, eye_.slope, slope);
    filter(0, eye_.bend, bend);
}

void Seen::filterAlongY(size_t y, Plane plane, const Kernel& kernel, std::vector<float>& to) {
    const size_t last = strip_.picture.height - 1, radius = eye_.radius;
    for (size_t i = 0; i < at_.size(); ++i) {
        const size_t row = std::clamp(y + i, radius, radius + last) - radius;
        at_[i] = ring_[row % ring_.size()].rows[plane].data();
    }
    weigh(kernel, &at_[radius], to.data(), to.size());
}

void Seen::goTo(size_t y) {
    const size_t first = y - std::min(y, eye_.radius),
                 last = std::min<size_t>(y + eye_.radius, strip_.picture.height - 1);
    for (size_t row = first; row <= last; ++row) filterAlongX(row, ring_[row % ring_.size()]);
    filterAlongY(y, achromatic, eye_.achromatic, lab_[0]);
    filterAlongY(y, redGreen, eye_.redGreen, lab_[1]);
    filterAlongY(y, wide, eye_.blueYellowWide, lab_[2]);
    filterAlongY(y, narrow, eye_.blueYellowNarrow, narrow_);
    toLab();
    filterAlongY(y, slope, eye_.smooth, edges_);
    filterAlongY(y, smooth, eye_.slope, other_);
    toLength(edges_, other_);
    filterAlongY(y, bend, eye_.smooth, points_);
    filterAlongY(y, smooth, eye_.bend, other_);
    toLength(points_, other_);
}

void Seen::toLab() {
    for (size_t i = 0; i < narrow_.size(); ++i) {
        const float blueYellow = narrow_[i] + eye_.wideShare * (lab_[2][i] - narrow_[i]);
        Rgb rgb = rgbOfXyz(xyzOfOpponent({lab_[0][i], lab_[1][i], blueYellow}));
        for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
        const Lab lab = huntAdjusted(labOfXyz(xyzOfRgb(rgb)));
        for (size_t channel = 0; channel < 3; ++channel) lab_[channel][i] = lab[channel];
    }
}

} // namespace demos
