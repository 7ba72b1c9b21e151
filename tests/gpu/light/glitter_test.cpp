// The sun's path as single facets: as bright as the smooth one in the mean, points that thin outwards, and as
// slow as the waves that they stand for.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Glitter : public WaterTest {
  protected:
    Glitter() {
        const double elevation = radians(30);
        shineFrom({0, std::sin(elevation), -std::cos(elevation)}, 20);
        camera.eye = {3, 10, 7};
        camera.target = camera.eye + glm::dvec3(0, -std::tan(radians(22)), -1);
        camera.fovDegrees = 40;
        camera.width = 160;
        camera.height = 90;
    }

    Body* sea(float glitter) {
        SeaDesc desc;
        desc.windSpeed = 5;
        desc.samples = 64;
        BodyDesc body;
        body.waves = &desc;
        body.wavesBackend = fftwWaves();
        body.shading.glitter = glitter;
        return makeBody(body);
    }

    /// Red alone, of which the sky's is 1 times Fresnel.
    std::vector<double> red(Body* body, double time) {
        const WaterPicture p = picture({body}, camera, time);
        std::vector<double> out;
        for (size_t i = 0; i < p.color.size(); i += 4) out.push_back(double{p.color[i]});
        return out;
    }

    Camera camera;
};

double sumOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

/// Over the mean of the first.
double changeBetween(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / sumOf(a);
}

/// Light where the smooth path is more than half as bright as in its middle, and of the rest.
struct BandsOfLight {
    double middle = 0, outside = 0;
};

void add(const std::vector<double>& light, const std::vector<double>& smooth, BandsOfLight& to) {
    const double half = 0.5 * *std::ranges::max_element(smooth);
    for (size_t i = 0; i < light.size(); ++i) (smooth[i] > half ? to.middle : to.outside) += light[i];
}

TEST_F(Glitter, IsAsBrightAsTheSmoothPathInTheMean) {
    Body* const smooth = sea(0);
    Body* const facets = sea(0.5f);
    BandsOfLight before, after;
    for (int i = 0; i < 32; ++i) {
        camera.eye.x = i % 2 == 0 ? 3 : 3e6;
        camera.target.x = camera.eye.x;
        const std::vector<double> asBefore = red(smooth, 5 + 4.3 * i);
        add(asBefore, asBefore, before);
        add(red(facets, 5 + 4.3 * i), asBefore, after);
    }
    const double middle = after.middle / before.middle, outside = after.outside / before.outside;
    std::printf("facets have %.4f of the smooth path's light in its middle, %.4f beside\n", middle, outside);
    EXPECT_NEAR(middle, 1, 0.05);
    EXPECT_NEAR(outside, 1, 0.04);
}

TEST_F(Glitter, IsPointsThatThinOutwards) {
    const std::vector<double> smooth = red(sea(0), 5), facets = red(sea(0.8f), 5);
    // Relative deviation from the smooth path, in its middle and where it is a tenth as bright.
    const double brightest = *std::ranges::max_element(smooth);
    double squares[2] = {0, 0};
    uint32_t count[2] = {0, 0}, dark[2] = {0, 0};
    for (size_t i = 0; i < smooth.size(); ++i) {
        const double share = smooth[i] / brightest;
        const int band = share > 0.6 ? 0 : 1;
        if (band == 1 && (share < 0.05 || share > 0.15)) continue;
        squares[band] += std::pow(facets[i] / smooth[i] - 1, 2);
        dark[band] += facets[i] < 0.5 * smooth[i] ? 1 : 0;
        ++count[band];
    }
    ASSERT_GT(count[0], 200u);
    ASSERT_GT(count[1], 200u);
    const double middle = std::sqrt(squares[0] / count[0]), edge = std::sqrt(squares[1] / count[1]);
    std::printf(
        "deviation over the smooth path: %.2f in its middle, %.2f at its edge; dark there %.2f, %.2f\n",
        middle, edge, double{1.0 * dark[0]} / count[0], double{1.0 * dark[1]} / count[1]);
    EXPECT_GT(middle, 0.5);
    EXPECT_GT(edge, 1.15 * middle);
    EXPECT_GT(1.0 * dark[1] / count[1], 1.0 * dark[0] / count[0] + 0.05);
}

// From the air each pixel has the mean of many waves: of 48 m2 from 200 m.
TEST_F(Glitter, IsSmoothFromFarUp) {
    Body *const smooth = sea(0), *const facets = sea(0.8f);
    const auto changeFrom = [&](double height) {
        camera.target += glm::dvec3(0, height - camera.eye.y, 0);
        camera.eye.y = height;
        return changeBetween(red(smooth, 5), red(facets, 5));
    };
    const double low = changeFrom(10), high = changeFrom(200), highest = changeFrom(1e5);
    std::printf("facets change the path by %.3f from 10 m, %.3f from 200 m, %.4f from 100 km\n", low, high,
                highest);
    EXPECT_GT(low, 0.3);
    EXPECT_LT(high, 0.09 * low); // 0.57 of it where 400 m2 tilt as one, 0.11 where 4 m2 do
    EXPECT_LT(highest, 0.01);
}

TEST_F(Glitter, ComesAndGoesAsWavesDo) {
    camera.eye.y += 10;
    camera.target.y += 10;
    Body* const smooth = sea(0);
    Body* const facets = sea(0.8f);
    const std::vector<double> before = red(facets, 5), next = red(facets, 5 + 1.0 / 60);
    const double step = changeBetween(before, next), whole = changeBetween(before, red(facets, 15));
    const double waves = changeBetween(red(smooth, 5), red(smooth, 5 + 1.0 / 60));
    std::printf("change in 1/60 s %.4f, of the smooth path %.4f, in 10 s %.3f\n", step, waves, whole);
    EXPECT_LT(step, 0.12 * whole);
    EXPECT_GT(whole, 0.5);
}

TEST_F(Glitter, StaysOnTheWaterAsTheEyeMoves) {
    Body* const facets = sea(0.8f);
    const std::vector<double> before = red(facets, 5);
    camera.eye.x += 0.01;
    camera.target.x += 0.01;
    const double step = changeBetween(before, red(facets, 5));
    camera.eye.x += 7;
    camera.target.x += 7;
    const double whole = changeBetween(before, red(facets, 5));
    std::printf("change as the eye moves by 1 cm %.4f, by 7 m %.3f\n", step, whole);
    EXPECT_LT(step, 0.15 * whole);
    EXPECT_GT(whole, 0.5);
}

// By parallel lines of sight, aslant to both axes of the water: where the eye moves to the right by pixels,
// the picture is the same, moved to the left by as many.
TEST_F(Glitter, IsTheSameOnTheSameWater) {
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(0.64, -0.4, -0.77)), right(0.77, 0, 0.64);
    const auto shown = [&](Body* body, int pixels) {
        camera.parallelHeight = 18;
        camera.far = 200;
        camera.eye = glm::dvec3(3, 10, 7) + glm::normalize(right) * (pixels * camera.parallelHeight / 90);
        camera.target = camera.eye + ahead;
        return red(body, 5);
    };
    shineFrom(glm::normalize(glm::dvec3(0.64, 0.5, -0.77)), 20);
    Body* const facets = sea(0.8f);
    const std::vector<double> before = shown(facets, 0), after = shown(facets, 7);
    double moved = 0, apart = 0, all = 0;
    for (size_t y = 0; y < 90; ++y)
        for (size_t x = 0; x + 7 < 160; ++x) {
            moved += std::abs(after[y * 160 + x] - before[y * 160 + x + 7]);
            apart += std::abs(after[y * 160 + x] - before[y * 160 + x]);
            all += before[y * 160 + x];
        }
    std::printf("%.4f of the light differs on the same water, %.3f in the same pixels\n", moved / all,
                apart / all);
    EXPECT_GT(apart, 0.5 * all);
    EXPECT_LT(moved, 0.1 * apart);
}

} // namespace
