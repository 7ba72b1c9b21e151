// What goes on beyond the picture's border is mirrored as if it did: ReflectionDesc::edgeReach.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr float share = 0.2f;

/// Walls beside a canal; the picture holds their lower halves and of the sky only what shows between.
std::vector<Box> walls() {
    return {{{-9, -1, -40}, {-6, 9, 8}}, {{6, -1, -40}, {9, 9, 8}}};
}

Camera intoTheCanal() {
    Camera camera = testCamera();
    camera.eye = {0, 2, 10};
    camera.target = {0, 0.6, 0};
    camera.fovDegrees = 45;
    camera.rollDegrees = 20;
    return camera;
}

ReflectorDesc reaching(ReflectionTechnique technique, float reach) {
    ReflectorDesc desc = with(technique);
    desc.reflection.edgeReach = reach;
    return desc;
}

/// How many pixels a point lies outside of the picture, by the farther of both ways.
double beyondThePicture(const TracedView& traced, const glm::dvec2& point) {
    const glm::dvec2 size(traced.width, traced.height);
    const glm::dvec2 off = glm::max(-point, point - size);
    return std::max(off.x, off.y);
}

bool isHit(const Reflected& reflected, size_t i) {
    return reflectionClass(reflected.info[i]) == ReflectionClass::hit;
}

class EdgeReach : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {
  protected:
    Reflected reflected(const Camera& camera, const TracedView& traced, float reach) {
        return reflectScene(camera, traced, reaching(GetParam(), reach));
    }
};

TEST_P(EdgeReach, WallsGoOnBeyondTheBorder) {
    for (const bool reversed : {true, false}) {
        Camera camera = intoTheCanal();
        camera.reversed = reversed;
        const TracedView traced = Tracer(camera, walls()).run();
        const Reflected plain = reflected(camera, traced, 0);
        const Reflected result = reflected(camera, traced, share);
        size_t near = 0, plainHits = 0, found = 0, wrong = 0;
        double farther = 0; // in the mean, as a share
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            if (traced.truth[i] != Truth::lost) continue;
            const double beyond = beyondThePicture(traced, traced.source[i]);
            if (beyond < 2 || beyond > 0.8 * double{share} * camera.height) continue;
            ++near;
            plainHits += isHit(plain, i);
            if (!isHit(result, i)) continue;
            const bool right =
                std::abs(double{result.info[i]} - traced.distance[i]) < 0.02 * traced.distance[i];
            ++(right ? found : wrong);
            if (right) farther += double{result.info[i]} / traced.distance[i] - 1;
        }
        farther /= static_cast<double>(found);
        std::printf("%zu near beyond the border: %zu found without, %zu with, farther by %.5f, %zu at wrong "
                    "distances\n",
                    near, plainHits, found, farther, wrong);
        EXPECT_GT(near, 2000u);
        EXPECT_LT(plainHits, near / 50);
        EXPECT_GT(found, near * 9 / 10);
        EXPECT_LT(wrong, near / 50);
        // No pixel that the border is off by.
        EXPECT_NEAR(farther, 0, 0.002);
    }
}

// Hits that fade at the border join what lies beyond without a dip.
TEST_P(EdgeReach, NothingFadesAtTheBorderWhereItGoesOn) {
    const Camera camera = intoTheCanal();
    const TracedView traced = Tracer(camera, walls()).run();
    const Reflected plain = reflected(camera, traced, 0);
    const Reflected result = reflected(camera, traced, share);
    size_t faded = 0, whole = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::recoverable || !isHit(plain, i) || plain.color[i * 4 + 3] > 0.9f)
            continue;
        ++faded;
        whole += result.color[i * 4 + 3] > 0.99f;
        EXPECT_EQ(plain.info[i], result.info[i]);
    }
    std::printf("%zu faded, %zu of them no longer\n", faded, whole);
    EXPECT_GT(faded, 500u);
    EXPECT_GT(whole, faded * 9 / 10);
}

// Its colours are those of the same line inside of the border, as in a mirror that stands there.
TEST_P(EdgeReach, WhatLiesBeyondLooksAsWhatLiesInside) {
    const Camera camera = intoTheCanal();
    const TracedView traced = Tracer(camera, walls()).run();
    const Reflected result = reflected(camera, traced, share);
    size_t compared = 0, alike = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        const double beyond = beyondThePicture(traced, traced.source[i]);
        if (traced.truth[i] != Truth::lost || beyond < 2 || !isHit(result, i)) continue;
        const double confidence = double{result.color[i * 4 + 3]};
        if (confidence < 0.5) continue;
        const glm::dvec2 from(result.color[i * 4] / confidence * traced.width,
                              result.color[i * 4 + 1] / confidence * traced.height);
        ++compared;
        alike += std::abs(beyondThePicture(traced, from) + beyond) < 3;
    }
    std::printf("%zu compared, %zu as far inside\n", compared, alike);
    EXPECT_GT(compared, 2000u);
    EXPECT_GT(alike, compared * 9 / 10);
}

// Between rails at the border the sky shows, too: a line along which something else shows is of no plane.
TEST_P(EdgeReach, WhatIsNoPlaneDoesNotGoOn) {
    Camera camera = testCamera();
    camera.rollDegrees = 50;
    std::vector<Box> rails;
    for (int i = 0; i < 16; ++i) rails.push_back({{-9, 0.5 * i, -6}, {20, 0.5 * i + 0.2, -5.8}});
    const TracedView traced = Tracer(camera, rails).run();
    const Score plain = score(traced, reflected(camera, traced, 0));
    const Score s = score(traced, reflected(camera, traced, share));
    print("rails", plain);
    print("rails", s);
    EXPECT_LE(s.falseOnSky, plain.falseOnSky + 0.004);
}

TEST_P(EdgeReach, WhatTheBorderCutsOffIsAllThatChanges) {
    std::vector<Pose> all = poses();
    std::ranges::copy(parallelPoses(), std::back_inserter(all));
    for (const Pose& pose : all) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Score plain = score(traced, reflected(pose.camera, traced, 0));
        const Reflected result = reflected(pose.camera, traced, share);
        const Score s = score(traced, result);
        print(pose.name, s);
        EXPECT_TRUE(std::ranges::all_of(result.color, [](float value) { return std::isfinite(value); }));
        EXPECT_TRUE(std::ranges::all_of(result.info, [](float value) { return std::isfinite(value); }));
        EXPECT_LE(s.falseOnSky, plain.falseOnSky + 0.004) << pose.name;
        EXPECT_GE(s.coverage, plain.coverage) << pose.name;
        // Those that had faded out count now.
        EXPECT_LE(s.p95Pixels, plain.p95Pixels + 0.1) << pose.name;
    }
}

// A stand that leans over the more the higher: what goes on as the plane that the border shows is somewhere
// else.
TEST_P(EdgeReach, WhatBendsDoesNotGoOn) {
    const Camera camera = testCamera();
    std::vector<Box> stand;
    for (int i = -5; i < 115; ++i) {
        const double low = 0.1 * i, front = -20 + 0.15 * low * low;
        stand.push_back({{-60, low, front - 3}, {60, low + 0.1, front}});
    }
    const TracedView traced = Tracer(camera, stand).run();
    const Reflected result = reflected(camera, traced, share);
    size_t near = 0, found = 0, wrong = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::lost) continue;
        const double beyond = beyondThePicture(traced, traced.source[i]);
        if (beyond < 2 || beyond > 0.8 * double{share} * camera.height) continue;
        ++near;
        if (!isHit(result, i)) continue;
        ++found;
        wrong += std::abs(double{result.info[i]} / traced.distance[i] - 1) > 0.05;
    }
    std::printf("%zu near beyond the border: %zu found, %zu at wrong distances\n", near, found, wrong);
    EXPECT_GT(near, 1000u);
    EXPECT_LT(wrong, near / 250);
}

// The order in which tiles are listed varies, and so does who works on them.
TEST_P(EdgeReach, IsTheSameInEveryFrame) {
    Camera camera = testCamera();
    camera.eye.x = -0.4;
    camera.target.y = 0.8;
    camera.rollDegrees = 35;
    camera.width = 243;
    camera.height = 139;
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ReflectorDesc desc = reaching(GetParam(), share);
    desc.reflection.downscale = 2;
    const std::vector<ReflectorDesc> many(maxReflectors, desc);
    const Reflected first = reflectView(traced, viewDesc(camera), desc);
    for (int frames = 0; frames < 4; ++frames)
        for (const Reflected& result : reflectTogether(traced, viewDesc(camera), many)) {
            EXPECT_EQ(result.color, first.color);
            EXPECT_EQ(result.info, first.info);
        }
}

TEST_P(EdgeReach, CostsTwoDispatches) {
    const ReflectorDesc on = reaching(GetParam(), share), off = with(GetParam());
    const Estimate with = expectEstimateHolds(on, {256, 144}), without = expectEstimateHolds(off, {256, 144});
    EXPECT_EQ(with.dispatchesPerView, without.dispatchesPerView + 2);
    EXPECT_EQ(with.bytesPerView, without.bytesPerView);
}

TEST_P(EdgeReach, OutOfRangeIsNamed) {
    for (const float reach : {-0.1f, 1.1f, NAN}) {
        const ReflectorDesc desc = reaching(GetParam(), reach);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        EXPECT_NE(message().find("ReflectionDesc.edgeReach"), std::string::npos) << message();
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, EdgeReach,
                         testing::Values(ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                         ReflectionTechnique::hybrid),
                         nameOf);

} // namespace
