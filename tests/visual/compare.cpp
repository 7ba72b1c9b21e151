#include "tests/visual/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tests {

using demos::Picture;

Difference compare(const Picture& expected, const Picture& actual, const Limits& limits) {
    Difference difference;
    difference.sameSize = expected.width == actual.width && expected.height == actual.height;
    if (!difference.sameSize || expected.rgba.empty()) return difference;
    const size_t pixels = expected.rgba.size() / 4;
    for (size_t i = 0; i < pixels; ++i) {
        double worst = 0;
        for (size_t channel = 0; channel < 3; ++channel) {
            const double off = std::abs(static_cast<double>(expected.rgba[4 * i + channel]) -
                                        static_cast<double>(actual.rgba[4 * i + channel]));
            // A NaN would pass every comparison below.
            const double counted = std::isfinite(off) ? off : 1.0;
            worst = std::max(worst, counted);
            difference.mean += counted;
        }
        difference.most = std::max(difference.most, worst);
        difference.shareSmall += worst > limits.small ? 1 : 0;
        difference.shareLarge += worst > limits.large ? 1 : 0;
    }
    difference.mean /= static_cast<double>(3 * pixels);
    difference.shareSmall /= static_cast<double>(pixels);
    difference.shareLarge /= static_cast<double>(pixels);
    return difference;
}

std::string objections(const Difference& difference, const Limits& limits) {
    if (!difference.sameSize) return "the pictures differ in size; ";
    std::string all;
    const auto object = [&all](const char* what, double found, double limit) {
        if (found <= limit) return;
        char text[160];
        std::snprintf(text, sizeof(text), "%s is %.3g, expected at most %.3g; ", what, found, limit);
        all += text;
    };
    object("share of pixels off by a little", difference.shareSmall, limits.shareSmall);
    object("share of pixels off by a lot", difference.shareLarge, limits.shareLarge);
    object("mean difference", difference.mean, limits.mean);
    return all;
}

uint64_t countNotFinite(const Picture& picture) {
    uint64_t count = 0;
    for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
        const auto begin = picture.rgba.begin() + static_cast<std::ptrdiff_t>(i);
        count += std::all_of(begin, begin + 4, [](float value) { return std::isfinite(value); }) ? 0 : 1;
    }
    return count;
}

std::vector<uint8_t> differencePicture(const Picture& expected, const Picture& actual) {
    std::vector<uint8_t> rgb;
    for (size_t i = 0; i < std::min(expected.rgba.size(), actual.rgba.size()); ++i) {
        if (i % 4 == 3) continue;
        const float off = std::clamp(0.5f + 10 * (actual.rgba[i] - expected.rgba[i]), 0.0f, 1.0f);
        rgb.push_back(static_cast<uint8_t>(std::lround(off * 255)));
    }
    return rgb;
}

} // namespace tests
