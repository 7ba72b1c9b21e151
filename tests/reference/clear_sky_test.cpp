// Clear skies: how they follow the sun, in figures that daylight is measured by.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>

#include "host/camera.h"
#include "host/passes/clear_sky.h"
#include "reference/light/light.h"

namespace {

using namespace demos;

constexpr double pi = std::numbers::pi;

double luminance(const glm::dvec3& c) {
    return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
}

/// Irradiance of the sky on level ground.
glm::dvec3 skylight(const SkyImage& image) {
    glm::dvec3 sum(0);
    for (uint32_t y = 0; y < image.height / 2; ++y) {
        const double polar = pi * (y + 0.5) / image.height;
        const double weight = std::sin(polar) * std::cos(polar) * pi / image.height * 2 * pi / image.width;
        for (uint32_t x = 0; x < image.width; ++x)
            sum += weight * glm::dvec3(image.radiance[size_t{y} * image.width + x]);
    }
    return sum;
}

// Clear days have a tenth to a fifth of their light from the sky under a high sun, and most of it under a sun
// at 5 degrees; the sun is as red then as it is white at noon (CIE 085:1989; Perez et al. 1990).
TEST(ClearSky, GivesMoreOfTheLightAsTheSunSinks) {
    double before = 0;
    for (const double elevationDeg : {60.0, 25.0, 5.0}) {
        const double elevation = elevationDeg * pi / 180;
        const ClearSky sky = clearSky(1, elevation, 2);
        const double diffuse = luminance(skylight(sky.image)),
                     direct = luminance(sky.sunIrradiance) * std::sin(elevation);
        const double share = diffuse / (diffuse + direct), red = sky.sunIrradiance.r / sky.sunIrradiance.b;
        std::printf("sun at %2.0f degrees: %.2f of the light is the sky's, the sun's red over blue %.1f, "
                    "ground %.2f\n",
                    elevationDeg, share, red, diffuse + direct);
        EXPECT_GT(share, before);
        before = share;
        if (elevationDeg == 60) {
            EXPECT_NEAR(share, 0.125, 0.025);
            EXPECT_LT(red, 1.5);
        }
        if (elevationDeg == 5) {
            EXPECT_NEAR(share, 0.6, 0.1);
            EXPECT_GT(red, 5);
        }
    }
}

TEST(ClearSky, IsBrightestAtTheSunAndBlueStraightUp) {
    for (const double elevationDeg : {25.0, 60.0}) {
        const double azimuth = 2.5;
        const SkyImage image = clearSky(azimuth, elevationDeg * pi / 180, 2).image;
        size_t brightest = 0;
        for (size_t i = 0; i < image.radiance.size(); ++i) {
            const glm::vec3& c = image.radiance[i];
            ASSERT_TRUE(std::isfinite(c.r + c.g + c.b) && c.r >= 0 && c.g >= 0 && c.b >= 0) << i;
            if (luminance(c) > luminance(image.radiance[brightest])) brightest = i;
        }
        const double u = (static_cast<double>(brightest % image.width) + 0.5) / image.width;
        const double v = (static_cast<double>(brightest / image.width) + 0.5) / image.height;
        EXPECT_NEAR(2 * pi * u, azimuth, 0.02);
        EXPECT_NEAR(90 - 180 * v, elevationDeg, 4);
        const glm::vec3 up = sampleSky(image, {0, 1, 0}), away = sampleSky(image, {0.8, 0.05, -0.6});
        EXPECT_GT(up.b, 1.8f * up.r);
        EXPECT_GT(luminance(away), luminance(up)) << "the horizon is paler than the zenith";
    }
    const ClearSky dusk = clearSky(0, -6 * pi / 180, 2);
    EXPECT_EQ(luminance(dusk.sunIrradiance), 0);
    EXPECT_GT(luminance(skylight(dusk.image)), 0);
}

// The sun stands where the scene says, and the sky about it, whatever the sky is turned by.
TEST(ClearSky, FollowsTheScenesSun) {
    for (const double turnDeg : {0.0, 77.0}) {
        SkyDesc sky;
        sky.clear = true;
        sky.rotationDeg = turnDeg;
        SunDesc sun;
        sun.azimuthDeg = 140;
        sun.elevationDeg = 25;
        Error error;
        std::optional<SkyImage> image = readSkyImage(sky, error);
        ASSERT_TRUE(image) << error.text;
        reference::Light light;
        ASSERT_TRUE(reference::makeLight(std::move(*image), sky, sun, light, error)) << error.text;
        EXPECT_GT(light.sun.irradiance.r, 2 * sun.irradiance[0]) << "the scene's is not taken";
        const glm::vec3 towards = light.sky(glm::vec3(directionOf(140, 25)));
        const glm::vec3 beside = light.sky(glm::vec3(directionOf(160, 25)));
        EXPECT_GT(luminance(towards), 2 * luminance(beside)) << turnDeg;
    }
}

} // namespace
