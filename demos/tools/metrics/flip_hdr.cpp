#include "metrics/flip_hdr.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace demos {

namespace {

constexpr int mostExposures = 33;
constexpr double shownAs = 0.85, middleGrey = 0.18;

/// The curve (a x^2 + b x) / (c x^2 + d x + e) of Krzysztof Narkowicz, "ACES Filmic Tone Mapping Curve"
/// (2016), with the exposure of 0.6 that it is made for.
constexpr double gain = 0.6;
constexpr double a = 2.51 * gain * gain, b = 0.03 * gain, c = 2.43 * gain * gain, d = 0.59 * gain, e = 0.14;

float toneMapped(float light) {
    // Divided by x^2, which may be too large for any number.
    constexpr float least = 1e-15f;
    const float dark = 1 / std::max(light, least);
    const float shown = (float(a) + float(b) * dark) / (float(c) + float(d) * dark + float(e) * dark * dark);
    return light > 0 ? std::min(shown, 1.0f) : 0.0f;
}

/// The light that is shown as `shownAs`: the positive root of a quadratic.
double lightShown() {
    const double square = a - shownAs * c, half = (b - shownAs * d) / (2 * square);
    return -half + std::sqrt(half * half + shownAs * e / square);
}

std::vector<double> luminances(const PixelView& image) {
    std::vector<double> found;
    for (size_t i = 0; i < image.pixels(); ++i) {
        const auto light = [&](size_t channel) {
            return std::max(static_cast<double>(image.rgba[4 * i + channel]), 0.0);
        };
        found.push_back(0.2126 * light(0) + 0.7152 * light(1) + 0.0722 * light(2));
    }
    return found;
}

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::optional<ExposureRange> rangeOf(const PixelView& image) {
    std::vector<double> light = luminances(image);
    if (median(light) == 0) std::erase(light, 0.0);
    if (light.empty()) return std::nullopt;
    const double shown = lightShown(), brightest = *std::max_element(light.begin(), light.end());
    ExposureRange range = {std::log2(shown / brightest), std::log2(shown / median(light)), 2};
    const double stops = std::ceil(range.stopEv - range.startEv);
    range.count = static_cast<int>(std::clamp(stops, 2.0, static_cast<double>(mostExposures)));
    return range;
}

} // namespace

ExposureRange exposureRange(const PixelView& reference) {
    return rangeOf(reference).value_or(ExposureRange{});
}

double middleGreyEv(const ExposureRange& range) {
    return range.stopEv + std::log2(middleGrey / lightShown());
}

HdrFlip hdrFlip(const PixelView& reference, const PixelView& test, float pixelsPerDegree) {
    HdrFlip result;
    result.exposures = rangeOf(reference).value_or(exposureRange(test));
    result.map.resize(reference.pixels());
    const ExposureRange& range = result.exposures;
    for (int i = 0; i < range.count; ++i) {
        const double ev = std::lerp(range.startEv, range.stopEv, i / static_cast<double>(range.count - 1));
        const double exposure = std::exp2(ev);
        const auto show = [exposure](std::vector<float>& row) {
            for (float& value : row)
                value = toneMapped(static_cast<float>(exposure * static_cast<double>(value)));
        };
        const std::vector<float> map = flipOf(reference, test, show, pixelsPerDegree);
        std::transform(map.begin(), map.end(), result.map.begin(), result.map.begin(),
                       [](float one, float other) { return std::max(one, other); });
    }
    return result;
}

} // namespace demos
