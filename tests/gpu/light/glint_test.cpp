// The sun's glitter far off, where many waves lie in a pixel: it stays as it is while the picture moves by
// parts of one, and no pixel outshines those around it.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// What is borne of a sea, as a multiple of the mean over the frames: of a pixel's own, and of all those
/// within two pixels of it.
struct GlintCase {
    Quality quality;
    float wind;
    double ownInAThousand; ///< that one pixel in a thousand may have
    double nearbyAtMost;
};

class GlintFarOff : public WaterTest, public testing::WithParamInterface<GlintCase> {
  protected:
    GlintFarOff() {
        const double elevation = radians(8);
        shineFrom({0, std::sin(elevation), -std::cos(elevation)}, 20);
        camera_.eye = {3, 50, 7};
        camera_.target = camera_.eye + glm::dvec3(0, -std::tan(radians(2)), -1);
        camera_.fovDegrees = 8;
        camera_.width = 160;
        camera_.height = 90;
    }

    /// Red alone: the sky's is 1.
    std::vector<std::vector<double>> jitteredFrames() {
        SeaDesc sea;
        sea.windSpeed = GetParam().wind;
        sea.fetch = 300e3f;
        sea.samples = 128;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        setQuality(GetParam().quality, &desc, nullptr);
        Body* const body = makeBody(desc);
        Camera camera = camera_;
        std::vector<std::vector<double>> frames(16);
        for (size_t i = 0; i < frames.size(); ++i) {
            camera.jitter = {(static_cast<double>(i % 4) + 0.5) / 4 - 0.5,
                             (static_cast<double>(i / 4) + 0.5) / 4 - 0.5};
            const WaterPicture p = picture({body}, camera, 5);
            for (size_t k = 0; k < p.color.size(); k += 4) frames[i].push_back(double{p.color[k]});
        }
        return frames;
    }

    /// Below the horizon, and so far off that a pixel is as long as the longest waves.
    bool holdsManyWaves(uint32_t x, uint32_t y) const {
        const double longest = 100, pixel = radians(camera_.fovDegrees) / camera_.height;
        const double angle = angleBelowHorizon(camera_, x, y);
        return angle > 0.005 && angle < std::sqrt(camera_.eye.y * pixel / longest);
    }

    Camera camera_;
};

TEST_P(GlintFarOff, IsSteadyUnderJitterAndHasNoFireflies) {
    const std::vector<std::vector<double>> frames = jitteredFrames();
    std::vector<double> mean(frames[0].size()), most(frames[0].size());
    for (const std::vector<double>& frame : frames)
        for (size_t i = 0; i < frame.size(); ++i) {
            mean[i] += frame[i] / static_cast<double>(frames.size());
            most[i] = std::max(most[i], frame[i]);
        }
    std::vector<double> own, nearby;
    for (uint32_t y = 2; y + 2 < camera_.height; ++y)
        for (uint32_t x = 2; x + 2 < camera_.width; ++x) {
            if (!holdsManyWaves(x, y)) continue;
            double around = 0;
            for (uint32_t j = y - 2; j <= y + 2; ++j)
                for (uint32_t i = x - 2; i <= x + 2; ++i) around += mean[size_t{j} * camera_.width + i] / 25;
            const size_t pixel = size_t{y} * camera_.width + x;
            own.push_back(most[pixel] / mean[pixel]);
            nearby.push_back(most[pixel] / around);
        }
    ASSERT_GT(own.size(), 2000u);
    std::ranges::sort(own);
    const double ownInAThousand = own[own.size() - 1 - own.size() / 1000];
    const double nearbyAtMost = *std::ranges::max_element(nearby);
    std::printf(
        "of its mean over the frames a pixel has %.3f in the median, %.3f at 99.9 %%, %.3f at most; of "
        "that around it %.3f at most\n",
        own[own.size() / 2], ownInAThousand, own.back(), nearbyAtMost);
    EXPECT_LT(ownInAThousand, GetParam().ownInAThousand);
    EXPECT_LT(nearbyAtMost, GetParam().nearbyAtMost);
    // There is something to see: the sun's path is brighter than the sky by far.
    EXPECT_GT(*std::ranges::max_element(mean), 3);
}

// By more samples along it a pixel shows more of the waves, and is as far from those around it as it should
// be: of 64 samples each, at 10 m/s, one has 3.7 of their mean.
INSTANTIATE_TEST_SUITE_P(
    At, GlintFarOff,
    testing::Values(GlintCase{Quality::medium, 5, 1.2, 1.2}, GlintCase{Quality::medium, 10, 1.45, 1.8},
                    GlintCase{Quality::highest, 5, 1.25, 1.3}, GlintCase{Quality::highest, 10, 2.1, 4}),
    [](const auto& test) {
        return std::string(test.param.quality == Quality::medium ? "Medium" : "Highest") +
               std::to_string(static_cast<int>(test.param.wind));
    });

} // namespace
