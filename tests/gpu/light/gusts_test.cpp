// Cat's paws: patches as rough as the open sea, that run with the wind and come again with the loop.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/unit/sea/statistics.h"
#include "water/interface/sea_contents.h"

namespace {

using namespace seaglass;
using namespace tests;

class Gusts : public WaterTest {
  protected:
    Gusts() {
        sea_.windSpeed = 4; // to the right
        sea_.samples = 32;
        sea_.cascades = 2;
        sea_.amplitude = 0.1f;
        camera_.eye = {0, 800, 0};
        camera_.target = {0, 0, 0};
        camera_.fovDegrees = 40;
        camera_.width = camera_.height = 128;
    }

    Body* body(float gusts) {
        BodyDesc desc;
        desc.waves = &sea_;
        desc.wavesBackend = fftwWaves();
        desc.shading.gusts = gusts;
        return makeBody(desc);
    }

    /// Variance of slopes within each pixel, both axes together.
    std::vector<double> roughness(Body* body, double time) {
        const WaterPicture p = picture({body}, camera_, time, SurfaceOutput::slopes);
        std::vector<double> out;
        for (size_t i = 0; i < p.color.size(); i += 4)
            out.push_back(double{p.color[i + 2]} + double{p.color[i + 3]});
        return out;
    }

    /// So many minutes, in each of which gusts are others.
    static constexpr int minutes_ = 24;
    SeaDesc sea_;
    Camera camera_;
};

TEST_F(Gusts, AreAsRoughAsTheOpenSeaWhereTheyAre) {
    const double open = coxMunkSlopeVariance(double{sea_.windSpeed});
    Body* const gusty = body(1);
    std::vector<double> all;
    for (int i = 0; i < minutes_; ++i) {
        const std::vector<double> now = roughness(gusty, 15 + 60 * i);
        all.insert(all.end(), now.begin(), now.end());
    }
    std::ranges::sort(all);
    const double lulls = all[all.size() / 4], most = all[all.size() * 99 / 100];
    std::printf("of the open sea's: %.3f in lulls, %.3f in the mean, %.3f in gusts\n", lulls / open,
                meanOf(all) / open, most / open);
    EXPECT_LT(lulls, 0.1 * open);
    EXPECT_NEAR(meanOf(all) / open, 0.27, 0.06);
    EXPECT_GT(most, 0.7 * open);
    EXPECT_LT(most, 1.1 * open);
}

TEST_F(Gusts, LeaveTheOpenSeaAsRoughInTheMean) {
    sea_.amplitude = 1;
    Body *const with = body(1), *const without = body(0);
    const double even = minutes_ * meanOf(roughness(without, 15));
    double gusty = 0;
    for (int i = 0; i < minutes_; ++i) gusty += meanOf(roughness(with, 15 + 60 * i));
    std::printf("%.3f of what it is without\n", gusty / even);
    EXPECT_NEAR(gusty / even, 1, 0.15);
}

// Pixels of hundreds of metres show gusts and lulls together.
TEST_F(Gusts, AreTheirMeanFromFarUp) {
    sea_.amplitude = 1;
    camera_.eye.y = 60e3;
    camera_.width = camera_.height = 32;
    const double even = meanOf(roughness(body(0), 15)), gusty = meanOf(roughness(body(1), 15));
    std::printf("%.3f of what it is without\n", gusty / even);
    EXPECT_NEAR(gusty / even, 1, 0.02);
}

// Between cells of the noise, too, a gust ends softly.
TEST_F(Gusts, HaveNoSeams) {
    camera_.eye.y = 150;
    Body* const gusty = body(1);
    double step = 0, most = 0;
    for (int i = 0; i < 6; ++i) {
        const std::vector<double> rough = roughness(gusty, 15 + 60 * i);
        for (size_t at = 0; at + camera_.width < rough.size(); ++at) {
            if (at % camera_.width + 1 < camera_.width)
                step = std::max(step, std::abs(rough[at + 1] - rough[at]));
            step = std::max(step, std::abs(rough[at + camera_.width] - rough[at]));
            most = std::max(most, rough[at]);
        }
    }
    std::printf("from pixel to pixel by %.3f of the greatest\n", step / most);
    EXPECT_LT(step, 0.25 * most);
}

// As far from picture to picture as what is seen is most alike.
TEST_F(Gusts, RunWithTheWind) {
    const double metresPerPixel =
        camera_.eye.y * 2 * std::tan(radians(camera_.fovDegrees) / 2) / camera_.height;
    constexpr double step = 12;
    Body* const gusty = body(1);
    const std::vector<double> before = roughness(gusty, 24), after = roughness(gusty, 24 + step);
    const size_t width = camera_.width;
    double least = 1e30;
    size_t most = 0;
    for (size_t shift = 0; shift < 40; ++shift) {
        double apart = 0;
        for (size_t i = 0; i < before.size(); ++i)
            if (i % width + shift < width) apart += std::abs(before[i] - after[i + shift]);
        apart /= static_cast<double>(width - shift);
        if (apart < least) {
            least = apart;
            most = shift;
        }
    }
    const double speed = static_cast<double>(most) * metresPerPixel / step;
    std::printf("%.2f m/s\n", speed);
    EXPECT_NEAR(speed, double{sea_.windSpeed}, metresPerPixel / step);
}

TEST_F(Gusts, ComeAgainWithTheLoop) {
    const double loop = double{sea_.loopPeriod};
    Body* const gusty = body(1);
    const std::vector<double> first = roughness(gusty, 7), again = roughness(gusty, 7 + 3 * loop);
    double apart = 0;
    for (size_t i = 0; i < first.size(); ++i) apart = std::max(apart, std::abs(first[i] - again[i]));
    EXPECT_LT(apart, 1e-3 * *std::ranges::max_element(first));
}

} // namespace
