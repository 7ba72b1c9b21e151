#include "metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/color_space.h"
#include "metrics/convolve.h"

namespace demos {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// The paper's exponents, and the knee that gives its lower 40 % of colour differences 95 % of the range.
constexpr float colorExponent = 0.7f, featureExponent = 0.5f;
constexpr float kneeOfRange = 0.4f, kneeOfError = 0.95f;
/// Width of the eye's edge and point detectors, in degrees.
constexpr float featureWidthDegrees = 0.082f;

/// A Gaussian of the contrast sensitivity functions, in frequency: a exp(-b f^2), b in degrees squared.
struct Sensitivity {
    float a, b;
};
constexpr Sensitivity achromatic = {1, 0.0047f}, redGreen = {1, 0.0053f};
constexpr Sensitivity blueYellowWide = {34.1f, 0.04f}, blueYellowNarrow = {13.5f, 0.025f};

using Planes = std::array<Plane, 3>;

template<class Value>
Kernel sample(int radius, const Value& value) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(value(static_cast<float>(i)));
    return kernel;
}

float sum(const Kernel& kernel) {
    float total = 0;
    for (const float weight : kernel) total += weight;
    return total;
}

void scale(Kernel& kernel, float by) {
    for (float& weight : kernel) weight *= by;
}

/// What of a picture the eye resolves: each opponent channel through its contrast sensitivity.
class Eye {
  public:
    explicit Eye(float pixelsPerDegree) : pixelsPerDegree_(pixelsPerDegree) {
        // One radius for all: three standard deviations of the widest.
        radius_ =
            static_cast<int>(std::ceil(3 * std::sqrt(blueYellowWide.b / (2 * pi * pi)) * pixelsPerDegree));
        achromatic_ = normalised(achromatic);
        redGreen_ = normalised(redGreen);
        wide_ = normalised(blueYellowWide);
        narrow_ = normalised(blueYellowNarrow);
        wideShare_ = volume(blueYellowWide) / (volume(blueYellowWide) + volume(blueYellowNarrow));
    }

    Planes operator()(const Planes& opponent) const {
        Plane blueYellow = convolve(opponent[2], wide_, wide_);
        const Plane narrow = convolve(opponent[2], narrow_, narrow_);
        for (size_t i = 0; i < narrow.values.size(); ++i) {
            blueYellow.values[i] = std::lerp(narrow.values[i], blueYellow.values[i], wideShare_);
        }
        return {convolve(opponent[0], achromatic_, achromatic_), convolve(opponent[1], redGreen_, redGreen_),
                std::move(blueYellow)};
    }

  private:
    /// One axis of the Fourier transform of a Gaussian, which is the filter in space.
    Kernel gaussian(const Sensitivity& csf) const {
        return sample(radius_, [&](float i) {
            const float degrees = i / pixelsPerDegree_;
            return std::exp(-pi * pi * degrees * degrees / csf.b);
        });
    }
    Kernel normalised(const Sensitivity& csf) const {
        Kernel kernel = gaussian(csf);
        scale(kernel, 1 / sum(kernel));
        return kernel;
    }
    /// Sum of the filter over both axes.
    float volume(const Sensitivity& csf) const {
        const float along = sum(gaussian(csf));
        return csf.a * std::sqrt(pi / csf.b) * along * along;
    }

    float pixelsPerDegree_, wideShare_ = 0;
    int radius_ = 0;
    Kernel achromatic_, redGreen_, wide_, narrow_;
};

/// Edges and points in the lightness of a picture: lengths of its first and second derivatives.
struct Features {
    Plane edges, points;
};

class FeatureDetector {
  public:
    explicit FeatureDetector(float pixelsPerDegree) {
        const float deviation = 0.5f * featureWidthDegrees * pixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3 * deviation));
        const auto bell = [=](float i) { return std::exp(-i * i / (2 * deviation * deviation)); };
        smooth_ = sample(radius, bell);
        scale(smooth_, 1 / sum(smooth_));
        slope_ = balanced(sample(radius, [&](float i) { return -i * bell(i); }));
        bend_ = balanced(
            sample(radius, [&](float i) { return (i * i / (deviation * deviation) - 1) * bell(i); }));
    }

    Features operator()(const Plane& lightness) const {
        return {length(convolve(lightness, slope_, smooth_), convolve(lightness, smooth_, slope_)),
                length(convolve(lightness, bend_, smooth_), convolve(lightness, smooth_, bend_))};
    }

  private:
    /// Its positive weights sum to 1, its negative ones to -1.
    static Kernel balanced(Kernel kernel) {
        float positive = 0, negative = 0;
        for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
        for (float& weight : kernel) weight /= weight > 0 ? positive : -negative;
        return kernel;
    }
    static Plane length(Plane x, const Plane& y) {
        for (size_t i = 0; i < x.values.size(); ++i) x.values[i] = std::hypot(x.values[i], y.values[i]);
        return x;
    }

    Kernel smooth_, slope_, bend_;
};

/// Colours fade as it darkens (the Hunt effect).
Lab huntAdjusted(const Lab& lab) {
    return {lab[0], 0.01f * lab[0] * lab[1], 0.01f * lab[0] * lab[2]};
}

/// HyAB, for large differences of colour (Abasi, Amani Tehran and Fairchild 2020).
float colorDistance(const Lab& a, const Lab& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// The greatest that sRGB holds: between its green and its blue.
float greatestColorDistance() {
    return colorDistance(huntAdjusted(labOfXyz(xyzOfRgb({0, 1, 0}))),
                         huntAdjusted(labOfXyz(xyzOfRgb({0, 0, 1}))));
}

float colorError(float distance, float greatest) {
    const float error = std::pow(distance, colorExponent), knee = kneeOfRange * greatest;
    if (error < knee) return kneeOfError * error / knee;
    return kneeOfError + (1 - kneeOfError) * (error - knee) / (greatest - knee);
}

Planes opponentPlanes(const Image& linear) {
    Planes planes;
    for (Plane& plane : planes) plane = {linear.width, linear.height, std::vector<float>(linear.pixels())};
    for (size_t i = 0; i < linear.pixels(); ++i) {
        const float* const rgb = &linear.rgba[4 * i];
        const Opponent opponent = opponentOfXyz(xyzOfRgb({rgb[0], rgb[1], rgb[2]}));
        for (size_t channel = 0; channel < 3; ++channel) planes[channel].values[i] = opponent[channel];
    }
    return planes;
}

/// A picture as the eye has it: its colours, and what stands out.
struct Seen {
    Planes colors; ///< opponent, filtered
    Features features;

    Lab color(size_t i) const {
        const Opponent opponent = {colors[0].values[i], colors[1].values[i], colors[2].values[i]};
        Rgb rgb = rgbOfXyz(xyzOfOpponent(opponent));
        for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
        return huntAdjusted(labOfXyz(xyzOfRgb(rgb)));
    }
};

Seen see(const Image& linear, const Eye& eye, const FeatureDetector& detect) {
    const Planes opponent = opponentPlanes(linear);
    Plane lightness = opponent[0];
    for (float& value : lightness.values) value = (value + 16) / 116;
    return {eye(opponent), detect(lightness)};
}

} // namespace

std::vector<float> flipOfLinear(const Image& reference, const Image& test, float pixelsPerDegree) {
    const Eye eye(pixelsPerDegree);
    const FeatureDetector detect(pixelsPerDegree);
    const Seen a = see(reference, eye, detect), b = see(test, eye, detect);
    const float greatest = std::pow(greatestColorDistance(), colorExponent);
    std::vector<float> map(reference.pixels());
    for (size_t i = 0; i < map.size(); ++i) {
        const float color = colorError(colorDistance(a.color(i), b.color(i)), greatest);
        const float edges = std::abs(a.features.edges.values[i] - b.features.edges.values[i]);
        const float points = std::abs(a.features.points.values[i] - b.features.points.values[i]);
        const float feature =
            std::pow(std::max(edges, points) / std::numbers::sqrt2_v<float>, featureExponent);
        map[i] = std::pow(color, 1 - std::min(feature, 1.0f));
    }
    return map;
}

std::vector<float> flip(const Image& reference, const Image& test, float pixelsPerDegree) {
    const auto decoded = [](const Image& image) {
        std::vector<float> linear(image.rgba.begin(), image.rgba.end());
        for (float& value : linear) value = decodeSrgb(std::clamp(value, 0.0f, 1.0f));
        return linear;
    };
    const std::vector<float> a = decoded(reference), b = decoded(test);
    return flipOfLinear({reference.width, reference.height, a}, {test.width, test.height, b},
                        pixelsPerDegree);
}

} // namespace demos
