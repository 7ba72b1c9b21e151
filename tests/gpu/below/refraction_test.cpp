// What lies below water, seen through it: dimmed, bent, and made up where nobody sees it.
#include <algorithm>
#include <cmath>

#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/sea_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Refraction : public SeaTest {
  protected:
    /// Flat, over whatever lies behind.
    Body* waterOf(const RefractionDesc& refraction) {
        BodyDesc desc;
        desc.refraction = &refraction;
        return makeBody(desc);
    }

    static constexpr RefractionDesc dimming_ = {{0.5f, 0.2f, 0.1f}, {0, 0, 0}, 1};
};

// Light goes down as far as it comes back: over a black bed what is missing to endless water fades twice as
// fast as a beam.
TEST_F(Refraction, ShallowWaterGlowsLessByTheWayThereAndBack) {
    const RefractionDesc turbid = {{0.2f, 0.2f, 0.2f}, {0.05f, 0.05f, 0.05f}, 1};
    for (float& channel : lighting.skyIrradiance) channel = 20;
    Body* const body = waterOf(turbid);
    Camera camera = seaCamera();
    camera.eye = {3, 9, 7};
    camera.target = {3.001, 0, 7};
    camera.width = camera.height = 9;
    const auto over = [&](double depth) {
        return double{
            picture({body}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, -depth, 0)).color[4 * 40]};
    };
    const double endless = over(60), one = endless - over(1), two = endless - over(2);
    const double perMetre = std::log(one / two);
    std::printf("%.4f, %.4f of %.4f missing: %.3f a metre\n", one, two, endless, perMetre);
    EXPECT_NEAR(perMetre, 2 * 0.25, 0.02);
}

TEST_F(Refraction, WhatLiesBelowIsDimmedByBeerAndLambert) {
    Body* body = waterOf(dimming_);
    Camera camera = seaCamera();
    camera.target = {3, 0, -1};
    const double bed = -1.5;
    const SceneBehind behind = planeBelow(camera, bed, 4);
    const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, behind);
    for (uint32_t y = 3; y < p.height; y += 11)
        for (uint32_t x = 3; x < p.width; x += 17) {
            const double angle = angleBelowHorizon(camera, x, y);
            if (angle < 0.2) continue;
            const double f = reflectance(std::sin(angle));
            // Snell: the ray goes on steeper than it came.
            const double sine = std::cos(angle) / 1.333;
            const double path = -bed / std::sqrt(1 - sine * sine);
            for (size_t channel = 0; channel < 3; ++channel) {
                const double through = std::exp(-double{dimming_.absorption[channel]} * path);
                // In no light the bed shines itself; leaving water thins radiance.
                const double seen = 4 * through / (1.333 * 1.333);
                const double expected = f * static_cast<double>(channel + 1) + (1 - f) * seen;
                EXPECT_NEAR(p.color[(size_t{y} * p.width + x) * 4 + channel], expected, 5e-3 * expected);
            }
        }
}

/// A black wall that stands on the bed and out of the water.
SceneBehind wallBefore(const Camera& camera, const SceneBehind& behind, double bed, double z) {
    return drawnOver(camera, behind, 0, [&](const glm::dvec3& ray) {
        const double distance = (z - camera.eye.z) / ray.z, height = camera.eye.y + distance * ray.y;
        return height < bed || height > 1 ? -1 : distance;
    });
}

// At the lower border the ray bends out of the picture: what lies there is made up, of the bed and nothing
// else.
TEST_F(Refraction, ShowsNothingTwiceWhereTheRayLeavesThePicture) {
    Body* body = waterOf({{0, 0, 0}, {0, 0, 0}, 1});
    Camera camera = seaCamera();
    camera.eye = {0, 2.2, 6};
    camera.target = {0, 1.6, -14};
    const SceneBehind bed = planeBelow(camera, -3, 4);
    const WaterPicture open = picture({body}, camera, 0, SurfaceOutput::shaded, bed);
    for (const double z : {-8.5, -5.0}) {
        const WaterPicture walled =
            picture({body}, camera, 0, SurfaceOutput::shaded, wallBefore(camera, bed, -3, z));
        double most = 0, changed = 0;
        for (size_t i = 0; i < open.color.size(); ++i) {
            const double difference = std::abs(double{walled.color[i]} - double{open.color[i]});
            changed = std::max(changed, difference);
            if (i >= open.color.size() - size_t{5} * camera.width * 4) most = std::max(most, difference);
        }
        EXPECT_GT(changed, 1) << "the wall is seen where it stands";
        EXPECT_LT(most, 1e-3) << z;
    }
}

// A bed that ends 40 m away: sight over flat water passes over its end from 29 m on, the bent ray does not.
TEST_F(Refraction, TheBedIsSeenAsFarAsTheBentRayMeetsIt) {
    Body* body = waterOf(dimming_);
    const Camera camera = seaCamera();
    const double bed = -1.5, end = 40;
    SceneBehind behind = planeBelow(camera, bed, 4);
    const auto distanceAt = [&](uint32_t x, uint32_t y, double height) {
        return (camera.eye.y - height) / std::tan(angleBelowHorizon(camera, x, y));
    };
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x)
            if (const double far = distanceAt(x, y, bed); far < 0 || far > end)
                behind.depth[size_t{y} * camera.width + x] = 0;
    const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, behind);
    uint32_t passedOver = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 3; x < p.width; x += 17) {
            const double angle = angleBelowHorizon(camera, x, y);
            if (angle < 0.01 || angle > 0.25) continue;
            const double sine = std::cos(angle) / 1.333, cosine = std::sqrt(1 - sine * sine);
            const double met = distanceAt(x, y, 0) - bed * sine / cosine;
            if (met > end - 2 && angle > 0.03) continue; // fades out: its end might hide more of it
            passedOver += met < end && distanceAt(x, y, bed) > end;
            const double f = reflectance(std::sin(angle));
            for (size_t channel = 0; channel < 3; ++channel) {
                const double through = std::exp(double{dimming_.absorption[channel]} * bed / cosine);
                const double seen = met < end ? 4 * through / (1.333 * 1.333) : 0;
                const double expected = f * static_cast<double>(channel + 1) + (1 - f) * seen;
                EXPECT_NEAR(p.color[(size_t{y} * p.width + x) * 4 + channel], expected, 5e-3 * expected)
                    << x << ' ' << y;
            }
        }
    EXPECT_GT(passedOver, 50u);
}

/// Shines by itself, and rises by a fifth of the way towards the eye: at z it lies at -1 + z / 5.
struct RisingBed {
    /// How far along `direction` from a point of the world it lies.
    static double met(const glm::dvec3& from, const glm::dvec3& direction) {
        return (0.2 * from.z - 1 - from.y) / (direction.y - 0.2 * direction.z);
    }

    static SceneBehind seenBy(const Camera& camera) {
        SceneBehind sky = planeBelow(camera, -1, 4);
        std::ranges::fill(sky.depth, 0.0f);
        return drawnOver(camera, sky, 4, [&](const glm::dvec3& ray) { return met(camera.eye, ray); });
    }

    /// As flat water at y = 0 shows it, and mirrors the test's sky; at a pixel below the horizon.
    static glm::dvec3 expected(const Camera& camera, const RefractionDesc& water, uint32_t x, uint32_t y) {
        const glm::dvec3 ray = rayThrough(camera, x, y);
        const glm::dvec3 surface = camera.eye - ray * (camera.eye.y / ray.y);
        const glm::dvec3 bent = glm::refract(ray, glm::dvec3(0, 1, 0), 1 / 1.333);
        const double f = reflectance(-ray.y), path = met(surface, bent);
        glm::dvec3 color;
        for (glm::length_t c = 0; c < 3; ++c)
            color[c] =
                f * (c + 1) + (1 - f) * 4 * std::exp(-double{water.absorption[c]} * path) / (1.333 * 1.333);
        return color;
    }
};

// Where the bent ray leaves the picture at its lower border, and where a quay hides what it meets, the bed
// goes on as it rises; the quay does not show through the water.
TEST_F(Refraction, TheBedGoesOnAsItRisesWhereItIsNotSeen) {
    Body* body = waterOf(dimming_);
    Camera camera = seaCamera();
    camera.eye = {0, 3, 2};
    camera.target = {0, 2, -10};
    const SceneBehind open = RisingBed::seenBy(camera);
    const SceneBehind quay = drawnOver(camera, open, 100, [&](const glm::dvec3& ray) {
        const double distance = (0.3 - camera.eye.y) / ray.y;
        return camera.eye.z + distance * ray.z < -6 ? -1 : distance;
    });
    for (const SceneBehind& behind : {open, quay}) {
        const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, behind);
        double most = 0;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 3; x < p.width; x += 17) {
                const size_t i = size_t{y} * p.width + x;
                if (behind.depth[i] != open.depth[i] || angleBelowHorizon(camera, x, y) < 0.22) continue;
                const glm::dvec3 expected = RisingBed::expected(camera, dimming_, x, y);
                for (glm::length_t c = 0; c < 3; ++c)
                    most = std::max(
                        most, std::abs(double{p.color[i * 4 + static_cast<size_t>(c)]} / expected[c] - 1));
            }
        EXPECT_LT(most, 0.03);
    }
}

} // namespace
