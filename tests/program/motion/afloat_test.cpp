// What floats lies in the water as it stands there: on the mean of what it takes up, with its slope.
#include "host/water/afloat.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace {

using demos::WaterAt;
using demos::Waterplane;
using SeaPointer = std::unique_ptr<seaglass::Sea, void (*)(seaglass::Sea*)>;

SeaPointer seaOf(float wind) {
    seaglass::SeaDesc desc;
    desc.windSpeed = wind;
    desc.fetch = 100e3f;
    desc.samples = 128;
    return {seaglass::createSea(&desc, nullptr), seaglass::destroySea};
}

constexpr double level = 3; ///< of calm water [m]

/// Turned, and wherever no wave repeats itself.
glm::dmat4 stands(int number) {
    const glm::dmat4 there = glm::translate(glm::dmat4(1), {37.0 * number, level, -53.0 * number});
    return glm::rotate(there, 0.7 * number, glm::dvec3(0, 1, 0));
}

/// How far the calm water's height over a float, carried along with it, is from the water's, at `places` in
/// the waterplane: -1 to 1 along its sides.
std::vector<double> apart(const seaglass::Sea* sea, const glm::dmat4& calm, const Waterplane& plane,
                          double timeS, const std::vector<glm::dvec2>& places) {
    const WaterAt water(sea, timeS);
    const glm::dmat4 pose = demos::afloat(calm, plane, water);
    std::vector<double> gaps;
    std::vector<glm::dvec2> at;
    for (const glm::dvec2& place : places) {
        const glm::dvec3 local = plane.middle + glm::dvec3(place.x * plane.half.x, 0, place.y * plane.half.y);
        const glm::dvec3 there(pose * glm::dvec4(local, 1));
        at.emplace_back(there.x, there.z);
        gaps.push_back(there.y - level);
    }
    const std::vector<double> heights = water.heights(at);
    for (size_t i = 0; i < gaps.size(); ++i) gaps[i] -= heights[i];
    return gaps;
}

std::vector<glm::dvec2> evenly(int count) {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
            places.emplace_back((2 * i + 1.0) / count - 1, (2 * j + 1.0) / count - 1);
    return places;
}

TEST(Afloat, CalmWaterLeavesItWhereItIs) {
    const Waterplane plane{{0.3, 0, -0.1}, {4, 1.3}};
    EXPECT_EQ(demos::afloat(stands(3), plane, {nullptr, 5}), stands(3));
}

TEST(Afloat, ItsWaterplaneIsWhereItsTrianglesCross) {
    demos::Mesh keel;
    for (const glm::vec3 p : {glm::vec3(-2, -1, 0), glm::vec3(4, 1, 0), glm::vec3(1, 1, 3)})
        keel.vertices.emplace_back().position = p;
    keel.indices = {0, 1, 2};
    const auto plane = demos::waterplaneAt(keel, 0.5);
    ASSERT_TRUE(plane);
    EXPECT_LT(glm::length(plane->middle - glm::dvec3(1.375, 0.5, 1.125)), 1e-6);
    EXPECT_LT(glm::length(plane->half - glm::dvec2(1.125, 1.125)), 1e-6);
    EXPECT_FALSE(demos::waterplaneAt(keel, 1.5)) << "it does not reach there";
}

TEST(Afloat, LiesOnTheMeanOfItsWater) {
    const SeaPointer sea = seaOf(10);
    const Waterplane boat{{0, 0, 0}, {4.1, 1.35}};
    double worst = 0;
    for (int i = 0; i < 12; ++i) {
        double mean = 0;
        const std::vector<double> gaps = apart(sea.get(), stands(i), boat, 3.7 * i, evenly(12));
        for (const double gap : gaps) mean += gap / static_cast<double>(gaps.size());
        worst = std::max(worst, std::abs(mean));
    }
    std::printf("off the mean by %.4f m at most, Hs %.2f m\n", worst, seaglass::significantWaveHeight(*sea));
    EXPECT_LT(worst, 0.03) << "leant over, it takes up a little less";
}

TEST(Afloat, SmallOnesLeanAsTheWaterDoes) {
    const SeaPointer sea = seaOf(10);
    const Waterplane buoy{{0, 0, 0}, {0.3, 0.3}};
    double apart = 0, lean = 0;
    for (int i = 0; i < 24; ++i) {
        const glm::dmat4 pose = demos::afloat(stands(i), buoy, {sea.get(), 2.1 * i});
        const glm::dvec3 up = glm::normalize(glm::dvec3(pose[1]));
        const double at[2] = {stands(i)[3].x, stands(i)[3].z};
        seaglass::HeightSample exact;
        seaglass::sampleHeights(*sea, 2.1 * i, at, 1, &exact);
        const glm::dvec3 normal(exact.normal[0], exact.normal[1], exact.normal[2]);
        apart += glm::degrees(std::acos(std::min(glm::dot(up, normal), 1.0))) / 24;
        lean += glm::degrees(std::acos(normal.y)) / 24;
    }
    std::printf("%.2f degrees from the water's slope, which is %.2f\n", apart, lean);
    EXPECT_GT(lean, 4);
    EXPECT_LT(apart, 0.35 * lean);
}

/// Root of the mean squares of heave and of lean [degrees].
glm::dvec2 motionOf(const seaglass::Sea* sea, double half) {
    const Waterplane plane{{0, 0, 0}, {half, half}};
    glm::dvec2 squares(0);
    for (int i = 0; i < 24; ++i) {
        const glm::dmat4 pose = demos::afloat(stands(i), plane, {sea, 5.3 * i});
        const double heave = pose[3].y - level,
                     lean = glm::degrees(std::acos(std::min(glm::normalize(glm::dvec3(pose[1])).y, 1.0)));
        squares += glm::dvec2(heave * heave, lean * lean) / 24.0;
    }
    return glm::sqrt(squares);
}

TEST(Afloat, LargeOnesAverage) {
    const SeaPointer sea = seaOf(8);
    const glm::dvec2 buoy = motionOf(sea.get(), 0.3), barge = motionOf(sea.get(), 40);
    std::printf("heave %.3f and %.3f m, lean %.2f and %.2f degrees\n", buoy.x, barge.x, buoy.y, barge.y);
    EXPECT_NEAR(buoy.x, seaglass::significantWaveHeight(*sea) / 4, 0.3 * buoy.x);
    EXPECT_LT(barge.x, 0.3 * buoy.x);
    EXPECT_LT(barge.y, 0.15 * buoy.y);
}

TEST(Afloat, NothingFliesOrDrowns) {
    const std::vector<glm::dvec2> outline = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const float wind : {3.0f, 8.0f, 15.0f, 25.0f}) {
        const SeaPointer sea = seaOf(wind);
        const double height = seaglass::significantWaveHeight(*sea);
        double worst = 0, squares = 0;
        for (int i = 0; i < 12; ++i)
            for (const double gap : apart(sea.get(), stands(i), {{0, 0, 0}, {2.15, 0.7}}, 4.9 * i, outline)) {
                worst = std::max(worst, std::abs(gap));
                squares += gap * gap / (12.0 * static_cast<double>(outline.size()));
            }
        std::printf("%2.0f m/s: a rowing boat's waterline is off by %.3f m, at most %.3f; Hs %.2f m\n",
                    static_cast<double>(wind), std::sqrt(squares), worst, height);
        EXPECT_LT(std::sqrt(squares), 0.15);
        EXPECT_LT(worst, 0.66) << "its bow is as high";
    }
}

} // namespace
