#include "water/interface/warp.h"

#include "tests/unit/sea/sea_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using namespace seaglass;
using tests::makeSea;

SeaDesc smallSea() {
    SeaDesc desc;
    desc.samples = 64;
    desc.cascades = 2;
    desc.choppiness = 0;
    return desc;
}

// At even distances in a field that begins at `u`, `v`.
std::vector<double> heightsFrom(const Sea& sea, double u, double v) {
    constexpr size_t across = 24;
    constexpr double apart = 37;
    std::vector<double> points;
    for (size_t i = 0; i < across * across; ++i) {
        points.push_back(u + apart * static_cast<double>(i % across));
        points.push_back(v + apart * static_cast<double>(i / across));
    }
    std::vector<HeightSample> samples(across * across);
    sampleHeights(sea, 9, points.data(), samples.size(), samples.data());
    std::vector<double> heights;
    for (const HeightSample& s : samples) heights.push_back(static_cast<double>(s.height));
    return heights;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double both = 0, ofA = 0, ofB = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        both += a[i] * b[i];
        ofA += a[i] * a[i];
        ofB += b[i] * b[i];
    }
    return both / std::sqrt(ofA * ofB);
}

TEST(Warp, GradientIsThatOfTheShift) {
    const auto sea = makeSea(smallSea());
    const auto shiftAt = [&](double u, double v) { return warpAt(sea->warp, u, v); };
    constexpr double step = 1e-3;
    for (const double u : {-4000.0, 13.0, 777.0})
        for (const double v : {-90.0, 2500.0}) {
            const WarpShift here = shiftAt(u, v);
            const WarpShift left = shiftAt(u - step, v), right = shiftAt(u + step, v);
            const WarpShift above = shiftAt(u, v - step), below = shiftAt(u, v + step);
            EXPECT_NEAR(here.uu, (right.u - left.u) / (2 * step), 1e-3);
            EXPECT_NEAR(here.vu, (right.v - left.v) / (2 * step), 1e-3);
            EXPECT_NEAR(here.uv, (below.u - above.u) / (2 * step), 1e-3);
            EXPECT_NEAR(here.vv, (below.v - above.v) / (2 * step), 1e-3);
        }
    EXPECT_EQ(shiftAt(0, 0).u, 0);
    EXPECT_EQ(shiftAt(0, 0).v, 0);
}

// Normals are the surface's own: across what its heights do around, where the shift stretches waves too.
TEST(Warp, NormalsAreThoseOfTheHeights) {
    const auto sea = makeSea(smallSea());
    constexpr double step = 0.01;
    double farthest = 0, steepest = 0;
    for (int i = 0; i < 40; ++i) {
        const double u = 531.7 * i - 9000, v = 4000 - 377.3 * i;
        const double points[] = {u, v, u - step, v, u + step, v, u, v - step, u, v + step};
        HeightSample s[5];
        sampleHeights(*sea, 3, points, 5, s);
        const auto slope = [&](int low, int high) {
            return (static_cast<double>(s[high].height) - static_cast<double>(s[low].height)) / (2 * step);
        };
        const auto tilt = [&](int axis) { return -static_cast<double>(s[0].normal[axis] / s[0].normal[1]); };
        farthest = std::max({farthest, std::abs(tilt(0) - slope(1, 2)), std::abs(tilt(2) - slope(3, 4))});
        steepest = std::max({steepest, std::abs(tilt(0)), std::abs(tilt(2))});
    }
    EXPECT_GT(steepest, 0.1);
    EXPECT_LT(farthest, 1e-3);
}

TEST(Warp, NoTwoPlacesATileApartAreAlike) {
    SeaDesc desc = smallSea();
    desc.cascades = 1;
    for (const float strength : {0.0f, 1.0f}) {
        desc.warp = strength;
        const auto sea = makeSea(desc);
        const double patch = sea->cascades[0].patch;
        const auto here = heightsFrom(*sea, 100, -200);
        double most = 0;
        for (const auto& [u, v] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {5, -3}}) {
            const auto there = heightsFrom(*sea, 100 + u * patch, -200 + v * patch);
            most = std::max(most, correlation(here, there));
        }
        std::printf("warp %.0f: heights whole tiles apart correlate by %.3f at most\n",
                    static_cast<double>(strength), most);
        if (strength > 0) {
            EXPECT_LT(most, 0.35);
        } else {
            EXPECT_GT(most, 0.9);
        }
    }
}

} // namespace
