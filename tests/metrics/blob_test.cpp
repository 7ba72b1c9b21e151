#include "demos/tools/metrics/blob.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "demos/tools/metrics/compare.h"
#include "demos/tools/metrics/local.h"
#include "tests/metrics/painted.h"

namespace {

/// One character a pixel, rows of seven: what is wrong is '#'.
demos::Wrong found(const std::string& rows) {
    std::vector<float> map;
    for (const char c : rows) map.push_back(c == '#' ? 0.5f : 0.1f);
    return demos::findWrong(map, 7, 0.3);
}

TEST(Blob, IsTheLargestThatTouches) {
    const demos::Wrong wrong = found("##....."
                                     "......#"
                                     ".#..##."
                                     "..##..."
                                     ".......");
    EXPECT_EQ(wrong.pixels, 8u);
    EXPECT_EQ(wrong.largest.pixels, 6u) << "corners touch";
    EXPECT_EQ(wrong.largest.left, 1u);
    EXPECT_EQ(wrong.largest.top, 1u);
    EXPECT_EQ(wrong.largest.width, 6u);
    EXPECT_EQ(wrong.largest.height, 3u);
}

TEST(Blob, TheLargestFewAreKeptInTheirOrder) {
    const demos::Wrong wrong = found("#.#.#.#"
                                     "..#...#"
                                     "......#"
                                     ".......");
    ASSERT_EQ(wrong.blobs.size(), 4u);
    const std::array<uint32_t, 4> lefts = {6, 2, 0, 4};
    for (size_t i = 0; i < lefts.size(); ++i) EXPECT_EQ(wrong.blobs[i].left, lefts[i]);
    EXPECT_EQ(wrong.blobs.front().pixels, wrong.largest.pixels);
    EXPECT_EQ(found("#.#.#.#"
                    "......."
                    "#.#.#.#")
                  .blobs.size(),
              demos::mostBlobs);
}

TEST(Blob, DoesNotGoOnBeyondARow) {
    EXPECT_EQ(found("......#"
                    "#......")
                  .largest.pixels,
              1u);
    EXPECT_EQ(found(".......").largest.pixels, 0u);
    EXPECT_EQ(demos::findWrong({}, 7, 0.3).pixels, 0u);
}

TEST(WorstSquare, IsFoundWhereverItLies) {
    std::vector<float> map(40 * 30, 0.01f);
    for (size_t y = 25; y < 30; ++y)
        for (size_t x = 33; x < 40; ++x) map[y * 40 + x] = 0.51f;
    const demos::Square corner = demos::worstSquare(map, 40, 8);
    EXPECT_NEAR(corner.mean, 0.01 + 0.5 * 35 / 64, 1e-6);
    EXPECT_EQ(corner.left, 32u);
    EXPECT_EQ(corner.top, 22u);
    EXPECT_NEAR(demos::worstSquare(map, 40, 100).mean, 0.01 + 0.5 * 35 / 1200, 1e-6) << "all of it";
    EXPECT_EQ(demos::worstSquare({}, 40, 8).mean, 0);
}

TEST(Blob, FailsWhereAsManyScatteredPixelsPass) {
    const tests::Painted clean = tests::grey(64, 64);
    tests::Painted together = clean, scattered = clean;
    for (int i = 0; i < 16; ++i) {
        together.at(20 + i % 4, 20 + i / 4, 1) = 0;
        scattered.at(8 + 15 * (i % 4), 8 + 15 * (i / 4), 1) = 0;
    }
    demos::Limits limits;
    limits.wrong.blob = 24;
    const auto objections = [&](const tests::Painted& picture) {
        const auto kind = demos::PictureKind::display;
        return demos::objections(demos::compare(clean.view(), picture.view(), kind, limits), limits);
    };
    ASSERT_EQ(objections(together).size(), 1u);
    EXPECT_NE(objections(together).front().find("lie together"), std::string::npos);
    EXPECT_NE(objections(together).front().find("expected at most 24"), std::string::npos);
    EXPECT_TRUE(objections(scattered).empty()) << objections(scattered).front();
}

} // namespace
