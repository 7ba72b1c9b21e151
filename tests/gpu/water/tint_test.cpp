// Water whose coefficients come from a tint is drawn in that colour, and as clear as asked for.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seaglass/water_type.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double index = 1.333;
constexpr double keepsUpright = 1 - (index - 1) * (index - 1) / ((index + 1) * (index + 1));

using Color = std::array<float, 3>;
constexpr Color teal = {0.004f, 0.055f, 0.045f}, brown = {0.05f, 0.03f, 0.01f};

class Tint : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        camera_.eye = {0, 10, 0};
        camera_.target = {0, 0, 0};
        camera_.fovDegrees = 30;
        camera_.width = 64;
        camera_.height = 36;
    }

    Body* tinted(const Color& tint, float visibility) {
        WaterCoefficients water{};
        SeaError error;
        EXPECT_TRUE(tintedWater(tint.data(), visibility, &water, &error)) << error.text;
        return make(water);
    }
    /// Sends nothing back, so that it shows what all water mirrors.
    Body* black() { return make({{100, 100, 100}, {0, 0, 0}}); }

    Body* make(const WaterCoefficients& water) {
        RefractionDesc refraction;
        std::copy_n(water.absorption, 3, refraction.absorption);
        std::copy_n(water.backscatter, 3, refraction.backscatter);
        desc_.refraction = &refraction;
        Body* body = makeBody(desc_);
        desc_.refraction = nullptr;
        return body;
    }

    /// A sun from the side, whose glint is out of sight, and a sky. Returns the irradiance that enters.
    double lightEntering() {
        lighting.toSun[0] = 0.6;
        lighting.toSun[1] = 0.8;
        lighting.toSun[2] = 0;
        for (float& channel : lighting.sunIrradiance) channel = 500;
        for (float& channel : lighting.skyIrradiance) channel = 200;
        const double inside = std::sqrt(1 - 0.36 / (index * index));
        const double s = (0.8 - index * inside) / (0.8 + index * inside);
        const double t = (index * 0.8 - inside) / (index * 0.8 + inside);
        return 500 * 0.8 * (1 - (s * s + t * t) / 2) + 200 * 0.934;
    }

    /// Of the light that enters, the share that water sends back, by the radiance that left it upright.
    static double sentBack(double radiance, double entering) {
        const double under = radiance / (keepsUpright * 0.98 / (index * index));
        return under * std::numbers::pi / entering;
    }

    size_t pixel(double across) const {
        return size_t{camera_.height / 2} * camera_.width +
               static_cast<size_t>(across * static_cast<double>(camera_.width));
    }

    Camera camera_;
    BodyDesc desc_;
};

TEST_F(Tint, IsTheColourThatDeepWaterIsDrawnIn) {
    const double entering = lightEntering();
    const WaterPicture mirrored = picture({black()}, camera_);
    constexpr Color tints[] = {{0.001f, 0.008f, 0.035f},   {0.25f, 0.32f, 0.33f},   {0.33f, 0.01f, 0.0005f},
                               {0.01f, 0.33f, 0.0005f},    {0.0005f, 0.01f, 0.33f}, {0.05f, 0.03f, 0.01f},
                               {0.0004f, 0.0006f, 0.0005f}};
    for (const Color& tint : tints)
        for (const float visibility : {0.05f, 4.0f, 1000.0f}) {
            const WaterPicture p = picture({tinted(tint, visibility)}, camera_);
            const size_t at = pixel(0.5);
            for (size_t c = 0; c < 3; ++c) {
                const double sent = double{p.color[at * 4 + c]} - double{mirrored.color[at * 4 + c]};
                EXPECT_NEAR(sentBack(sent, entering), double{tint[c]}, 0.01 * double{tint[c]})
                    << c << " of " << tint[0] << ' ' << tint[1] << ' ' << tint[2] << " at " << visibility;
            }
        }
}

// In no light what lies below shines itself.
TEST_F(Tint, LetsOneTwentiethThroughItsVisibility) {
    const WaterPicture mirrored = picture({black()}, camera_);
    for (const double visibility : {0.5, 6.0, 80.0})
        for (const Color& tint : {teal, brown}) {
            constexpr float radiance = 1000;
            const SceneBehind behind = planeBelow(camera_, -visibility, radiance);
            const WaterPicture p = picture({tinted(tint, static_cast<float>(visibility))}, camera_, 0,
                                           SurfaceOutput::shaded, behind);
            const size_t at = pixel(0.5) * 4;
            double most = 0;
            for (size_t c = 0; c < 3; ++c) {
                const double sent = double{p.color[at + c]} - double{mirrored.color[at + c]};
                const double through = sent * index * index / (keepsUpright * double{radiance});
                const double clearest = double{*std::ranges::max_element(tint)};
                EXPECT_NEAR(through, std::pow(0.05, clearest / double{tint[c]}), 1e-3) << c;
                most = std::max(most, through);
            }
            EXPECT_NEAR(most, 0.05, 0.0005) << visibility;
        }
}

TEST_F(Tint, IsEachBodysOwnInOneView) {
    const double entering = lightEntering();
    desc_.extent.shape = ExtentShape::rectangle;
    desc_.extent.size[0] = desc_.extent.size[1] = 20;
    desc_.extent.center[0] = -10;
    Body* const left[] = {tinted(teal, 5), black()};
    desc_.extent.center[0] = 10;
    Body* const right[] = {tinted(brown, 3), black()};
    const WaterPicture p = picture({left[0], right[0]}, camera_);
    const WaterPicture mirrored = picture({left[1], right[1]}, camera_);
    for (size_t c = 0; c < 3; ++c) {
        const auto sent = [&](double across) {
            const size_t i = pixel(across) * 4 + c;
            return sentBack(double{p.color[i]} - double{mirrored.color[i]}, entering);
        };
        EXPECT_NEAR(sent(0.4), double{teal[c]}, 0.01 * double{teal[c]}) << c;
        EXPECT_NEAR(sent(0.6), double{brown[c]}, 0.01 * double{brown[c]}) << c;
    }
}

} // namespace
