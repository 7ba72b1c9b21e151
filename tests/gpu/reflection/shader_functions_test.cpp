// Functions of shaders that no picture shows alone, called one by one.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

#include "spirv/footprints.comp.h"
#include "spirv/hidden_ways.comp.h"
#include "spirv/looked_up_tiles.comp.h"
#include "spirv/march_stride_hits.comp.h"
#include "spirv/marched_ways.comp.h"
#include "spirv/source_colors.comp.h"
#include "spirv/squares.comp.h"
#include "tests/gpu/shaders/shader_functions.h"

namespace {

using namespace tests;

TEST_F(ShaderFunctions, AFootprintSpansAsFarAsItsSteps) {
    std::vector<glm::vec4> steps;
    for (int i = 0; i < 24; ++i)
        for (const float lean : {-0.9f, -0.3f, 0.0f, 0.4f, 1.2f}) {
            const float angle = 0.26f * static_cast<float>(i);
            steps.push_back(
                {std::cos(angle), std::sin(angle), lean - 3 * std::sin(angle), 3 * std::cos(angle)});
            steps.push_back(
                {4 * std::cos(angle), 4 * std::sin(angle), lean - std::sin(angle), std::cos(angle)});
        }
    const std::vector<glm::vec4> axes = told(footprints_comp, steps);
    double worst = 0;
    for (size_t i = 0; i < steps.size(); ++i)
        for (int k = 0; k < 32; ++k) {
            // How far an ellipse reaches along any line: the same by the steps that span it and by its axes.
            const double turn = 0.0982 * k;
            const glm::dvec2 line(std::cos(turn), std::sin(turn));
            const auto reach = [&](const glm::vec4& pair) {
                return std::hypot(glm::dot(line, glm::dvec2(pair.x, pair.y)),
                                  glm::dot(line, glm::dvec2(pair.z, pair.w)));
            };
            worst = std::max(worst, std::abs(reach(axes[i]) / reach(steps[i]) - 1));
        }
    EXPECT_LT(worst, 1e-3);
}

TEST_F(ShaderFunctions, TilesThatShowAPixelOrStandBesideOneAreLookedUp) {
    constexpr int edge = 8;
    std::vector<glm::ivec4> given;
    for (const int shift : {0, 1})
        for (const glm::ivec4& window : {glm::ivec4(0, 0, 64, 64), glm::ivec4(9, 17, 33, 40),
                                         glm::ivec4(15, 16, 17, 18), glm::ivec4(8, 7, 41, 23)})
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) {
                    given.push_back(window);
                    given.emplace_back(x, y, shift, 0);
                }
    const std::vector<glm::vec4> looked = told(looked_up_tiles_comp, given);
    size_t some = 0;
    for (size_t i = 0; i < given.size(); i += 2) {
        const glm::ivec4 &window = given[i], &tile = given[i + 1];
        // Pixels of the region from one before the tile's to one behind them.
        const auto meets = [&](int at, int low, int high) {
            return ((edge * at - 1) << tile.z) < high && ((edge * (at + 1) + 1) << tile.z) > low;
        };
        const bool expected = meets(tile.x, window.x, window.z) && meets(tile.y, window.y, window.w);
        EXPECT_EQ(looked[i].x != 0, expected)
            << tile.x << "," << tile.y << " of " << window.x << ".." << window.z;
        EXPECT_EQ(looked[i].y, 0) << "sees no plane";
        some += expected ? 1 : 0;
    }
    EXPECT_GT(some, 100u);
}

TEST_F(ShaderFunctions, ARayIsFollowedBackToWhereItWentIn) {
    std::vector<glm::vec4> ways;
    for (int deep = 0; deep < 60; ++deep) ways.emplace_back(100, 180, 100.5 + deep, 20.5);
    for (int deep = 0; deep < 60; ++deep) ways.emplace_back(20, 101, 100.5 - deep, 220.5);
    ways.emplace_back(100, 240, 200.5, 20.5);  // farther than it is followed
    ways.emplace_back(100, 180, 130.5, 110.5); // it comes from behind the wall
    const std::vector<glm::vec4> entries = told(hidden_ways_comp, ways);
    for (size_t i = 0; i + 2 < ways.size(); ++i) {
        const float seen = ways[i].w < ways[i].z ? 99 : 101; // beside column 100, the wall's outermost
        EXPECT_EQ(entries[i], glm::vec4(seen, 100, 100.5f, 0.5f)) << i;
    }
    for (size_t i = ways.size() - 2; i < ways.size(); ++i) EXPECT_EQ(entries[i].x, -1) << i;
}

// Of the ray that march_stride_hits.comp follows, by columns.
float rayDepthAt(float column) {
    return 0.9f - 0.8f / 200 * column;
}

// Between two strides a receding ray may pass behind a wall by more than that is thick.
TEST_F(ShaderFunctions, AStrideIsAsThickAsTheRayRecedesOverIt) {
    std::vector<glm::vec4> walls;
    for (int i = 10; i < 180; ++i) {
        const auto column = static_cast<float>(i);
        walls.emplace_back(column, 1000, rayDepthAt(column + 0.75f), 0);
    }
    const std::vector<glm::vec4> hits = told(march_stride_hits_comp, walls);
    for (size_t i = 0; i < walls.size(); ++i) {
        EXPECT_EQ(hits[i].x, 1) << walls[i].x;
        EXPECT_NEAR(hits[i].y, walls[i].x + 0.75f, 1) << walls[i].x;
    }
}

// Of a wall's last column the ray may go behind what lies past the middle, and nothing shows there any more.
TEST_F(ShaderFunctions, ARayIsComparedOverTheWholePixel) {
    std::vector<glm::vec4> walls;
    for (int stride = 1; stride < 8; ++stride) {
        const auto column = static_cast<float>(25 * stride);
        for (const float past : {0.2f, 0.4f, 0.6f, 0.8f})
            walls.emplace_back(column - 5, column + 1, rayDepthAt(column + past), 0);
    }
    const std::vector<glm::vec4> hits = told(march_stride_hits_comp, walls);
    for (size_t i = 0; i < walls.size(); ++i) EXPECT_EQ(hits[i].x, i % 4 < 2) << walls[i].x;
}

TEST_F(ShaderFunctions, OutOfWhatIsThinARayComesAfterItWasMet) {
    constexpr int refused = 0, closely = 3, underside = 4, met = 5; // march.glsl
    const std::vector<glm::ivec4> ways = {
        {closely, underside, 1, 0}, // a plank, which the ray then leaves
        {closely, underside, 0, 0}, // what was passed by was no such thing: the underside is all that is
                                    // known
        {refused, underside, 0, 0},
        {closely, met, 1, 0},
        {closely, refused, 1, 0},
    };
    const float expected[][2] = {{25, met}, {50, underside}, {50, underside}, {50, met}, {25, closely}};
    const std::vector<glm::vec4> ends = told(marched_ways_comp, ways);
    for (size_t i = 0; i < ways.size(); ++i) {
        EXPECT_FLOAT_EQ(ends[i].x, expected[i][0]) << i;
        EXPECT_EQ(ends[i].y, expected[i][1]) << i;
    }
}

TEST_F(ShaderFunctions, CellsAndBlocksHoldEachPixel) {
    std::vector<glm::ivec4> sizes;
    for (int i = 1; i < 140; ++i) sizes.emplace_back(i, 3 * i % 137 + 1, 0, 0);
    const std::vector<glm::vec4> squares = told(squares_comp, sizes);
    const auto holding = [](int pixels, int edge) { return static_cast<float>((pixels - 1) / edge + 1); };
    for (size_t i = 0; i < sizes.size(); ++i) {
        const glm::ivec4& size = sizes[i];
        EXPECT_EQ(squares[i],
                  glm::vec4(holding(size.x, 8), holding(size.y, 8), holding(size.x, 64), holding(size.y, 64)))
            << size.x << "x" << size.y;
    }
}

// No ray meets the far plane under the mirror's horizon: beside a far wall, whose depth is hardly told from
// it, none of its colour is blended in. Over the horizon it is the sky.
TEST_F(ShaderFunctions, WhatNoRayMeetsIsNotBlendedIn) {
    constexpr float farWall = 1e-6f, step = 1e-5f, edge = 8; // the wall's last column is the one before
    std::vector<glm::vec4> points;
    for (const float under : {0.0f, 1.0f})
        for (const float column : {6.2f, 6.9f, 7.4f, 7.6f, 7.9f})
            points.emplace_back(column, farWall, step, under);
    const std::vector<glm::vec4> colors = told(source_colors_comp, points);
    for (size_t i = 0; i < points.size(); ++i) {
        const float beyond = std::max(points[i].x + 0.5f - edge, 0.0f);
        EXPECT_NEAR(colors[i].x, points[i].w > 0 ? 1 : 1 - 0.9f * beyond, 1e-4f)
            << points[i].x << ", " << points[i].w;
    }
}

} // namespace
