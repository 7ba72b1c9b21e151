// Shafts of sunlight under water: they stand along the sun's rays, gather no light that is not there, and
// what drifts in the water hangs where it is.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/light/encoded_light.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/unit/sea/statistics.h"

namespace {

using namespace seaglass;
using namespace tests;

class InTheWater : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        sea_.windSpeed = 3;
        sea_.fetch = 1e3f;
        sea_.samples = 64;
        sea_.cascades = 2;
        lighting.toSun[0] = 0.6;
        lighting.toSun[1] = 0.8;
        lighting.toSun[2] = 0;
        for (int i = 0; i < 3; ++i) lighting.sunIrradiance[i] = 5, lighting.skyIrradiance[i] = 1;
        camera_.eye = {3, -5, 7};
        camera_.width = 192;
        camera_.height = 96;
    }
    /// From the eye, by what it looks along.
    Camera along(const glm::dvec3& view) const {
        Camera camera = camera_;
        camera.target = camera.eye + view;
        return camera;
    }
    Body* made(float shafts, float snow) {
        const UnderwaterDesc underwater{0, shafts, snow};
        BodyDesc desc;
        desc.waves = &sea_;
        desc.wavesBackend = fftwWaves();
        desc.refraction = &refraction_;
        desc.underwater = &underwater;
        return makeBody(desc);
    }
    /// What they add to the green light of each pixel.
    std::vector<double> added(float shafts, float snow, const Camera& camera, double time = 4) {
        const WaterPicture with = picture({made(shafts, snow)}, camera, time),
                           without = picture({made(0, 0)}, camera, time);
        std::vector<double> more(with.color.size() / 4);
        for (size_t i = 0; i < more.size(); ++i)
            more[i] = double{with.color[4 * i + 1]} - double{without.color[4 * i + 1]};
        return more;
    }

    SeaDesc sea_;
    RefractionDesc refraction_;
    Camera camera_;
};

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value / static_cast<double>(values.size());
    return sum;
}

class Shafts : public InTheWater {};

/// How much a picture changes along the rays of the sun that it shows, and across them.
glm::dvec2 changesAlongRays(const std::vector<double>& picture, const Camera& camera, const glm::dvec3& sun) {
    const auto width = static_cast<size_t>(camera.width);
    glm::dvec2 sum(0);
    for (uint32_t y = 1; y + 1 < camera.height; ++y)
        for (uint32_t x = 1; x + 1 < camera.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const glm::dvec3 right = rayThrough(camera, x + 1, y) - ray,
                             down = rayThrough(camera, x, y + 1) - ray;
            const glm::dvec2 towards(glm::dot(sun, right) / glm::dot(right, right),
                                     glm::dot(sun, down) / glm::dot(down, down));
            const glm::dvec2 way = glm::normalize(towards);
            const size_t i = y * width + x;
            const glm::dvec2 change(picture[i + 1] - picture[i - 1], picture[i + width] - picture[i - width]);
            sum += glm::abs(glm::dvec2(glm::dot(change, way), change.x * way.y - change.y * way.x));
        }
    return sum;
}

// What changes with the waves, and not the halo around the sun, which stays.
TEST_F(Shafts, StandAlongTheSunsRays) {
    const Camera camera = along({-0.2, 0.35, -1});
    std::vector<double> waves = added(1, 0, camera, 4);
    const std::vector<double> later = added(1, 0, camera, 40);
    for (size_t i = 0; i < waves.size(); ++i) waves[i] -= later[i];
    // In water the sun's rays come from nearer to straight above, by Snell's law.
    const glm::dvec3 sun(0.6 / 1.333, std::sqrt(1 - 0.36 / (1.333 * 1.333)), 0);
    const glm::dvec2 changes = changesAlongRays(waves, camera, sun);
    std::printf("change along the sun's rays over that across them: %.3f\n", changes.x / changes.y);
    EXPECT_LT(changes.x, 0.45 * changes.y); // 0.57 where they stand upright
}

// Away from the sun they take as much light as they give, over many places.
TEST_F(Shafts, GatherNoLightThatIsNotThere) {
    double left = 0, changed = 0, water = 0;
    constexpr double places = 6;
    for (double place = 0; place < places; ++place) {
        camera_.eye = {70 * place, -5, 30 * place};
        const Camera camera = along({-1, -0.3, 0.1});
        const std::vector<double> more = added(1, 0, camera);
        left += mean(more);
        for (const double value : more) changed += std::abs(value) / static_cast<double>(more.size());
        const WaterPicture bare = picture({made(0, 0)}, camera, 4);
        for (size_t i = 1; i < bare.color.size(); i += 4)
            water += double{bare.color[i]} / static_cast<double>(more.size());
    }
    std::printf("of the water's light %.4f is changed, %.4f in the mean\n", changed / water, left / water);
    EXPECT_GT(changed / water, 0.01);
    EXPECT_LT(std::abs(left) / water, 0.006);
}

/// What small slopes of a smooth surface gather of a sun straight above, seen in the water before a wall
/// `farthest` metres ahead: by its curvature over the places where the rays come in.
double gatheredBefore(const HeightGrid& waves, const glm::dvec3& eye, const glm::dvec3& ray, double farthest,
                      const RefractionDesc& water, double sun) {
    constexpr double pi = std::numbers::pi, g = 0.6, beside = 0.5; // of Henyey and Greenstein; [m]
    constexpr int steps = 32;
    std::vector<double> points;
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 at = eye + ray * (farthest * (i + 0.5) / steps);
        for (const glm::dvec2 off : {glm::dvec2(0), glm::dvec2(beside, 0), glm::dvec2(-beside, 0),
                                     glm::dvec2(0, beside), glm::dvec2(0, -beside)})
            points.insert(points.end(), {at.x + off.x, at.z + off.y});
    }
    std::vector<HeightSample> samples(points.size() / 2);
    sampleHeights(waves, points.data(), samples.size(), samples.data());
    const double k = double{water.absorption[1]} + double{water.backscatter[1]};
    double sum = 0;
    for (size_t i = 0; i < steps; ++i) {
        const auto height = [&](size_t n) { return double{samples[5 * i + n].height}; };
        const double curvature =
            (height(1) + height(2) + height(3) + height(4) - 4 * height(0)) / (beside * beside);
        const double way = farthest * (static_cast<double>(i) + 0.5) / steps, depth = -eye.y - ray.y * way;
        sum += farthest / steps * (1 - way / 9) * (-depth * (1 - 1 / 1.333) * curvature) *
               std::exp(-k * (depth + way));
    }
    const double towards = ray.y, ahead = std::pow((1 + g * g) / (1 + g * g - 2 * g * towards), 1.5);
    return std::max(ahead, 1.0) * sum * sun * 0.98 / pi * 0.66 * double{water.backscatter[1]};
}

TEST_F(Shafts, AreAsStrongAsTheWavesBendTheLight) {
    sea_.windSpeed = 6;
    sea_.fetch = 20e3f;
    sea_.cascades = 1;
    sea_.largestPatch = 64;
    sea_.warp = 0;
    shineFrom({0, 1, 0}, 5);
    for (const double depth : {2.0, 6.0}) {
        camera_.eye = {3, -depth, 7};
        camera_.width = 48;
        camera_.height = 24;
        std::vector<double> drawn, expected;
        for (int place = 0; place < 12; ++place) {
            camera_.eye.x = 7.3 * place;
            const Camera camera = along({0, 0, -1});
            Body* const body = made(1, 0);
            const SceneBehind wall =
                drawnOver(camera, nothingBehind(camera), 0, [](const glm::dvec3& ray) { return -2 / ray.z; });
            std::vector<WaterPicture> with;
            for (const double time : {4.0, 40.0})
                with.push_back(picture({body}, camera, time, SurfaceOutput::shaded, wall));
            HeightGrid* const waves = createHeightGrid(*sea(body), 4);
            HeightGrid* const later = createHeightGrid(*sea(body), 40);
            for (uint32_t y = 2; y < camera.height; y += 5)
                for (uint32_t x = 2; x < camera.width; x += 5) {
                    const glm::dvec3 ray = rayThrough(camera, x, y);
                    const size_t i = (size_t{y} * camera.width + x) * 4 + 1;
                    drawn.push_back(double{with[0].color[i]} - double{with[1].color[i]});
                    expected.push_back(gatheredBefore(*waves, camera.eye, ray, -2 / ray.z, refraction_, 5) -
                                       gatheredBefore(*later, camera.eye, ray, -2 / ray.z, refraction_, 5));
                }
            destroyHeightGrid(waves);
            destroyHeightGrid(later);
        }
        const double slope = correlationOf(drawn, expected) * deviationOf(drawn) / deviationOf(expected);
        std::printf("%.1f m deep: correlation with the waves' curvature %.3f, %.3f times what they gather\n",
                    depth, correlationOf(drawn, expected), slope);
        EXPECT_GT(correlationOf(drawn, expected), 0.85);
        // They are drawn with more contrast than the mean over a pixel has.
        EXPECT_NEAR(slope, 1.5, 0.4);
    }
}

TEST_F(Shafts, AreBrightestTowardsTheSun) {
    const double towards = mean(added(1, 0, along({0.8, 0.6, 0}))),
                 away = mean(added(1, 0, along({-1, 0, 0})));
    std::printf("towards the sun %.4f, away from it %.4f\n", towards, away);
    EXPECT_GT(towards, 10 * std::abs(away));
}

TEST_F(Shafts, DimAsTheyAreAskedTo) {
    const Camera camera = along({0.2, 0.4, -1});
    const std::vector<double> whole = added(1, 0, camera), half = added(0.5f, 0, camera);
    for (size_t i = 0; i < whole.size(); i += 97)
        EXPECT_NEAR(half[i], whole[i] / 2, 1e-3 * std::abs(whole[i]) + 1e-5);
}

class MarineSnow : public InTheWater {
  protected:
    MarineSnow() { camera_.near = 0.05; }
    static size_t specks(const std::vector<double>& more) {
        return static_cast<size_t>(std::ranges::count_if(more, [](double value) { return value > 1e-4; }));
    }
};

TEST_F(MarineSnow, IsAFunctionOfPlaceAndTime) {
    Body* const watched = made(0, 1);
    const Camera camera = along({0, 0, -1});
    for (const double time : {1.0, 30.0, 2.0}) picture({watched}, along({1, 0, 0}), time);
    const WaterPicture late = picture({watched}, camera, 4), early = picture({made(0, 1)}, camera, 4),
                       later = picture({watched}, camera, 4.5);
    EXPECT_TRUE(late.color == early.color);
    EXPECT_FALSE(late.color == later.color);
    const std::vector<double> more = added(0, 1, camera), few = added(0, 0.2f, camera);
    std::printf("%zu pixels of 1, %zu of 0.2\n", specks(more), specks(few));
    EXPECT_GT(specks(more), 60u);
    EXPECT_LT(specks(few), specks(more) / 2);
}

// As the eye moves to the right what hangs before it moves to the left in the picture, near things most.
TEST_F(MarineSnow, HangsInTheWater) {
    const Camera before = along({0, 0, -1});
    Camera after = before;
    after.eye.x += 0.004;
    after.target.x += 0.004;
    const std::vector<double> first = added(0, 1, before), second = added(0, 1, after);
    const auto width = static_cast<size_t>(before.width);
    const auto likeShifted = [&](size_t by) {
        double sum = 0;
        for (size_t i = 0; i + by < first.size(); ++i)
            if (i % width + by < width) sum += first[i + by] * second[i];
        return sum;
    };
    EXPECT_GT(likeShifted(1), 0.2 * likeShifted(0));
    EXPECT_GT(likeShifted(0) + likeShifted(1), 3 * likeShifted(20));
}

// Of particles that are smaller than pixels each shows as much light in a coarse picture as in a fine one.
TEST_F(MarineSnow, GivesAsMuchLightInCoarsePicturesAsInFineOnes) {
    Camera coarse = along({0, 0, -1}), fine = coarse;
    coarse.width /= 2;
    coarse.height /= 2;
    fine.width *= 4;
    fine.height *= 4;
    const double ofCoarse = mean(added(0, 1, coarse)), ofFine = mean(added(0, 1, fine));
    std::printf("%.3f of the light of eight times as many pixels each way\n", ofCoarse / ofFine);
    EXPECT_NEAR(ofCoarse / ofFine, 1, 0.15);
}

// By half a turn of that the particles are elsewhere, by a whole one where they were.
TEST_F(MarineSnow, SwaysAsWavesCarryIt) {
    constexpr double period = 4, sinks = 1e-3; // of water/below/underwater_part.cpp [s], [m/s]
    const auto snowAt = [&](double time) {
        Camera camera = along({0, 0, -1}); // sinks with them
        camera.eye.y -= sinks * time;
        camera.target.y -= sinks * time;
        return added(0, 1, camera, time);
    };
    const std::vector<double> first = snowAt(1), half = snowAt(1 + period / 2), whole = snowAt(1 + period);
    const auto likeFirst = [&](const std::vector<double>& other) {
        double both = 0, all = 0;
        for (size_t i = 0; i < first.size(); ++i) both += first[i] * other[i], all += first[i] * first[i];
        return both / all;
    };
    std::printf("%.3f alike after a turn, %.3f after half of one\n", likeFirst(whole), likeFirst(half));
    EXPECT_GT(likeFirst(whole), 0.95);
    EXPECT_LT(likeFirst(half), 0.6);
}

/// Pixels around one that are brighter than `least`, each counted once.
size_t pixelsAround(std::vector<double> picture, size_t width, size_t at, double least) {
    std::vector<size_t> open = {at};
    size_t count = 0;
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (i >= picture.size() || !(picture[i] > least)) continue;
        picture[i] = 0;
        ++count;
        for (const size_t next : {i - 1, i + 1, i - width, i + width}) open.push_back(next);
    }
    return count;
}

// As a round particle does that lets light through: by a paraboloid half of it shows more than half of the
// most.
TEST_F(MarineSnow, IsThinAtItsRims) {
    Camera camera = along({-0.59, -0.1, 0.81}); // one of the largest that are near
    camera.fovDegrees = 5;
    const std::vector<double> more = added(0, 1, camera);
    const size_t width = camera.width;
    size_t largest = 0, bright = 0;
    for (size_t i = width; i + width < more.size(); ++i) {
        const bool isMiddle =
            more[i] >= std::max({1e-3, more[i - 1], more[i + 1], more[i - width], more[i + width]});
        const size_t size = isMiddle ? pixelsAround(more, width, i, 0.05 * more[i]) : 0;
        if (size <= largest) continue;
        largest = size;
        bright = pixelsAround(more, width, i, 0.5 * more[i]);
    }
    std::printf("%zu pixels, %zu of them bright\n", largest, bright);
    EXPECT_GT(largest, 30u);
    EXPECT_NEAR(static_cast<double>(bright), 0.526 * static_cast<double>(largest), 6);
}

TEST_F(MarineSnow, IsNoBrighterThanWhatLightsIt) {
    const std::vector<double> more = added(0, 1, along({0.5, 0.2, -1}));
    EXPECT_LT(*std::ranges::max_element(more), 0.5 * (5 * 0.8 + 1) / 3.14159265);
}

// Blended as displays take colour, it sends nearly as much.
TEST_F(MarineSnow, SendsAsMuchLightIntoEncodedColor) {
    const auto sent = [&](Encoding encoding) {
        useEncoding(encoding);
        const Camera camera = along({0, 0, -1});
        return lightAdded(picture({made(0, 1)}, camera, 4), picture({made(0, 0)}, camera, 4), encoding);
    };
    const double linear = sent(Encoding::linear), held = sent(Encoding::srgb);
    std::printf("light of snow in encoded colour is %.3f of that in linear\n", held / linear);
    EXPECT_NEAR(held / linear, 0.85, 0.25);
}

TEST_F(InTheWater, WhatIsOffIsNotDrawn) {
    const auto draws = [&](float shafts, float snow, double height) {
        Body* const body = made(shafts, snow);
        Camera camera = along({0, 0, -1});
        camera.eye.y = camera.target.y = height;
        picture({body}, camera);
        spiedCalls().clear();
        picture({body}, camera);
        EXPECT_EQ(countSpied("CmdDispatch"), 3u) << "of the surface's tiles";
        return countSpied("CmdDraw");
    };
    const size_t water = draws(0, 0, -5);
    EXPECT_EQ(draws(1, 0, -5), water + 1);
    EXPECT_EQ(draws(0, 1, -5), water + 1);
    EXPECT_EQ(draws(1, 1, 5), draws(0, 0, 5));
    lighting.toSun[1] = -0.8;
    EXPECT_EQ(draws(1, 0, -5), water) << "at night";
}

} // namespace
