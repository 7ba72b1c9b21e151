// The sun in still water: as large as its disc, mirrored and seen through the surface, and of all its light.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double discRadius = 0.00465; // [rad]
constexpr double sunlight = 2;         // whose disc shines as halves can hold

class SunDisc : public WaterTest, public testing::WithParamInterface<double> {
  protected:
    SunDisc() {
        const double elevation = radians(GetParam());
        toSun_ = {std::cos(elevation) * 0.6, std::sin(elevation), std::cos(elevation) * 0.8};
        for (int i = 0; i < 3; ++i) lighting.toSun[i] = toSun_[i];
        for (float& channel : lighting.sunIrradiance) channel = static_cast<float>(sunlight);
        for (float& channel : lighting.skyIrradiance) channel = 0;
    }

    static Camera closeUp(double height, const glm::dvec3& along) {
        Camera camera;
        camera.eye = {0, height, 0};
        camera.target = camera.eye + along;
        camera.fovDegrees = 1.2;
        camera.width = camera.height = 160;
        return camera;
    }

    /// What shines: brighter than the sky by far.
    struct Seen {
        double across = 0, upright = 0; ///< extents [rad]
        double light = 0;               ///< on a plane that faces it
    };
    Seen seen(const BodyDesc& desc, const Camera& camera) {
        const WaterPicture p = picture({makeBody(desc)}, camera);
        const double pixel = 2 * std::tan(radians(camera.fovDegrees) / 2) / camera.height;
        uint32_t left = p.width, right = 0, top = p.height, bottom = 0;
        Seen sum;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const auto radiance = double{p.color[(size_t{y} * p.width + x) * 4]};
                if (radiance < 20) continue;
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
                sum.light += radiance * pixel * pixel;
            }
        sum.across = (right + 1.0 - left) * pixel;
        sum.upright = (bottom + 1.0 - top) * pixel;
        return sum;
    }

    glm::dvec3 toSun_{0};
};

TEST_P(SunDisc, IsMirroredAsItIs) {
    const Seen sun = seen({}, closeUp(2, toSun_ * glm::dvec3(1, -1, 1)));
    EXPECT_NEAR(sun.across, 2 * discRadius, 0.05 * discRadius);
    EXPECT_NEAR(sun.upright, 2 * discRadius, 0.05 * discRadius);
    const double light = sunlight * reflectance(toSun_.y);
    EXPECT_NEAR(sun.light, light, 0.03 * light);
}

// Refraction narrows it, upright more than across.
TEST_P(SunDisc, IsSeenFromBelowAsItIsBent) {
    const RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
    const UnderwaterDesc underwater;
    BodyDesc desc;
    desc.refraction = &clear;
    desc.underwater = &underwater;
    glm::dvec3 bent = toSun_ / waterIndex;
    bent.y = std::sqrt(1 - bent.x * bent.x - bent.z * bent.z);
    const Seen sun = seen(desc, closeUp(-3, bent));
    const double narrower = toSun_.y / bent.y;
    EXPECT_NEAR(sun.across, 2 * discRadius / waterIndex, 0.06 * discRadius);
    EXPECT_NEAR(sun.upright, 2 * discRadius / waterIndex * narrower, 0.06 * discRadius);
    const double light = sunlight * (1 - reflectance(toSun_.y)) * narrower;
    EXPECT_NEAR(sun.light, light, 0.03 * light);
}

INSTANTIATE_TEST_SUITE_P(Elevation, SunDisc, testing::Values(15.0, 40.0, 75.0),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param)); });

} // namespace
