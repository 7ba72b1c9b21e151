#include "host/lens/meter.h"

#include <algorithm>
#include <cmath>

namespace demos {

namespace {

constexpr double middle = 0.22;    ///< luminance that the mean is brought to
constexpr double brightest = 4;    ///< what all but a twentieth should stay below: a display's 236 of 255
constexpr double protection = 0.5; ///< share of the stops above it that is taken back

/// Of the pixels that have light.
std::vector<double> luminances(const Picture& picture) {
    std::vector<double> all;
    for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
        const float* const p = &picture.rgba[i];
        const double luminance = 0.2126 * static_cast<double>(p[0]) + 0.7152 * static_cast<double>(p[1]) +
                                 0.0722 * static_cast<double>(p[2]);
        if (std::isfinite(luminance) && luminance > 0) all.push_back(luminance);
    }
    return all;
}

} // namespace

double meteredEv(const Picture& picture) {
    std::vector<double> all = luminances(picture);
    if (all.empty()) return 0;
    double sum = 0;
    for (const double luminance : all) sum += std::log2(luminance);
    const double ev = std::log2(middle) - sum / static_cast<double>(all.size());
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 19 / 20);
    std::nth_element(all.begin(), high, all.end());
    return std::clamp(ev - protection * std::max(ev + std::log2(*high / brightest), 0.0), -20.0, 20.0);
}

} // namespace demos
