// What shines through ripples that are too small to be seen is as blurred as they bend rays.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/interface/sea_contents.h"

namespace {

using namespace seaglass;
using namespace tests;

class BedBlur : public WaterTest, public testing::WithParamInterface<uint32_t> {
  protected:
    BedBlur() {
        for (float& channel : lighting.skyIrradiance) channel = 0; // of no light, the bed's is its own
        desc_.refraction = &refraction_;
        desc_.shading.refractionSamples = GetParam();
    }

    static Camera straightDown() {
        Camera camera;
        camera.eye = {3, 4, 7};
        camera.target = {3, 0, 7};
        camera.fovDegrees = 30;
        camera.width = camera.height = 192;
        return camera;
    }

    /// A bed whose radiance rises and falls along x or z.
    static SceneBehind striped(const Camera& camera, double depth, double wavelength, bool along) {
        SceneBehind bed = planeBelow(camera, -depth, 1);
        for (uint32_t y = 0; y < camera.height; ++y)
            for (uint32_t x = 0; x < camera.width; ++x) {
                const glm::dvec3 ray = rayThrough(camera, x, y);
                const glm::dvec3 met = camera.eye - ray * ((camera.eye.y + depth) / ray.y);
                const double phase = 2 * std::numbers::pi * (along ? met.x : met.z) / wavelength;
                std::fill_n(&bed.color[(size_t{y} * camera.width + x) * 4], 3,
                            static_cast<float>(10 + 5 * std::cos(phase)));
            }
        return bed;
    }

    /// Deviation from the mean, of the middle of the picture.
    double contrast(Body* body, const Camera& camera, const SceneBehind& bed) {
        const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, bed);
        double sum = 0, squares = 0, count = 0;
        for (uint32_t y = p.height / 4; y < p.height * 3 / 4; ++y)
            for (uint32_t x = p.width / 4; x < p.width * 3 / 4; ++x) {
                const auto value = double{p.color[(size_t{y} * p.width + x) * 4]};
                sum += value;
                squares += value * value;
                ++count;
            }
        return std::sqrt(squares / count - sum * sum / (count * count));
    }

    RefractionDesc refraction_{{0, 0, 0}, {0, 0, 0}, 1};
    BodyDesc desc_;
};

TEST_P(BedBlur, IsThatOfTheSlopesThatNoMapHolds) {
    const Camera camera = straightDown();
    Body* const flat = makeBody(desc_);
    SeaDesc sea; // whose maps hold swell alone, of next to no slope
    sea.windSpeed = 5;
    sea.samples = 64;
    sea.cascades = 1;
    sea.largestPatch = 2000;
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    Body* const rough = makeBody(desc_);
    const SlopeCovariance slopes = roughness(*seaglass::sea(rough));
    constexpr double depth = 2;
    for (const double wavelength : {0.25, 0.4, 0.8})
        for (const bool along : {true, false}) {
            const SceneBehind bed = striped(camera, depth, wavelength, along);
            const double left = contrast(rough, camera, bed) / contrast(flat, camera, bed);
            const double strays = (1 - 1 / waterIndex) * std::sqrt(along ? slopes.uu : slopes.vv) * depth;
            const double expected = std::exp(-2 * std::pow(std::numbers::pi * strays / wavelength, 2));
            std::printf("%.2f m: %.3f of the contrast is left, expected %.3f\n", wavelength, left, expected);
            EXPECT_NEAR(left, expected, 0.1);
        }
}

INSTANTIATE_TEST_SUITE_P(Samples, BedBlur, testing::Values(3u, 8u),
                         [](const auto& test) { return std::to_string(test.param); });

} // namespace
