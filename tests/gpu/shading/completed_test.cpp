// Surfaces of which one pixel of 2 or of 4 is shaded: that the others are what they would be,
// nearly, that nothing bleeds over a crest's edge, and that a slow camera sees no more change.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Completed : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        sea_ = breeze();
        body_.waves = &sea_;
        body_.wavesBackend = fftwWaves();
        body_.refraction = &refraction_;
        camera_.eye = {3, 4, 7};
        camera_.target = {3, 2, -13};
        camera_.width = 181;
        camera_.height = 99;
        shineFrom(glm::normalize(glm::dvec3(0.3, 0.15, -0.94)), 5);
    }

    void shadeOneOf(uint32_t pixels) {
        body_.shading.pixelsPerShading = pixels;
        shown_ = makeBody(body_);
    }

    WaterPicture taken() { return picture({shown_}, camera_, 5, SurfaceOutput::shaded, behind_); }

    RefractionDesc refraction_;
    BodyDesc body_;
    Camera camera_;
    SceneBehind behind_;

  private:
    SeaDesc sea_;
    Body* shown_ = nullptr;
};

/// In the mean over what both cover, as a share of the first's mean.
double differenceOf(const WaterPicture& a, const WaterPicture& b) {
    double sum = 0, all = 0;
    for (size_t i = 0; i < a.depth.size(); ++i) {
        if (!a.covered(i) || !b.covered(i)) continue;
        for (size_t k = 4 * i; k < 4 * i + 3; ++k) {
            sum += std::abs(double{a.color[k]} - double{b.color[k]});
            all += double{a.color[k]};
        }
    }
    return sum / all;
}

// Lines along rows stay lines, and along columns too: a mean of all around would make dots of their edges.
TEST_F(Completed, MakesNoDotsOfEdges) {
    body_.waves = nullptr;
    refraction_.distortion = 0;
    for (const bool columns : {false, true}) {
        behind_ = planeBelow(camera_, -1, 0.5f);
        for (size_t i = 0; i < behind_.depth.size(); ++i)
            if ((columns ? i % camera_.width : i / camera_.width) / 6 % 2)
                std::fill_n(&behind_.color[4 * i], 3, 20.0f);
        shadeOneOf(1);
        const WaterPicture all = taken();
        shadeOneOf(2);
        const WaterPicture some = taken();
        double worst = 0;
        for (uint32_t y = camera_.height / 2; y + 6 < camera_.height; ++y)
            for (uint32_t x = 6; x + 6 < camera_.width; ++x) {
                const size_t i = 4 * (size_t{y} * camera_.width + x);
                worst = std::max(worst, std::abs(double{some.color[i]} / double{all.color[i]} - 1));
            }
        std::printf("off by %.3f at most\n", worst);
        EXPECT_LT(worst, columns ? 1.5 : 0.05);
    }
}

TEST_F(Completed, ShowsNearlyWhatAllPixelsDo) {
    shadeOneOf(1);
    const WaterPicture all = taken();
    double before = 0;
    for (const uint32_t pixels : {2u, 4u}) {
        SCOPED_TRACE(pixels);
        shadeOneOf(pixels);
        const WaterPicture some = taken();
        for (size_t i = 0; i < all.depth.size(); ++i) {
            ASSERT_EQ(all.covered(i), some.covered(i)) << i;
            ASSERT_EQ(all.depth[i], some.depth[i]) << i;
            for (size_t k = 4 * i; k < 4 * i + 3; ++k) ASSERT_TRUE(std::isfinite(some.color[k])) << i;
        }
        const double differs = differenceOf(all, some);
        std::printf("one of %u: %.4f\n", pixels, differs);
        EXPECT_GT(differs, before);
        EXPECT_LT(differs, pixels == 2 ? 0.06 : 0.10);
        before = differs;
        const WaterPicture again = taken();
        EXPECT_EQ(std::memcmp(some.color.data(), again.color.data(), some.color.size() * sizeof(float)), 0);
    }
}

TEST_F(Completed, ASlowCameraSeesNoMoreChange) {
    double first = 0;
    for (const uint32_t pixels : {1u, 2u, 4u}) {
        shadeOneOf(pixels);
        camera_.jitter = {0, 0};
        double change = 0;
        WaterPicture last = taken();
        for (int frame = 1; frame < 16; ++frame) {
            camera_.jitter = {0.5 * frame, 0.125 * frame};
            WaterPicture now = taken();
            change += differenceOf(last, now) / 15;
            last = std::move(now);
        }
        std::printf("one of %u: %.4f\n", pixels, change);
        if (pixels == 1) first = change;
        EXPECT_LE(change, first) << pixels;
    }
}

} // namespace
