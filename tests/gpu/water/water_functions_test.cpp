// Functions of the water's shaders that no picture shows alone, called one by one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "spirv/glitter_patches.comp.h"
#include "spirv/shore_rows.comp.h"
#include "tests/gpu/shaders/shader_functions.h"

namespace {

using namespace tests;

class WaterFunctions : public ShaderFunctions {};

constexpr size_t shoreTrains = 3, shoreRowsOfTrain = 8, shoreArrivals = 16;

/// Arrivals, then the rows of each train, then what no train may reach.
std::vector<glm::vec4> shoreRowsOf(const std::vector<float>& arrivals, const std::vector<float>& swash) {
    std::vector<glm::vec4> rows(shoreArrivals + shoreTrains * shoreRowsOfTrain, glm::vec4(0));
    for (size_t i = 0; i < arrivals.size(); ++i) rows[i].x = arrivals[i];
    for (size_t i = 0; i < shoreTrains * shoreRowsOfTrain; ++i)
        rows[shoreArrivals + i].z = swash[i % shoreRowsOfTrain];
    rows.resize(rows.size() + 64, glm::vec4(1000));
    return rows;
}

TEST_F(WaterFunctions, ArrivalsOutsideOfTheRowsAreThoseOfItsEnds) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> early = {-1, -1e30f, -infinity, std::nanf("")},
                             late = {7.5f, 9, 40, 1e30f, infinity};
    std::vector<float> arrivals = early;
    arrivals.insert(arrivals.end(), late.begin(), late.end());
    const std::vector<glm::vec4> heights =
        told(shore_rows_comp, shoreRowsOf(arrivals, {0.1f, 0.1f, 5, 5, 5, 5, 0.3f, 0.3f}));
    for (size_t i = 0; i < arrivals.size(); ++i)
        EXPECT_NEAR(heights[i].x, i < early.size() ? 0.3f : 0.9f, 1e-5f) << arrivals[i];
}

TEST_F(WaterFunctions, TheWatersEdgeDrawsBackNoFartherThanItsLowest) {
    constexpr float lowest = -1.2f;
    const std::vector<float> swash = {0, -0.2f, -0.35f, -0.5f, -0.7f, -0.9f, -0.3f, 0};
    std::vector<float> arrivals;
    for (int i = 0; i < 13; ++i) arrivals.push_back(0.25f + 0.5f * static_cast<float>(i));
    const std::vector<glm::vec4> edge = told(shore_rows_comp, shoreRowsOf(arrivals, swash));
    size_t held = 0;
    for (size_t i = 0; i < arrivals.size(); ++i) {
        const auto row = static_cast<size_t>(arrivals[i]);
        const float part = arrivals[i] - static_cast<float>(row);
        const float all = 3 * (swash[row] + part * (swash[row + 1] - swash[row]));
        const float rises = 3 * (swash[row] - swash[row + 1]); // rows go back in time
        held += all < lowest ? 1 : 0;
        EXPECT_NEAR(edge[i].x, std::max(all, lowest), 1e-5f) << arrivals[i];
        EXPECT_NEAR(edge[i].y, all > lowest ? -rises : 0.0f, 1e-5f) << arrivals[i];
        EXPECT_NEAR(edge[i].z, all > lowest ? rises : 0.0f, 1e-5f) << arrivals[i];
    }
    EXPECT_GT(held, 3u);
    EXPECT_LT(held, arrivals.size() - 3);
}

TEST_F(WaterFunctions, PatchesOfFacetsVaryTogetherAsTheSlopesDo) {
    struct Place {
        glm::vec4 calm, covariance;
    };
    for (const float both : {-0.025f, 0.0f, 0.025f}) {
        const glm::vec4 covariance(0.04f, 0.03f, both, 0);
        std::vector<Place> places;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                places.push_back(
                    {0.11f * glm::vec4(static_cast<float>(x), static_cast<float>(y), 0, 0), covariance});
        glm::dvec3 sum(0);
        for (const glm::vec4& tilted : told(glitter_patches_comp, places))
            sum += glm::dvec3(tilted.x * tilted.x + tilted.z, tilted.y * tilted.y + tilted.w,
                              tilted.x * tilted.y);
        sum /= static_cast<double>(places.size());
        EXPECT_NEAR(sum.x, 0.04, 0.004) << both;
        EXPECT_NEAR(sum.y, 0.03, 0.003) << both;
        EXPECT_NEAR(sum.z, both, 0.003) << both;
    }
}

} // namespace
