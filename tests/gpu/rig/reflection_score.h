// How far a reflection is from the traced truth.
#pragma once

#include <algorithm>
#include <cstdio>
#include <vector>

#include "seaglass/reflection.h"
#include "tests/gpu/rig/traced_scene.h"

namespace tests {

/// What a technique left for a view.
struct Reflected {
    std::vector<float> color; ///< RGBA
    std::vector<float> info;  ///< see ReflectionImages::info
};

struct Score {
    double coverage = 0;     ///< share of recoverable pixels that were hit
    double medianPixels = 0; ///< error of the source's position
    double p95Pixels = 0;
    double falseOnSky = 0;    ///< share of true sky that was hit
    double skyOnGeometry = 0; ///< share of recoverable pixels called sky
    double misplaced = 0;     ///< share of hits that are off by more than misplacedPixels
    double p90Distance = 0;   ///< error of the distance to what is mirrored, as a share of it
};

constexpr double misplacedPixels = 4;

inline double quantile(std::vector<double>& values, double q) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

inline Score score(const TracedView& view, const Reflected& result) {
    double recoverable = 0, hits = 0, sky = 0, falseHits = 0, falseSky = 0;
    std::vector<double> errors, distances;
    for (size_t i = 0; i < view.truth.size(); ++i) {
        const auto found = seaglass::reflectionClass(result.info[i]);
        if (view.truth[i] == Truth::sky) {
            ++sky;
            falseHits += found == seaglass::ReflectionClass::hit;
        }
        if (view.truth[i] != Truth::recoverable) continue;
        ++recoverable;
        falseSky += found == seaglass::ReflectionClass::sky;
        if (found != seaglass::ReflectionClass::hit) continue;
        ++hits;
        distances.push_back(std::abs(double{result.info[i]} / view.distance[i] - 1));
        const double confidence = double{result.color[i * 4 + 3]};
        if (confidence < 0.1) continue; // faded out at the border: its colour has no digits left
        const double light = double{result.color[i * 4 + 2]}; // undersides are darker than their tops
        const glm::dvec2 position(result.color[i * 4] / light * view.width,
                                  result.color[i * 4 + 1] / light * view.height);
        errors.push_back(glm::length(position - view.source[i]));
    }
    const auto misplaced = static_cast<double>(
        std::ranges::count_if(errors, [](double error) { return error > misplacedPixels; }));
    return {hits / recoverable,      quantile(errors, 0.5),
            quantile(errors, 0.95),  falseHits / std::max(sky, 1.0),
            falseSky / recoverable,  misplaced / std::max(hits, 1.0),
            quantile(distances, 0.9)};
}

inline void print(const char* what, const Score& s) {
    std::printf("%-8s coverage %.4f, position error %.3f px median %.3f px p95, hits on sky %.5f, sky on "
                "geometry %.5f, distance off by %.4f p90\n",
                what, s.coverage, s.medianPixels, s.p95Pixels, s.falseOnSky, s.skyOnGeometry, s.p90Distance);
}

} // namespace tests
