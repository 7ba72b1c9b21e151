// Techniques that follow rays over the picture, against a traced truth.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "reflection/core/reflector.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

size_t differingClasses(const Reflected& a, const Reflected& b) {
    size_t differing = 0;
    for (size_t i = 0; i < a.info.size(); ++i)
        differing += reflectionClass(a.info[i]) != reflectionClass(b.info[i]);
    return differing;
}

bool allFinite(const std::vector<float>& values) {
    return std::ranges::all_of(values, [](float v) { return std::isfinite(v); });
}

ReflectorDesc inStrides(ReflectionTechnique technique) {
    ReflectorDesc desc = with(technique);
    desc.reflection.marchCells = false;
    return desc;
}

class Ssr : public ReflectionTest {
  protected:
    Score scoreOf(const Pose& pose, const ReflectorDesc& desc) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Score s = score(traced, reflectScene(pose.camera, traced, desc));
        print(pose.name, s);
        return s;
    }
};

TEST_F(Ssr, AgreesWithTheTracedTruth) {
    const std::map<std::string, double> coverage = {
        {"level", 0.99}, {"roll35", 0.985}, {"roll90", 0.99}, {"steep", 0.995}, {"grazing", 0.992}};
    for (const Pose& pose : poses()) {
        const Score s = scoreOf(pose, with(ReflectionTechnique::ssr));
        EXPECT_GE(s.coverage, coverage.at(pose.name)) << pose.name;
        EXPECT_LE(s.medianPixels, 0.2) << pose.name;
        EXPECT_LE(s.p95Pixels, pose.name == std::string("steep") ? 1.1 : 0.65) << pose.name;
        EXPECT_LE(s.p90Distance, 0.02) << pose.name;
        EXPECT_LE(s.falseOnSky, 0.004) << pose.name;
        EXPECT_LE(s.skyOnGeometry, 0.004) << pose.name;
    }
}

TEST_F(Ssr, InStridesAgreesWithTheTracedTruth) {
    // Strides pass over what is thinner than they are: seen steeply from above, most walls.
    const std::map<std::string, double> coverage = {
        {"level", 0.97}, {"roll35", 0.965}, {"roll90", 0.97}, {"steep", 0.88}, {"grazing", 0.975}};
    for (const Pose& pose : poses()) {
        const Score s = scoreOf(pose, inStrides(ReflectionTechnique::ssr));
        EXPECT_GE(s.coverage, coverage.at(pose.name)) << pose.name;
        EXPECT_LE(s.medianPixels, 0.25) << pose.name;
        EXPECT_LE(s.p95Pixels, 0.8) << pose.name;
        EXPECT_LE(s.p90Distance, 0.02) << pose.name;
        EXPECT_LE(s.falseOnSky, 0.004) << pose.name;
        EXPECT_LE(s.skyOnGeometry, 0.022) << pose.name;
    }
}

TEST_F(Ssr, TopsAreNotMirroredWhereUndersidesShouldBe) {
    // A deck from above: its underside is what the water mirrors, and no pixel shows that.
    Camera camera = testCamera();
    camera.eye = {-2, 16, 0};
    camera.target = {-2, 0, -5.8};
    const TracedView deck = Tracer(camera, {{{-6, 0.8, -8}, {2, 1.1, -3}}}).run();
    for (const ReflectorDesc& desc : {with(ReflectionTechnique::ssr), inStrides(ReflectionTechnique::ssr)}) {
        const Reflected result = reflectScene(camera, deck, desc);
        const float light = desc.reflection.undersideLight;
        size_t lost = 0, open = 0, bright = 0;
        for (size_t i = 0; i < result.info.size(); ++i) {
            if (deck.truth[i] != Truth::lost) continue;
            ++lost;
            open += reflectionClass(result.info[i]) != ReflectionClass::hit;
            bright += result.color[i * 4 + 2] > (light + 0.01f) * result.color[i * 4 + 3];
        }
        EXPECT_GT(lost, 500u);
        EXPECT_LE(static_cast<double>(open), 0.05 * static_cast<double>(lost));
        EXPECT_LE(static_cast<double>(bright), 0.05 * static_cast<double>(lost));
    }
}

TEST_F(Ssr, OnlyBentLookupsReachBehindThings) {
    const Camera camera = testCamera();
    // Stands before the plane; the wall behind it is mirrored there too.
    const TracedView traced = Tracer(camera, {{{-3, -1, 2}, {1, 1.2, 3}}, {{-9, -1, -9}, {9, 9, -8}}}).run();
    const auto hitsOffThePlane = [&](float distortion, const Image* normals) {
        ReflectorDesc desc = with(ReflectionTechnique::ssr);
        desc.reflection.distortion = distortion;
        ViewDesc view = viewDesc(camera);
        view.surfaceNormals = normals;
        const Reflected result = reflectView(traced, view, desc);
        size_t hits = 0;
        for (size_t i = 0; i < result.info.size(); ++i)
            hits += traced.truth[i] == Truth::none && reflectionClass(result.info[i]) == ReflectionClass::hit;
        return hits;
    };
    const demos::Image none =
        uploadFloats(traced.width, traced.height, 4, std::vector<float>(traced.depth.size() * 4, 0.0f));
    const Image normals = asSeaglass(none);
    const size_t flat = hitsOffThePlane(0, nullptr);
    // What is left are the rest of tiles in which the plane is seen.
    EXPECT_GT(hitsOffThePlane(1, nullptr), 3 * flat);
    // Waves may stand where the flat plane is not seen.
    EXPECT_GT(hitsOffThePlane(0, &normals), 3 * flat);
}

TEST_F(Ssr, MoreStepsFindMore) {
    Camera large = testCamera();
    large.width *= 3;
    large.height *= 3;
    const TracedView traced = Tracer(large, harbourOfBoxes()).run();
    double last = 0;
    for (const uint32_t steps : {8u, 32u, 128u}) {
        ReflectorDesc desc = with(ReflectionTechnique::ssr);
        desc.reflection.marchSteps = steps;
        const Score s = score(traced, reflectScene(large, traced, desc));
        print("steps", s);
        EXPECT_GT(s.coverage, last + 0.03) << steps;
        EXPECT_LE(s.skyOnGeometry, 0.004) << steps; // what was not looked at is not proven to be sky
        last = s.coverage;
    }
    EXPECT_GE(last, 0.99);
}

TEST_F(Ssr, StridesOfAPixelMissNothing) {
    ReflectorDesc desc = inStrides(ReflectionTechnique::ssr);
    desc.reflection.marchSteps = 512;
    for (const Pose& pose : poses()) {
        const Score s = scoreOf(pose, desc);
        EXPECT_GE(s.coverage, 0.99) << pose.name;
        EXPECT_LE(s.p95Pixels, pose.name == std::string("steep") ? 2.5 : 1.0) << pose.name;
        EXPECT_LE(s.falseOnSky, 0.004) << pose.name;
        EXPECT_LE(s.skyOnGeometry, 0.006) << pose.name;
    }
}

/// Between neighbours in a row.
size_t classChanges(const TracedView& view, const Reflected& result) {
    size_t changes = 0;
    for (size_t i = 1; i < result.info.size(); ++i)
        changes += i % view.width && reflectionClass(result.info[i]) != reflectionClass(result.info[i - 1]);
    return changes;
}

TEST_F(Ssr, JitterTurnsBandsIntoNoise) {
    const TracedView rail = Tracer(testCamera(), {{{-4, 1, -1}, {3, 1.04, -0.96}}}).run();
    ReflectorDesc desc = inStrides(ReflectionTechnique::ssr);
    const size_t banded = classChanges(rail, reflectScene(testCamera(), rail, desc));
    desc.reflection.marchJitter = 1;
    EXPECT_GT(classChanges(rail, reflectScene(testCamera(), rail, desc)), banded + 100);
}

TEST_F(Ssr, ThinThings) {
    const Camera camera = testCamera();
    const double width = 0.04; // 1.2 pixels
    const TracedView poles = Tracer(camera, {{{-3, -1, -1}, {-3 + width, 2, -1 + width}},
                                             {{-1, -1, -1}, {-1 + width, 2, -1 + width}},
                                             {{2, -1, -1}, {2 + width, 2, -1 + width}}})
                                 .run();
    const TracedView rails = Tracer(camera, {{{-4, 1, -1}, {3, 1 + width, -1 + width}}}).run();
    const auto found = [&](const TracedView& traced, const ReflectorDesc& desc) {
        const Score s = score(traced, reflectScene(camera, traced, desc));
        print("thin", s);
        return s.coverage;
    };
    EXPECT_GE(found(poles, with(ReflectionTechnique::ssr)), 0.86);
    EXPECT_GE(found(rails, with(ReflectionTechnique::ssr)), 0.88);
    // Jitter: else neighbours' strides fall alike, and all of a rail is met or missed.
    ReflectorDesc desc = inStrides(ReflectionTechnique::ssr);
    desc.reflection.marchJitter = 1;
    // Rays run along what is upright and across what lies: strides of four pixels meet a rail by chance.
    EXPECT_GE(found(poles, desc), 0.8);
    EXPECT_GE(found(rails, desc), 0.3);
}

TEST_F(Ssr, FindsNothingFartherThanItsDistance) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    ReflectorDesc desc = with(ReflectionTechnique::ssr);
    desc.reflection.marchDistance = 12;
    const Reflected near = reflectScene(testCamera(), traced, desc);
    const Reflected all = reflectScene(testCamera(), traced, with(ReflectionTechnique::ssr));
    size_t within = 0, beyond = 0, calledSky = 0;
    for (size_t i = 0; i < near.info.size(); ++i) {
        EXPECT_LE(near.info[i], 12.01f);
        if (all.info[i] > 0 && all.info[i] < 11.5f) within += near.info[i] > 0;
        if (all.info[i] > 12.5f) {
            ++beyond;
            calledSky += reflectionClass(near.info[i]) == ReflectionClass::sky;
        }
    }
    EXPECT_GT(within, 500u);
    EXPECT_GT(beyond, 500u);
    // What was not looked for is not proven to be sky.
    EXPECT_LE(static_cast<double>(calledSky), 0.1 * static_cast<double>(beyond));
}

TEST_F(Ssr, ThicknessDecidesWhatARayPassesBehind) {
    // A thin board, and a ray that passes 0.3 m behind it before it meets the sky.
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, {{{-3, 1, -1.05}, {2, 2, -1}}}).run();
    const auto falseHits = [&](float thickness) {
        ReflectorDesc desc = with(ReflectionTechnique::ssr);
        desc.reflection.marchSteps = 512;
        desc.reflection.marchThickness = thickness;
        return score(traced, reflectScene(camera, traced, desc)).falseOnSky;
    };
    EXPECT_LT(falseHits(0.02f), 0.002);
    EXPECT_GT(falseHits(5.0f), 4 * falseHits(0.02f));
}

/// How far ahead of the eye [m].
double ahead(const Camera& camera, const glm::dvec3& point) {
    return glm::dot(point - camera.eye, glm::normalize(camera.target - camera.eye));
}

/// How far behind what shows of `box` where it hides a ray from the plane first, ahead of the eye, the ray is
/// where it is as high as the box's lower edge, or where it is hidden if that is later [m]; infinite where it
/// never is.
double firstBehind(const Camera& camera, const Box& box, const glm::dvec3& from, const glm::dvec3& ray) {
    for (double along = 0; along < 20; along += 0.02) {
        const glm::dvec3 point = from + along * ray;
        const glm::dvec3 sight = glm::normalize(point - camera.eye);
        const double hit = hitDistance(box, camera.eye, sight);
        if (hit >= glm::length(point - camera.eye)) continue;
        const double rises = std::max(along, (box.low.y - from.y) / ray.y);
        return ahead(camera, from + rises * ray) - ahead(camera, camera.eye + hit * sight);
    }
    return std::numeric_limits<double>::infinity();
}

// As far as that is, in metres ahead of the eye: a board that is thinner, and rays that go behind it before
// they meet the sky.
TEST_F(Ssr, ThicknessIsInMetresAheadOfTheEye) {
    const Camera camera = testCamera();
    const Box board{{-3, 1, -1.05}, {2, 2, -1}};
    const TracedView traced = Tracer(camera, {board}).run();
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    std::vector<double> behind;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        // One column of four tells.
        if (i % 4 || traced.truth[i] != Truth::sky) continue;
        const glm::dvec2 pixel(static_cast<double>(i % traced.width) + 0.5,
                               static_cast<double>(i / traced.width) + 0.5);
        const glm::dvec4 p =
            inverse * glm::dvec4(pixel / glm::dvec2(traced.width, traced.height) * 2.0 - 1.0, 0.5, 1);
        const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w - camera.eye);
        const glm::dvec3 on = camera.eye - ray * (camera.eye.y / ray.y);
        behind.push_back(firstBehind(camera, board, on, ray * glm::dvec3(1, -1, 1)));
    }
    for (const double thickness : {1.0, 1.4, 2.0}) {
        ReflectorDesc desc = with(ReflectionTechnique::ssr);
        desc.reflection.marchSteps = 512;
        desc.reflection.marchThickness = static_cast<float>(thickness);
        const double hits = score(traced, reflectScene(camera, traced, desc)).falseOnSky;
        const double expected = static_cast<double>(std::ranges::count_if(
                                    behind, [&](double metres) { return metres < thickness; })) /
                                static_cast<double>(behind.size());
        std::printf("%.1f m thick: %.5f of the sky is hit, %.5f expected\n", thickness, hits, expected);
        EXPECT_NEAR(hits, expected, 0.04 * expected);
    }
}

// There is air below what hovers. Rays that leave by it are farther behind what shows than that is thick once
// they are as high.
TEST_F(Ssr, AirBelowWhatHoversIsNotFilled) {
    for (const double gap : {0.15, 0.3, 0.6}) {
        const TracedView traced = Tracer(testCamera(), {{{-2, gap, -2}, {2, gap + 0.8, -1}}}).run();
        for (const ReflectionTechnique technique : {ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
            const Reflected result = reflectScene(testCamera(), traced, with(technique));
            size_t filled = 0, underside = 0, found = 0;
            for (size_t i = 0; i < result.info.size(); ++i) {
                const bool hit = reflectionClass(result.info[i]) == ReflectionClass::hit;
                filled += hit && traced.truth[i] == Truth::sky;
                underside += traced.truth[i] == Truth::lost;
                found += hit && traced.truth[i] == Truth::lost;
            }
            std::printf("gap of %.2f m: %zu pixels of sky filled, of %zu of the underside %zu\n", gap, filled,
                        underside, found);
            EXPECT_GT(underside, 300u);
            EXPECT_LE(filled, 120u);
            EXPECT_GE(found, underside * 9 / 10);
        }
    }
}

// Rays that pass between rails go behind the next one above, by more than that is wide.
TEST_F(Ssr, GapsOfARailingStayOpen) {
    const Camera camera = testCamera();
    std::vector<Box> railing;
    for (int i = 0; i < 3; ++i) {
        const double low = 0.8 + 0.4 * i;
        railing.push_back({{-4, low, -1}, {3, low + 0.1, -0.96}});
    }
    const TracedView traced = Tracer(camera, railing).run();
    for (const ReflectionTechnique technique : {ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        const Score s = score(traced, reflectScene(camera, traced, with(technique)));
        print("railing", s);
        EXPECT_LE(s.falseOnSky, 0.015);
        EXPECT_GE(s.coverage, 0.95);
    }
}

/// The pixel that a hit's colour was taken from: colours are their pixels' places.
size_t sourceOf(const TracedView& traced, const Reflected& result, size_t i) {
    const double confidence = double{result.color[i * 4 + 3]};
    const double x = double{result.color[i * 4]} / confidence * traced.width;
    const double y = double{result.color[i * 4 + 1]} / confidence * traced.height;
    return static_cast<size_t>(y) * traced.width + static_cast<size_t>(x);
}

// Of a house behind a bridge: rays go out of sight under the bridge, and behind it meet what shows above.
TEST_F(Ssr, WhatShowsBesideWhatHidesItIsFound) {
    const Camera camera = testCamera();
    const Box house{{-7, -1, -14}, {7, 7, -11}};
    const TracedView withoutDeck = Tracer(camera, {house}).run();
    // The higher one hides rays for more pixels than they may look at.
    for (const double top : {2.4, 4.0}) {
        const TracedView traced = Tracer(camera, {{{-8, 1.4, -5}, {8, top, -4.6}}, house}).run();
        for (const ReflectorDesc& desc : {with(ReflectionTechnique::ssr), inStrides(ReflectionTechnique::ssr),
                                          with(ReflectionTechnique::hybrid)}) {
            const Reflected result = reflectScene(camera, traced, desc);
            size_t hidden = 0, found = 0;
            for (size_t i = 0; i < result.info.size(); ++i) {
                const double distance = traced.distance[i];
                if (traced.truth[i] != Truth::lost || distance != withoutDeck.distance[i]) continue;
                ++hidden;
                if (std::abs(double{result.info[i]} - distance) > 0.02 * distance) continue;
                const size_t source = sourceOf(traced, result, i);
                const double column = static_cast<double>(source % traced.width) + 0.5;
                const bool shows = traced.depth[source] == withoutDeck.depth[source];
                found += shows && std::abs(column - traced.source[i].x) < 2;
            }
            std::printf("deck up to %.1f m: %zu of %zu found\n", top, found, hidden);
            EXPECT_GT(hidden, 1000u);
            const bool all = desc.reflection.marchCells && top < 4;
            EXPECT_GE(found, all ? hidden * 19 / 20 : hidden * 3 / 4);
        }
    }
}

// Of a rail a pixel shows above a board before it: too little to tell what the board hides.
TEST_F(Ssr, WhatIsThinIsNotThoughtToGoOn) {
    const Camera camera = testCamera();
    const Box board{{-4, 1.4, -1}, {3, 2, -0.96}}, rail{{-6, 1.86, -6}, {4.5, 1.96, -5.96}};
    const TracedView traced = Tracer(camera, {board, rail}).run();
    const TracedView railAlone = Tracer(camera, {rail}).run();
    for (const ReflectionTechnique technique : {ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        ReflectorDesc desc = with(technique);
        desc.reflection.marchThickness = 0.1f;
        const Reflected result = reflectScene(camera, traced, desc);
        size_t sky = 0, ofRail = 0;
        for (size_t i = 0; i < result.info.size(); ++i) {
            if (traced.truth[i] != Truth::sky) continue;
            ++sky;
            if (!(result.info[i] > 0)) continue;
            const size_t source = sourceOf(traced, result, i);
            ofRail += traced.depth[source] == railAlone.depth[source];
        }
        std::printf("%zu of %zu show the rail\n", ofRail, sky);
        EXPECT_GT(sky, 10000u);
        EXPECT_LE(ofRail, sky / 100);
    }
}

// Of two bridges, rays pass under both: what shows of the second, above the first, they have not met.
TEST_F(Ssr, WhatIsPassedUnderIsNotMet) {
    const Camera camera = testCamera();
    const TracedView traced =
        Tracer(camera, {{{-8, 1.4, -5}, {8, 2.0, -4.8}}, {{-8, 1.2, -9}, {8, 3.4, -8.8}}}).run();
    for (const ReflectorDesc& desc : {with(ReflectionTechnique::ssr), inStrides(ReflectionTechnique::ssr),
                                      with(ReflectionTechnique::hybrid)}) {
        const Score s = score(traced, reflectScene(camera, traced, desc));
        print("bridges", s);
        EXPECT_LE(s.falseOnSky, 0.01);
    }
}

TEST_F(Ssr, JitterIsTheSameEachTime) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    ReflectorDesc desc = inStrides(ReflectionTechnique::ssr);
    desc.reflection.marchJitter = 1;
    const Reflected jittered = reflectScene(testCamera(), traced, desc);
    const Reflected again = reflectScene(testCamera(), traced, desc);
    EXPECT_EQ(jittered.info, again.info);
    EXPECT_EQ(jittered.color, again.color);
    const Score s = score(traced, jittered);
    print("jitter", s);
    EXPECT_GE(s.coverage, 0.96);
    EXPECT_LE(s.p95Pixels, 1.0);
}

TEST_F(Ssr, NothingIsKnownBehindTheFarPlane) {
    Camera camera = testCamera();
    camera.far = 18;
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const Reflected result = reflectScene(camera, traced, with(ReflectionTechnique::ssr));
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    size_t beyond = 0;
    for (uint32_t y = 0; y < camera.height; ++y) {
        const glm::dvec4 end = inverse * glm::dvec4(0, (y + 0.5) / camera.height * 2 - 1, 0, 1);
        if (end.y / end.w < 0) continue;
        for (size_t i = size_t{y} * camera.width; i < size_t{y + 1} * camera.width; ++i) {
            ++beyond;
            EXPECT_EQ(reflectionClass(result.info[i]), ReflectionClass::unknown);
        }
    }
    EXPECT_GT(beyond, 1000u);
}

TEST_F(Ssr, NormalsBendItsRays) {
    const glm::dvec3 tilted = glm::normalize(glm::dvec3(0.06, 1, 0.03));
    ReflectorDesc desc = with(ReflectionTechnique::ssr);
    desc.reflection.marchSteps = 256;
    for (const glm::dvec3& normal : {glm::dvec3(0, 1, 0), tilted}) {
        const TracedView traced = Tracer(testCamera(), harbourOfBoxes(), normal).run();
        std::vector<float> normals;
        for (size_t i = 0; i < traced.truth.size(); ++i)
            for (const double value : {normal.x, normal.y, normal.z, 0.0})
                normals.push_back(static_cast<float>(value));
        const demos::Image image = uploadFloats(traced.width, traced.height, 4, normals);
        const Image handed = asSeaglass(image);
        ViewDesc view = viewDesc(testCamera());
        view.surfaceNormals = &handed;
        const Score s = score(traced, reflectView(traced, view, desc));
        print("normals", s);
        EXPECT_GE(s.coverage, 0.98);
        EXPECT_LE(s.p95Pixels, 1.0);
        EXPECT_LE(s.falseOnSky, 0.004);
    }
}

TEST_F(Ssr, NoNormalsAreThePlanes) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    const demos::Image image =
        uploadFloats(traced.width, traced.height, 4, std::vector<float>(traced.depth.size() * 4, 0.0f));
    const Image handed = asSeaglass(image);
    ViewDesc view = viewDesc(testCamera());
    const Reflected without = reflectView(traced, view, with(ReflectionTechnique::ssr));
    view.surfaceNormals = &handed;
    const Reflected with0 = reflectView(traced, view, with(ReflectionTechnique::ssr));
    EXPECT_EQ(without.color, with0.color);
    EXPECT_EQ(without.info, with0.info);
}

TEST_F(Ssr, NormalsThatAreNotFiniteAreThePlanes) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    ViewDesc view = viewDesc(testCamera());
    const auto reflected = [&](const std::vector<float>& normals) {
        const demos::Image image = uploadFloats(traced.width, traced.height, 4, normals);
        const Image handed = asSeaglass(image);
        view.surfaceNormals = &handed;
        return reflectView(traced, view, with(ReflectionTechnique::ssr));
    };
    std::vector<float> normals(traced.depth.size() * 4, 0.0f);
    for (size_t i = 0; i < normals.size(); i += 4) {
        normals[i] = 0.06f;
        normals[i + 1] = 1;
    }
    std::vector<float> broken = normals;
    for (size_t pixel = 0, kind = 0; pixel < traced.depth.size(); pixel += 7, ++kind) {
        std::fill_n(&normals[pixel * 4], 3, 0.0f); // the plane's
        broken[pixel * 4 + kind / 3 % 3] =
            std::array{std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity()}[kind % 3];
    }
    const Reflected expected = reflected(normals), found = reflected(broken);
    EXPECT_TRUE(allFinite(found.color));
    EXPECT_TRUE(allFinite(found.info));
    EXPECT_EQ(found.color, expected.color);
    EXPECT_EQ(found.info, expected.info);
}

TEST_F(Ssr, SaysWhetherNormalsHaveBentIt) {
    const TracedView traced = Tracer(testCamera(), {}).run();
    const demos::Image depth = uploadFloats(traced.width, traced.height, 1, traced.depth);
    const demos::Image color = uploadFloats(traced.width, traced.height, 4, traced.color);
    const Image normals = asSeaglass(color);
    ViewDesc view = viewDesc(testCamera());
    view.sceneDepth = asSeaglass(depth);
    view.sceneColor = asSeaglass(color);
    for (const ReflectionTechnique technique : {ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        Reflector* reflector = nullptr;
        const ReflectorDesc desc = with(technique);
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        for (const Image* given : {&normals, static_cast<const Image*>(nullptr)}) {
            view.surfaceNormals = given;
            frame([&](VkCommandBuffer commands) {
                EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
            });
            EXPECT_EQ(reflectionImages(reflector, 0).bent, given && technique == ReflectionTechnique::ssr);
        }
        destroyReflector(reflector);
    }
    Image small = normals;
    small.extent = {8, 8};
    view.surfaceNormals = &small;
    Reflector* reflector = nullptr;
    const ReflectorDesc desc = with(ReflectionTechnique::ssr);
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::invalidArgument);
    });
    EXPECT_NE(message().find("surfaceNormals"), std::string::npos);
    destroyReflector(reflector);
}

TEST_F(Ssr, HoldsNothingOfOtherTechniques) {
    useOwnContext();
    spiedCalls().clear();
    Reflector* reflector = nullptr;
    const ReflectorDesc desc = with(ReflectionTechnique::ssr);
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    EXPECT_EQ(countSpied("CreateComputePipelines"), 4 + onGpus(1)); // its own and the blur's
    destroyReflector(reflector);

    useOwnContext();
    spiedCalls().clear();
    const ReflectorDesc other;
    ASSERT_EQ(createReflector(context(), &other, &reflector), Status::ok) << message();
    EXPECT_EQ(countSpied("CreateComputePipelines"), 5 + onGpus(1)); // none to march
    destroyReflector(reflector);
}

TEST_F(Ssr, BadFieldsAreNamed) {
    const auto refused = [&](auto&& spoil) {
        ReflectorDesc desc = with(ReflectionTechnique::ssr);
        spoil(desc.reflection);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        EXPECT_EQ(reflector, nullptr);
        return message();
    };
    using Desc = ReflectionDesc;
    const auto names = [](const std::string& text, const char* field) {
        return text.find(field) != std::string::npos;
    };
    ReflectorDesc widest = with(ReflectionTechnique::ssr);
    for (const bool least : {true, false}) {
        widest.reflection.marchSteps = least ? 8 : 512;
        widest.reflection.marchThickness = least ? 0.001f : 100;
        widest.reflection.marchDistance = least ? 0.1f : 1e6f;
        widest.reflection.marchJitter = least ? 0.0f : 1.0f;
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &widest, &reflector), Status::ok) << message();
        destroyReflector(reflector);
    }
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchThickness = 100.1f; }), "marchThickness"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchDistance = 1.1e6f; }), "marchDistance"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchSteps = 7; }), "marchSteps"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchSteps = 513; }), "marchSteps"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchThickness = 0; }), "marchThickness"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchThickness = NAN; }), "marchThickness"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchDistance = 0; }), "marchDistance"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchDistance = INFINITY; }), "marchDistance"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchJitter = -0.1f; }), "marchJitter"));
    EXPECT_TRUE(names(refused([](Desc& d) { d.marchJitter = 1.1f; }), "marchJitter"));
    EXPECT_TRUE(
        names(refused([](Desc& d) { d.technique = static_cast<ReflectionTechnique>(99); }), "technique"));
}

class Hybrid : public Ssr {};

TEST_F(Hybrid, FindsWhatSsprFindsAndMore) {
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Reflected scattered = reflectScene(pose.camera, traced, with(ReflectionTechnique::sspr));
        const Reflected completed = reflectScene(pose.camera, traced, with(ReflectionTechnique::hybrid));
        size_t found = 0, followed = 0;
        for (size_t i = 0; i < scattered.info.size(); ++i) {
            if (reflectionClass(scattered.info[i]) == ReflectionClass::unknown) {
                found += reflectionClass(completed.info[i]) == ReflectionClass::hit;
                continue;
            }
            bool same = scattered.info[i] == completed.info[i];
            for (size_t c = 0; c < 4; ++c)
                same = same && scattered.color[i * 4 + c] == completed.color[i * 4 + c];
            followed += !same && traced.truth[i] == Truth::recoverable;
        }
        // Alone, SSPR shows the outside of what a ray comes out of rather than nothing; these are followed,
        // most to what the picture does not hold.
        EXPECT_LE(static_cast<double>(followed), 0.002 * static_cast<double>(scattered.info.size()))
            << pose.name;
        EXPECT_GT(found, 0u) << pose.name;
        // What one pass leaves in doubt the next one settles, in every pixel.
        EXPECT_TRUE(std::ranges::all_of(completed.info, [](float info) { return info >= -1; })) << pose.name;
        const Score s = score(traced, completed);
        print(pose.name, s);
        EXPECT_GE(s.coverage, 0.994) << pose.name;
        EXPECT_GE(s.coverage, score(traced, scattered).coverage) << pose.name;
        EXPECT_LE(s.medianPixels, 0.15) << pose.name;
        EXPECT_LE(s.p95Pixels, 0.65) << pose.name;
        // The pier's deck hides the upper edge of the island, which is thought to go on.
        EXPECT_LE(s.falseOnSky, pose.name == std::string("grazing") ? 0.008 : 0.004) << pose.name;
    }
}

TEST_F(Hybrid, IsNoWorseThanTheBetterOfBoth) {
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const auto scoreWith = [&](ReflectionTechnique technique) {
            return score(traced, reflectScene(pose.camera, traced, with(technique)));
        };
        const Score sspr = scoreWith(ReflectionTechnique::sspr);
        const Score ssr = scoreWith(ReflectionTechnique::ssr);
        const Score hybrid = scoreWith(ReflectionTechnique::hybrid);
        EXPECT_GE(hybrid.coverage, std::max(sspr.coverage, ssr.coverage)) << pose.name;
        // What only the one finds lies at edges.
        EXPECT_LE(hybrid.medianPixels, std::min(sspr.medianPixels, ssr.medianPixels) + 0.01) << pose.name;
        EXPECT_LE(hybrid.p95Pixels, std::min(sspr.p95Pixels, ssr.p95Pixels) + 0.06) << pose.name;
        EXPECT_LE(hybrid.skyOnGeometry, std::max(sspr.skyOnGeometry, ssr.skyOnGeometry) + 0.0003)
            << pose.name;
    }
}

// Looking steeply down, keys of walls are few, and those of the tops behind them many.
TEST_F(Hybrid, WhatComesOutOfTopsWentInByWallsAsSsprFindsToo) {
    const Pose steep = poses()[3];
    const TracedView traced = Tracer(steep.camera, harbourOfBoxes()).run();
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::hybrid}) {
        ReflectorDesc desc = with(technique);
        desc.reflection.coarseKeys = true;
        const Score s = score(traced, reflectScene(steep.camera, traced, desc));
        print(steep.name, s);
        EXPECT_LE(s.p95Pixels, 0.72);
    }
}

// A deck from above: nothing on the screen shows its underside. Its top stands in, rather than the sky.
TEST_F(Hybrid, LeavesNoHoleThatSsprFills) {
    Camera camera = testCamera();
    camera.eye = {-2, 16, 0};
    camera.target = {-2, 0, -5.8};
    const TracedView deck = Tracer(camera, {{{-6, 0.8, -8}, {2, 1.1, -3}}}).run();
    const Reflected sspr = reflectScene(camera, deck, with(ReflectionTechnique::sspr));
    const Reflected hybrid = reflectScene(camera, deck, with(ReflectionTechnique::hybrid));
    size_t filled = 0, opened = 0;
    for (size_t i = 0; i < sspr.info.size(); ++i) {
        if (reflectionClass(sspr.info[i]) != ReflectionClass::hit) continue;
        ++filled;
        opened += reflectionClass(hybrid.info[i]) == ReflectionClass::unknown;
        EXPECT_GE(hybrid.info[i], -1.0f) << "a doubt is left at " << i;
    }
    EXPECT_GT(filled, 500u);
    EXPECT_EQ(opened, 0u);
}

/// A net of wires, as thin as a pixel or two, before the harbour.
std::vector<Box> harbourBehindWires() {
    std::vector<Box> boxes = harbourOfBoxes();
    for (int i = 0; i < 5; ++i) {
        const double low = 0.5 + 0.7 * i;
        boxes.push_back({{-4, low, -1.04}, {3, low + 0.04, -1}});
        boxes.push_back({{-2.0 + i, 0, -1.04}, {-1.96 + i, 4, -1}});
    }
    return boxes;
}

// What is mirrored larger than it is seen leaves too few keys to find all of it by, and sky beside the keys.
TEST_F(Hybrid, FollowsRaysWhereSsprSeesSkyBesideThings) {
    size_t seen = 0;
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourBehindWires()).run();
        const auto scoreBy = [&](ReflectionTechnique technique) {
            return score(traced, reflectScene(pose.camera, traced, with(technique)));
        };
        const Score sspr = scoreBy(ReflectionTechnique::sspr), hybrid = scoreBy(ReflectionTechnique::hybrid);
        print(pose.name, sspr);
        print(" hybrid", hybrid);
        EXPECT_LE(hybrid.skyOnGeometry, sspr.skyOnGeometry);
        EXPECT_LE(hybrid.falseOnSky, sspr.falseOnSky + 0.006);
        if (sspr.skyOnGeometry < 0.005) continue;
        ++seen;
        EXPECT_LE(hybrid.skyOnGeometry, 0.7 * sspr.skyOnGeometry);
    }
    EXPECT_GE(seen, 3u);
}

TEST_F(Hybrid, HoldsCellsAndTwoPipelinesMoreThanSspr) {
    const auto pipelines = [&](const ReflectorDesc& desc) {
        useOwnContext();
        spiedCalls().clear();
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        const size_t made = countSpied("CreateComputePipelines");
        destroyReflector(reflector);
        return made;
    };
    const size_t sspr = pipelines(with(ReflectionTechnique::sspr));
    EXPECT_EQ(pipelines(with(ReflectionTechnique::hybrid)), sspr + 3);
    EXPECT_EQ(pipelines(inStrides(ReflectionTechnique::hybrid)), sspr + 2);
}

class Marching : public ReflectionTest, public testing::WithParamInterface<ReflectionTechnique> {};

TEST_P(Marching, DepthConventionsGiveTheSameClasses) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    const Reflected reference = reflectScene(testCamera(), traced, with(GetParam()));
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 2000.0}) {
            Camera camera = testCamera();
            camera.reversed = reversed;
            camera.far = far;
            const TracedView other = Tracer(camera, harbourOfBoxes()).run();
            const Reflected result = reflectScene(camera, other, with(GetParam()));
            // Depth rounds differently, so that single pixels at edges may go the other way.
            EXPECT_LE(differingClasses(reference, result), traced.truth.size() / 500)
                << "reversed " << reversed << " far " << far;
        }
}

TEST_P(Marching, AnEmptySceneMirrorsOnlySky) {
    for (const double far : {0.0, 100.0}) {
        Camera camera = testCamera();
        camera.far = far;
        const TracedView traced = Tracer(camera, {}).run();
        const Reflected result = reflectScene(camera, traced, with(GetParam()));
        size_t sky = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            const ReflectionClass found = reflectionClass(result.info[i]);
            EXPECT_NE(found, ReflectionClass::hit);
            EXPECT_EQ(result.color[i * 4 + 3], 0.0f);
            sky += found == ReflectionClass::sky;
        }
        // Below the horizon, as far down as the ray still ends within the picture.
        EXPECT_GT(sky, traced.truth.size() / 4) << "far " << far;
    }
}

TEST_P(Marching, AFloorInTheDepthIsNoObstacle) {
    // A host that draws the mirror itself: a slab whose top is the plane.
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back({{-200, -1, -200}, {200, 0, 200}});
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    TracedView floored = Tracer(testCamera(), boxes).run();
    floored.truth = traced.truth;
    floored.source = traced.source;
    // The closer to its start a ray is first looked at, the closer is the floor.
    ReflectorDesc desc = with(GetParam());
    desc.reflection.marchJitter = 1;
    for (const bool cells : {true, false}) {
        desc.reflection.marchCells = cells;
        const Score s = score(floored, reflectScene(testCamera(), floored, desc));
        print("floor", s);
        EXPECT_GE(s.coverage, 0.96);
        EXPECT_LE(s.falseOnSky, 0.008); // a floor that is met shows in a fifth of the sky
    }
}

TEST_P(Marching, StaysFiniteAtTheExtremes) {
    for (const Camera& camera : extremeCameras()) {
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        const Reflected result = reflectScene(camera, traced, with(GetParam()));
        EXPECT_TRUE(allFinite(result.color)) << camera.eye.y;
        EXPECT_TRUE(allFinite(result.info)) << camera.eye.y;
    }
}

TEST_P(Marching, AtHalfResolutionNothingElseChanges) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    ReflectorDesc desc = with(GetParam());
    desc.reflection.downscale = 2;
    const Reflected half = reflectScene(testCamera(), traced, desc);
    const size_t across = traced.width / 2;
    ASSERT_EQ(half.info.size(), across * (traced.height / 2));
    size_t recoverable = 0, hits = 0;
    std::vector<double> errors;
    for (size_t y = 0; y < traced.height / 2; ++y)
        for (size_t x = 0; x < across; ++x) {
            // Four pixels of the view meet in the middle of one of these.
            glm::dvec2 source(0);
            bool all = true;
            for (const uint32_t i : {0u, 1u, traced.width, traced.width + 1}) {
                const size_t at = 2 * y * traced.width + 2 * x + i;
                all = all && traced.truth[at] == Truth::recoverable;
                source += 0.25 * traced.source[at];
            }
            if (!all) continue;
            ++recoverable;
            const size_t at = y * across + x;
            if (reflectionClass(half.info[at]) != ReflectionClass::hit) continue;
            ++hits;
            if (half.color[at * 4 + 3] < 0.1f) continue;
            const double light = double{half.color[at * 4 + 2]};
            const glm::dvec2 found(half.color[at * 4] / light * traced.width,
                                   half.color[at * 4 + 1] / light * traced.height);
            errors.push_back(glm::length(found - source));
        }
    EXPECT_GE(static_cast<double>(hits), 0.98 * static_cast<double>(recoverable));
    EXPECT_LE(quantile(errors, 0.5), 0.5);
    EXPECT_LE(quantile(errors, 0.9), 1.0);
}

TEST_P(Marching, TheEstimateIsWhatIsAllocatedAndDispatched) {
    expectEstimateHolds(with(GetParam()), {640, 360});
    expectEstimateHolds(inStrides(GetParam()), {640, 360});
}

INSTANTIATE_TEST_SUITE_P(, Marching, testing::Values(ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
                         [](const auto& info) {
                             return info.param == ReflectionTechnique::ssr ? "Ssr" : "Hybrid";
                         });

} // namespace
