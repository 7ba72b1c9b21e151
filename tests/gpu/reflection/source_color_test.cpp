// What colour a reflection takes from the scene, whose texels lie beside the points that are mirrored.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class SourceColor : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {};

// Colours tell places: of one texel alone, a place is off by 0.4 pixels in the median. Half floats tell 0.1.
TEST_P(SourceColor, LiesBetweenTexelsOfAPlane) {
    for (const bool reversed : {true, false}) {
        Camera camera = testCamera();
        camera.reversed = reversed;
        const TracedView traced = Tracer(camera, {{{-9, -1, -12}, {9, 9, -11}}}).run();
        const Score s = score(traced, reflectScene(camera, traced, with(GetParam())));
        print("wall", s);
        EXPECT_LE(s.medianPixels, 0.15);
        EXPECT_LE(s.p95Pixels, 0.3);
    }
}

constexpr Box wall{{-30, -1, -31}, {30, 12, -30}};

/// Pure red where one box is seen, blue where the wall behind it is, green where neither.
TracedView coloredByThing(const Camera& camera, const Box& box) {
    TracedView traced = Tracer(camera, {box, wall}).run();
    const TracedView wallAlone = Tracer(camera, {wall}).run();
    for (size_t i = 0; i < traced.depth.size(); ++i) {
        const bool nothing = traced.depth[i] == 0;
        const bool isWall = !nothing && traced.depth[i] == wallAlone.depth[i];
        const float color[] = {nothing || isWall ? 0.f : 1.f, nothing ? 1.f : 0.f, isWall ? 1.f : 0.f, 1};
        std::ranges::copy(color, traced.color.begin() + static_cast<ptrdiff_t>(i * 4));
    }
    return traced;
}

// A leaning pole, whose edges pass through texels at every share.
TEST_P(SourceColor, ThingsAreNotBlended) {
    Camera camera = testCamera();
    camera.rollDegrees = 8;
    const TracedView traced = coloredByThing(camera, {{-3, -1, -6}, {-1, 2, -5}, 0.2});
    const Reflected result = reflectScene(camera, traced, with(GetParam()));
    size_t red = 0, blue = 0, mixed = 0;
    for (size_t i = 0; i < result.info.size(); ++i) {
        if (reflectionClass(result.info[i]) != ReflectionClass::hit) continue;
        float channels[] = {result.color[i * 4], result.color[i * 4 + 1], result.color[i * 4 + 2]};
        red += channels[0] > 0.9f * result.color[i * 4 + 3];
        blue += channels[2] > 0.9f * result.color[i * 4 + 3];
        std::ranges::sort(channels);
        mixed += channels[1] > 0.06f * channels[2];
    }
    std::printf("%zu red, %zu blue, %zu mixed\n", red, blue, mixed);
    EXPECT_GT(red, 1000u);
    EXPECT_GT(blue, 1000u);
    EXPECT_EQ(mixed, 0u);
}

/// A box in the air over water that nothing lies under, from the height of an eye, rolled, from above and by
/// parallel lines of sight.
std::vector<Camera> aroundTheBox() {
    Camera near;
    near.eye = {0.3, 4, 7};
    near.target = {0.1, 0.3, 0};
    near.width = 256;
    near.height = 192;
    Camera rolled = near;
    rolled.rollDegrees = 33;
    Camera high = near;
    high.eye = {-1, 9, 3};
    Camera parallel = near;
    parallel.parallelHeight = 6;
    parallel.far = 40;
    return {near, rolled, high, parallel};
}

// Beside the pixel by which something is met the far plane may show, whose colour no mirrored ray has met.
TEST_P(SourceColor, IsNotThatOfTheFarPlane) {
    size_t hits = 0, far = 0;
    for (const Camera& camera : aroundTheBox())
        for (const bool cells : {true, false}) {
            TracedView traced = Tracer(camera, {{{-0.5, 0.5, -0.5}, {0.5, 1.5, 0.5}}}).run();
            for (size_t i = 0; i < traced.depth.size(); ++i) {
                const float isFar = traced.depth[i] == 0 ? 1 : 0;
                const float color[] = {isFar, 0, 1 - isFar, 1};
                std::ranges::copy(color, traced.color.begin() + static_cast<ptrdiff_t>(i * 4));
            }
            ReflectorDesc desc = with(GetParam());
            desc.reflection.marchCells = cells;
            const Reflected result = reflectScene(camera, traced, desc);
            for (size_t i = 0; i < result.info.size(); ++i) {
                hits += reflectionClass(result.info[i]) == ReflectionClass::hit;
                far += result.color[i * 4] > 0;
            }
        }
    std::printf("%zu hits, %zu of them on the far plane\n", hits, far);
    EXPECT_GT(hits, 4000u);
    EXPECT_EQ(far, 0u);
}

// Far brighter than those beside it, below zero, or no number: as if it were not there, but for a pixel or
// two.
TEST_P(SourceColor, AFireflyIsNotMirrored) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, {wall}).run();
    const Reflected sound = reflectScene(camera, traced, with(GetParam()));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    constexpr float values[] = {65504, 1e30f, -65504, -1e30f, nan, inf, -inf};
    for (const bool inDepth : {false, true}) {
        // One in 16 x 16: none is beside another, and what each damages adds up.
        TracedView spoiled = traced;
        size_t kind = 0, alone = 0;
        for (size_t y = 3; y < traced.height; y += 16)
            for (size_t x = 3; x < traced.width; x += 16, ++kind) {
                const size_t at = y * traced.width + x;
                const float value = values[kind % std::size(values)];
                if (inDepth)
                    spoiled.depth[at] = value;
                else
                    std::fill_n(&spoiled.color[at * 4], 3, value);
            }
        const Reflected result = reflectScene(camera, spoiled, with(GetParam()));
        size_t damaged = 0;
        for (size_t i = 0; i < result.info.size(); ++i) {
            float off = 0;
            for (size_t c = 0; c < 4; ++c) {
                ASSERT_TRUE(std::isfinite(result.color[i * 4 + c])) << i;
                off = std::max(off, std::abs(result.color[i * 4 + c] - sound.color[i * 4 + c]));
            }
            damaged += off > 1.0f / 255;
            const auto on = [](double of) { return static_cast<size_t>(of) % 16 == 3; };
            alone +=
                traced.truth[i] == Truth::recoverable && on(traced.source[i].x) && on(traced.source[i].y);
        }
        std::printf("%s: %zu mirrored of %zu, %zu damaged\n", inDepth ? "depth" : "color", alone, kind,
                    damaged);
        EXPECT_GT(alone, 20u);
        EXPECT_LE(damaged, alone);
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, SourceColor,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
