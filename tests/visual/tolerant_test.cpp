// Defects planted in a golden picture, and which of the tolerant limits catches each; and what no limit may
// call one.
#include "demos/tools/metrics/tolerant.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"

namespace {

using demos::Picture;

constexpr int width = 160, height = 90;

/// The middle of one: FLIP takes its time.
Picture middleOf(const std::string& name) {
    demos::Error error;
    const std::string file = SEAGLASS_SOURCE "/tests/visual/golden/" + name + "/color.png";
    const std::optional<Picture> whole = demos::readPicture(file, error);
    if (!whole) throw std::runtime_error(error.text);
    Picture middle{width, height, {}};
    for (size_t y = 0; y < height; ++y) {
        const float* const row = &whole->rgba[4 * ((27 + y) * whole->width + 48)];
        middle.rgba.insert(middle.rgba.end(), row, row + 4 * size_t{width});
    }
    return middle;
}

/// Boats at a pier, its poles, and their mirror images.
const Picture& golden() {
    static const Picture picture = middleOf("harbour_level");
    return picture;
}

size_t at(int x, int y, int channel) {
    return static_cast<size_t>(4 * (y * width + x) + channel);
}

float goldenAt(int x, int y, int channel) {
    return golden().rgba[at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1), channel)];
}

struct Box {
    int left = 0, top = 0, wide = width, high = height;
};

/// `change(value, x, y, channel)` in place of each value of a box.
Picture changed(const std::function<float(float, int, int, int)>& change, const Box& box = {}) {
    Picture picture = golden();
    for (int y = box.top; y < box.top + box.high; ++y) {
        for (int x = box.left; x < box.left + box.wide; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                float& value = picture.rgba[at(x, y, channel)];
                value = change(value, x, y, channel);
            }
        }
    }
    return picture;
}

/// A box shows what is `dx`, `dy` from it.
Picture moved(int dx, int dy, const Box& box = {}) {
    return changed([=](float, int x, int y, int channel) { return goldenAt(x + dx, y + dy, channel); }, box);
}

Picture filled(float value, const Box& box) {
    return changed([=](float, int, int, int) { return value; }, box);
}

Picture added(float value, const Box& box = {}) {
    return changed([=](float old, int, int, int) { return std::clamp(old + value, 0.0f, 1.0f); }, box);
}

Picture noisy(float amplitude, float share, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    return changed([&](float old, int, int, int) {
        const float by = amplitude * (2 * unit(random) - 1);
        return unit(random) < share ? std::clamp(old + by, 0.0f, 1.0f) : old;
    });
}

demos::PixelView view(const Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

std::string judge(const Picture& reference, const Picture& test) {
    const auto kind = demos::PictureKind::display;
    const demos::Limits limits = demos::tolerantLimits(kind);
    const demos::Comparison found = demos::compare(view(reference), view(test), kind, limits);
    std::string all;
    for (const std::string& objection : demos::objections(found, limits)) all += objection + "; ";
    return all;
}

struct Defect {
    const char* name;
    const char* caughtBy; ///< part of an objection
    Picture picture;
};

constexpr const char *mean = "mean FLIP", *fine = "mean difference", *p99 = "99th percentile",
                     *blob = "lie together", *local = "of the square", *step = "off by more than 0.01176",
                     *single = "off by more than 0.35", *notFinite = "NaN";

std::vector<Defect> localDefects() {
    const auto glow = [](float value, int x, int y, int) {
        const float distance = std::hypot(static_cast<float>(x - 120), static_cast<float>(y - 30)) / 20;
        return std::min(value + 0.15f * std::exp(-distance * distance), 1.0f);
    };
    return {
        {"one NaN", notFinite, filled(std::numeric_limits<float>::quiet_NaN(), {100, 50, 1, 1})},
        {"one infinity", notFinite, filled(std::numeric_limits<float>::infinity(), {100, 50, 1, 1})},
        {"one white pixel in the water", single, filled(1, {130, 85, 1, 1})},
        {"one black pixel in the sky", single, filled(0, {100, 2, 1, 1})},
        {"fireflies", single, noisy(1, 0.002f, 1)},
        {"a seam across, a pixel wide", blob, added(-0.1f, {0, 60, width, 1})},
        {"a seam down, a pixel wide", blob, added(0.1f, {80, 0, 1, height})},
        {"a pole is missing", blob, moved(8, 0, {74, 44, 5, 26})},
        {"a mirror image is missing", blob, moved(-60, 0, {70, 60, 40, 20})},
        {"a mirror image is moved by a pixel", blob, moved(1, 0, {0, 50, width, 40})},
        {"a mirror image is moved down by two", mean, moved(0, 2, {0, 50, width, 40})},
        {"a logo is missing in a corner", blob, filled(0.9f, {width - 18, height - 10, 14, 6})},
        {"a tiny logo is missing in a corner", blob, filled(0.9f, {width - 8, height - 8, 4, 4})},
        {"a black tile", blob, filled(0, {64, 48, 8, 8})},
        {"a tile of another place", blob, moved(32, 20, {64, 48, 16, 16})},
        {"the last row is black", blob, filled(0, {0, height - 1, width, 1})},
        {"the last column is black", blob, filled(0, {width - 1, 0, 1, height})},
        {"the sun elsewhere", p99, changed(glow)},
        {"another gamma in a corner", local,
         changed([](float old, int, int, int) { return std::pow(old, 1.05f); }, {0, 0, 24, 24})},
        {"a stale tile, a pixel off", local, moved(1, 0, {64, 40, 16, 16})},
        {"a faint overlay", blob,
         changed([](float old, int, int, int) { return 0.85f * old + 0.15f; }, {12, 70, 40, 12})},
        {"a small part is mirrored", blob,
         changed([](float, int x, int y, int c) { return goldenAt(163 - x, y, c); }, {70, 44, 24, 16})},
        {"a contact shadow is missing", blob,
         changed([](float old, int, int, int) { return std::min(1.3f * old, 1.0f); }, {40, 66, 16, 5})},
        {"two surfaces fight in a place", blob,
         changed([](float old, int x, int y, int) { return (7 * x + 5 * y) % 4 < 2 ? old : 0.7f * old; },
                 {70, 44, 20, 12})},
        {"a hull has another hue", local,
         changed(
             [](float old, int x, int y, int c) { return 0.8f * old + 0.2f * goldenAt(x, y, (c + 1) % 3); },
             {72, 44, 14, 10})},
        {"a texture is of a mip level too coarse", p99,
         changed([](float v, int x, int y,
                    int c) { return (v + goldenAt(x + 1, y, c) + goldenAt(x, y + 1, c)) / 3; },
                 {52, 33, 40, 30})},
        {"two by two pixels are stuck at black", single, filled(0, {80, 80, 2, 2})},
        {"a block of eight by eight is stuck", blob,
         changed([](float, int, int, int c) { return goldenAt(75, 51, c); }, {72, 48, 8, 8})},
        {"a tile is 5 % darker", local,
         changed([](float old, int, int, int) { return 0.95f * old; }, {64, 48, 16, 16})},
        {"a line a pixel wide is missing", local, moved(2, 0, {75, 40, 1, 25})},
        {"a row is three pixels off", p99, moved(3, 0, {0, 60, width, 1})},
        {"whitecaps are off", blob,
         changed([](float old, int, int, int) { return std::min(old, 0.55f); }, {90, 55, 14, 9})},
    };
}

std::vector<Defect> wholeDefects() {
    const auto of = [](const std::function<float(float)>& value) {
        return changed([&value](float old, int, int, int) { return value(old); });
    };
    return {
        {"black", mean, filled(0, {})},
        {"white", mean, filled(1, {})},
        {"the upper half is black", mean, filled(0, {0, 0, width, height / 2})},
        {"moved by a pixel", mean, moved(1, 0)},
        {"moved down by a pixel", mean, moved(0, 1)},
        {"mirrored", mean, changed([](float, int x, int y, int c) { return goldenAt(width - 1 - x, y, c); })},
        {"upside down", mean,
         changed([](float, int x, int y, int c) { return goldenAt(x, height - 1 - y, c); })},
        {"red and blue swapped", mean,
         changed([](float, int x, int y, int c) { return goldenAt(x, y, 2 - c); })},
        {"no antialiasing", mean,
         changed([](float, int x, int y, int c) { return goldenAt(x / 2 * 2, y / 2 * 2, c); })},
        {"a ghost of the last frame", mean,
         changed([](float v, int x, int y, int c) { return 0.92f * v + 0.08f * goldenAt(x + 6, y, c); })},
        {"no vignette", mean, changed([](float v, int x, int y, int) {
             const float dx = static_cast<float>(x - 80) / 80, dy = static_cast<float>(y - 45) / 45;
             return v * (1 - 0.04f * (dx * dx + dy * dy));
         })},
        {"red is a pixel off", mean,
         changed([](float v, int x, int y, int c) { return c == 0 ? goldenAt(x + 1, y, 0) : v; })},
        {"without colour", mean, changed([](float, int x, int y, int) { return goldenAt(x, y, 1); })},
        {"without red", mean, changed([](float v, int, int, int c) { return c == 0 ? 0 : v; })},
        {"yellower", mean, changed([](float v, int, int, int c) { return c == 2 ? 0.97f * v : v; })},
        {"gamma off by 2 %", mean, of([](float v) { return std::pow(v, 1.02f); })},
        {"gamma applied twice", mean, of([](float v) { return std::pow(v, 2.2f); })},
        {"3 % darker", mean, of([](float v) { return 0.97f * v; })},
        {"3 % brighter", mean, of([](float v) { return std::min(1.03f * v, 1.0f); })},
        {"less contrast", mean, of([](float v) { return 0.5f + 0.95f * (v - 0.5f); })},
        {"a step of 255 too bright", mean, added(1.0f / 255)},
        {"four bits", mean, of([](float v) { return std::round(v * 15) / 15; })},
        {"five bits", step, of([](float v) { return std::round(v * 31) / 31; })},
        {"dithering changed", mean, noisy(2.0f / 255, 1, 7)},
        {"every other pixel is a step of 255 off", fine, changed([](float v, int x, int y, int) {
             return std::clamp(v + ((x + y) % 2 ? 1.0f : -1.0f) / 255, 0.0f, 1.0f);
         })},
        {"noise", step, noisy(0.06f, 1, 2)},
        {"the upper half is half a pixel off", mean,
         changed([](float v, int x, int y, int c) { return (v + goldenAt(x, y + 1, c)) / 2; },
                 {0, 0, width, height / 2})},
        {"mirror images are 10 % too dark", mean,
         changed([](float v, int, int, int) { return 0.9f * v; }, {0, 50, width, 40})},
        {"the right half is 1 % brighter", mean,
         changed([](float v, int, int, int) { return std::min(1.01f * v, 1.0f); },
                 {width / 2, 0, width / 2, height})},
        {"another hue by 2 %", mean, changed([](float v, int x, int y, int c) {
             return 0.98f * v + 0.02f * goldenAt(x, y, (c + 1) % 3);
         })},
        {"rows are swapped in pairs", mean,
         changed([](float, int x, int y, int c) { return goldenAt(x, y ^ 1, c); })},
        {"blacks are grey", mean, of([](float v) { return 0.02f + 0.98f * v; })},
        {"every other row is darker", step,
         changed([](float v, int, int y, int) { return y % 2 ? 0.9f * v : v; })},
        {"blurred", mean,
         changed([](float v, int x, int y, int c) { return (v + goldenAt(x + 1, y, c)) / 2; })},
        {"another scene", mean, middleOf("ocean_level")},
        {"the water is not drawn", mean, filled(0.2f, {0, 50, width, 40})},
        {"nothing is above the horizon", mean, filled(0.7f, {0, 0, width, 50})},
    };
}

void expectCaught(const std::vector<Defect>& defects) {
    for (const Defect& defect : defects) {
        const std::string words = judge(golden(), defect.picture);
        EXPECT_NE(words.find(defect.caughtBy), std::string::npos) << defect.name << ": " << words;
    }
}

TEST(TolerantLimits, CatchWhatIsWrongInAPlace) {
    expectCaught(localDefects());
}

TEST(TolerantLimits, CatchWhatIsWrongAllOver) {
    expectCaught(wholeDefects());
}

// docs/screenshot-tests.md lists them all.
TEST(TolerantLimits, AreJustifiedByTheTableInTheDocument) {
    std::ifstream file(SEAGLASS_SOURCE "/docs/screenshot-tests.md");
    const std::string document{std::istreambuf_iterator<char>(file), {}};
    size_t count = 0;
    for (const auto& defects : {localDefects(), wholeDefects()}) {
        for (const Defect& defect : defects) {
            const std::string row = std::string("| ") + defect.name + " | " + defect.caughtBy + " |\n";
            EXPECT_NE(document.find(row), std::string::npos) << row;
            ++count;
        }
    }
    EXPECT_GE(count, 40u);
}

/// What rounding does to any picture: the last bit, and an edge that moves by a pixel here and there.
void expectRoundingPasses(const Picture& picture, const std::string& name) {
    EXPECT_EQ(judge(picture, picture), "") << name;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    Picture rounded = picture;
    for (float& value : rounded.rgba) {
        const float by = (2 * unit(random) - 1) / 255;
        if (unit(random) < 0.2f) value = std::clamp(value + by, 0.0f, 1.0f);
    }
    EXPECT_EQ(judge(picture, rounded), "") << name << ", the last bit";
    Picture edges = picture;
    for (int i = 0; i < 8; ++i) {
        const auto after = [&](int channel) { return picture.rgba[at(11 + 17 * i, 30 + 7 * i, channel)]; };
        for (int channel = 0; channel < 3; ++channel)
            edges.rgba[at(10 + 17 * i, 30 + 7 * i, channel)] = after(channel);
    }
    EXPECT_EQ(judge(picture, edges), "") << name << ", edges";
}

TEST(TolerantLimits, LetRoundingPass) {
    for (const char* name :
         {"floor_level", "harbour_level", "harbour_high", "lake_near", "ocean_level", "ocean_high",
          "pool_near", "shore_near", "storm_near", "underwater_middle", "underwater_straddle"})
        expectRoundingPasses(middleOf(name), name);
}

TEST(TolerantLimits, TakeLightAsWell) {
    const demos::Limits limits = demos::tolerantLimits(demos::PictureKind::linear);
    const auto judged = [&](const Picture& picture) {
        return demos::objections(
            demos::compare(view(golden()), view(picture), demos::PictureKind::linear, limits), limits);
    };
    EXPECT_TRUE(judged(golden()).empty());
    EXPECT_TRUE(judged(noisy(0.001f, 0.1f, 3)).empty());
    EXPECT_FALSE(judged(moved(8, 0, {74, 44, 5, 26})).empty());
}

} // namespace
