#include "program/compare/visualise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "program/painted.h"

namespace demos {

namespace {

Rgb grey(float value) {
    return {value, value, value};
}

/// The greatest finite magnitude of the first channel.
float largest(const Picture& picture) {
    float most = 0;
    for (size_t i = 0; i < picture.rgba.size(); i += 4) {
        const float value = std::abs(picture.rgba[i]);
        if (std::isfinite(value)) most = std::max(most, value);
    }
    return most;
}

Visualised height(const Picture& picture) {
    const float most = std::max(largest(picture), 1e-6f);
    std::array<char, 64> scale{};
    std::snprintf(scale.data(), scale.size(), "black %.3g m, white %.3g m", static_cast<double>(-most),
                  static_cast<double>(most));
    return {painted(picture, [most](const float* p) { return grey(0.5f + 0.5f * p[0] / most); }),
            scale.data()};
}

Visualised normal(const Picture& picture) {
    const auto toRgb = [](const float* p) {
        const bool none = p[0] == 0 && p[1] == 0 && p[2] == 0;
        return none ? grey(0) : Rgb{0.5f + 0.5f * p[0], 0.5f + 0.5f * p[1], 0.5f + 0.5f * p[2]};
    };
    return {painted(picture, toRgb), {}};
}

Visualised depth(const Picture& picture) {
    const float farthest = std::max(largest(picture), 1e-3f);
    float nearest = farthest;
    for (size_t i = 0; i < picture.rgba.size(); i += 4) {
        if (picture.rgba[i] > 0) nearest = std::min(nearest, picture.rgba[i]);
    }
    const float span = std::max(std::log(farthest / nearest), 1e-3f);
    const auto toRgb = [&](const float* p) {
        return grey(std::isfinite(p[0]) ? 1 - std::log(std::max(p[0], nearest) / nearest) / span : 0.0f);
    };
    std::array<char, 64> scale{};
    std::snprintf(scale.data(), scale.size(), "white %.3g m, black %.4g m, logarithmic",
                  static_cast<double>(nearest), static_cast<double>(farthest));
    return {painted(picture, toRgb), scale.data()};
}

Visualised source(const Picture& picture) {
    const auto width = static_cast<float>(picture.width), height = static_cast<float>(picture.height);
    const auto toRgb = [=](const float* p) { return Rgb{p[0] / width, p[1] / height, 0}; };
    std::array<char, 64> scale{};
    std::snprintf(scale.data(), scale.size(), "red across %u pixels, green down %u", picture.width,
                  picture.height);
    return {painted(picture, toRgb), scale.data()};
}

} // namespace

Visualised visualise(const Picture& picture, Aov aov, double exposureEv) {
    switch (aov) {
    case Aov::color:
    case Aov::reflection:
    case Aov::scene:
        return {toneMap(picture, exposureEv), {}};
    case Aov::reflectionClass:
    case Aov::overlayDepth:
    case Aov::overlayPlane:
    case Aov::overlayClasses:
    case Aov::overlayConfidence:
    case Aov::overlayDistance:
        return {paintedAsIs(picture), {}};
    case Aov::height:
        return height(picture);
    case Aov::normal:
        return normal(picture);
    case Aov::foam:
        return {painted(picture, [](const float* p) { return grey(p[0]); }), {}};
    case Aov::depth:
        return depth(picture);
    case Aov::reflectionSource:
        return source(picture);
    }
    return {};
}

} // namespace demos
