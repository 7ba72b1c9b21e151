// Water seen by an eye in it: Snell's window, the light that water takes and gives, and where the near plane
// leaves it.
#include <cmath>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/light/encoded_light.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/near_plane.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double index = waterIndex;
constexpr double pi = std::numbers::pi;

class Underwater : public WaterTest {
  protected:
    Underwater() {
        desc_.refraction = &refraction_;
        desc_.underwater = &underwater_;
    }
    Camera upwards() const {
        Camera camera;
        camera.eye = {3, -4, 7};
        camera.target = {3, 0, 7};
        camera.fovDegrees = 130;
        camera.width = camera.height = 256;
        return camera;
    }
    /// Level, the eye `height` over the calm surface.
    static Camera level(double height) {
        Camera camera;
        camera.eye = {3, height, 7};
        camera.target = {3, height, -10};
        return camera;
    }
    SeaDesc ripples() const {
        SeaDesc sea;
        sea.windSpeed = 4;
        sea.fetch = 2e3f;
        sea.samples = 128;
        sea.cascades = 3;
        return sea;
    }

    RefractionDesc refraction_{{0, 0, 0}, {0, 0, 0}, 1};
    UnderwaterDesc underwater_;
    BodyDesc desc_;
};

class SnellsWindow : public Underwater, public testing::WithParamInterface<Fresnel> {
  protected:
    SnellsWindow() { desc_.shading.fresnel = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Fresnel, SnellsWindow, testing::ValuesIn(formulas), formulaName);

// All light that is beyond the critical angle stays in the water, by either formula.
TEST_P(SnellsWindow, IsAsWideAsTheorySays) {
    const Camera camera = upwards();
    const WaterPicture p = picture({makeBody(desc_)}, camera);
    double widest = 0, narrowest = pi;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const double cosine = rayThrough(camera, x, y).y;
            const double fresnel = reflectanceBelow(cosine, GetParam());
            const float* seen = &p.color[(size_t{y} * p.width + x) * 4];
            // Water that scatters nothing shows nothing outside of the window.
            (seen[0] > 1e-3f ? widest : narrowest) = seen[0] > 1e-3f ? std::max(widest, std::acos(cosine))
                                                                     : std::min(narrowest, std::acos(cosine));
            if (std::abs(std::acos(cosine) - std::asin(1 / index)) < 0.02) continue; // steep there
            for (size_t channel = 0; channel < 3; ++channel) {
                const double sky = static_cast<double>(channel + 1);
                EXPECT_NEAR(seen[channel], index * index * (1 - fresnel) * sky, 3e-3 * sky) << x << ' ' << y;
            }
        }
    const double critical = std::asin(1 / index) * 180 / pi;
    std::printf("window %.2f to %.2f degrees, theory %.2f\n", narrowest * 180 / pi, widest * 180 / pi,
                critical);
    EXPECT_NEAR(widest * 180 / pi, critical, 0.4);
    EXPECT_NEAR(narrowest * 180 / pi, critical, 0.4);
}

// Of slopes too short to be seen, an integral over those that the line of sight can see, each by as much of
// itself as it shows.
TEST_P(SnellsWindow, IsBlurredByTheSlopesThatAreSeen) {
    SeaDesc sea;
    sea.windSpeed = 6;
    sea.samples = 16;
    sea.cascades = 1;
    sea.largestPatch = 4000; // whose waves have hardly any slope
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    Body* const body = makeBody(desc_);
    Camera camera = upwards();
    camera.width = camera.height = 64;
    const WaterPicture slopes = picture({body}, camera, 0, SurfaceOutput::slopes);
    const WaterPicture p = picture({body}, camera, 0);
    double found = 0, expected = 0, worst = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const size_t i = 4 * (size_t{y} * p.width + x);
            const glm::dvec3 sight = rayThrough(camera, x, y);
            const double level = std::hypot(sight.x, sight.z);
            if (level < 0.3 || sight.y < 0.35)
                continue; // straight up no slope matters; lower the sea is mirrored
            const double u = sight.x / level, v = sight.z / level;
            const double deviation =
                std::sqrt(u * u * double{slopes.color[i + 2]} + v * v * double{slopes.color[i + 3]});
            const double mean = u * double{slopes.color[i]} + v * double{slopes.color[i + 1]};
            const double edgeOn = sight.y / level - mean;
            double enters = 0, weights = 0;
            for (double offset = -4 * deviation; offset < std::min(edgeOn, 4 * deviation);
                 offset += 0.02 * deviation) {
                const double slope = mean + offset, cosine = (sight.y - slope * level) / std::hypot(1, slope);
                const double weight = std::exp(-0.5 * std::pow(offset / deviation, 2)) * (edgeOn - offset);
                enters += weight * (1 - reflectanceBelow(std::clamp(cosine, 0.0, 1.0), GetParam()));
                weights += weight;
            }
            found += double{p.color[i]};
            expected += index * index * enters / weights;
            worst = std::max(worst, std::abs(double{p.color[i]} / (index * index) - enters / weights));
        }
    std::printf("%.4f of what is expected, %.3f apart\n", found / expected, worst);
    EXPECT_NEAR(found / expected, 1, 0.01);
    EXPECT_LT(worst, 0.03);
}
TEST_P(SnellsWindow, LetsInAllLightThatEnters) {
    const Camera camera = upwards();
    const WaterPicture p = picture({makeBody(desc_)}, camera);
    const double perPixel = 2 * std::tan(radians(camera.fovDegrees) / 2) / camera.height;
    double irradiance = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const double cosine = rayThrough(camera, x, y).y;
            const double solidAngle = perPixel * perPixel * cosine * cosine * cosine;
            irradiance += double{p.color[(size_t{y} * p.width + x) * 4]} * cosine * solidAngle;
        }
    // Of an even sky of radiance 1 all enters but the diffuse reflectance, 0.066 or 0.067.
    EXPECT_NEAR(irradiance, pi * (1 - 0.066), 0.01 * pi);
}

/// Where the ray of a pixel, bent by a calm surface at y = 0, is `height` metres above that; false where none
/// leaves.
bool bentRayAt(const Camera& camera, uint32_t x, uint32_t y, double height, glm::dvec3& at) {
    const glm::dvec3 ray = rayThrough(camera, x, y);
    const glm::dvec2 aside = index * glm::dvec2(ray.x, ray.z);
    const double rises2 = 1 - glm::dot(aside, aside);
    if (ray.y <= 0 || rises2 <= 0) return false;
    const glm::dvec3 out = camera.eye - ray * (camera.eye.y / ray.y);
    at = out + glm::dvec3(aside.x, std::sqrt(rises2), aside.y) * (height / std::sqrt(rises2));
    return true;
}

// An awning all over the picture: where bent rays meet it beyond the border, they show the sky. It gives way
// to that over six hundredths of the picture's height.
TEST_F(Underwater, WhatStandsAboveFadesTowardsTheBorder) {
    Camera camera = upwards();
    camera.fovDegrees = 90;
    constexpr double height = 3, radiance = 8;
    const SceneBehind awning = drawnOver(camera, nothingBehind(camera), radiance, [&](const glm::dvec3& ray) {
        return (height - camera.eye.y) / ray.y;
    });
    const WaterPicture p = picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, awning);
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    const double side = camera.width;
    size_t whole = 0, fading = 0, gone = 0;
    double worst = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            glm::dvec3 met;
            if (!bentRayAt(camera, x, y, height, met)) continue;
            const glm::dvec4 seen = clip * glm::dvec4(met, 1);
            const glm::dvec2 pixel = (glm::dvec2(seen) / seen.w * 0.5 + 0.5) * side;
            const glm::dvec2 inside = glm::min(pixel, side - pixel);
            const double share = std::clamp(std::min(inside.x, inside.y) / (0.06 * camera.height), 0.0, 1.0);
            const double enters = index * index * (1 - reflectanceBelow(rayThrough(camera, x, y).y));
            const double found = double{p.color[(size_t{y} * p.width + x) * 4]} / enters;
            const double drawn = (found - 1) / (radiance - 1); // the sky's is 1
            worst = std::max(worst, std::abs(drawn - share));
            ++(share == 0 ? gone : share == 1 ? whole : fading);
        }
    std::printf("%zu pixels show the awning, %zu fade, %zu show the sky; off by %.3f at most\n", whole,
                fading, gone, worst);
    EXPECT_GT(whole, 1000u);
    EXPECT_GT(fading, 1000u);
    EXPECT_LT(worst, 0.3);
}

// Of an awning close over the water what the surface does not mirror back up, by where that is much.
TEST_F(Underwater, WhatStandsAboveShinesInByWhatIsNotMirrored) {
    Camera camera = upwards();
    camera.fovDegrees = 120;
    camera.width = camera.height = 128;
    constexpr double height = 0.4, radiance = 8;
    const SceneBehind awning = drawnOver(camera, nothingBehind(camera), radiance, [&](const glm::dvec3& ray) {
        return (height - camera.eye.y) / ray.y;
    });
    const WaterPicture p = picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, awning);
    double found = 0, expected = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            glm::dvec3 met;
            const double mirrored = reflectanceBelow(rayThrough(camera, x, y).y);
            if (mirrored < 0.1 || mirrored > 0.4 || !bentRayAt(camera, x, y, height, met)) continue;
            found += double{p.color[(size_t{y} * p.width + x) * 4]};
            expected += index * index * (1 - mirrored) * radiance;
        }
    std::printf("%.3f of what is expected\n", found / expected);
    EXPECT_GT(expected, 1000);
    EXPECT_NEAR(found / expected, 1, 0.05);
}

// As the bed's own pixels do, by as much water as lies over it and before it.
TEST_F(Underwater, TheSurfaceMirrorsABedAsDarkAsItLiesDeep) {
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    refraction_ = {{0.1f, 0.1f, 0.1f}, {0, 0, 0}, 1};
    for (float& channel : lighting.skyIrradiance) channel = 2;
    Camera camera = level(-1.5);
    camera.target = camera.eye + glm::dvec3(0, 0.2, -1);
    camera.width = camera.height = 96;
    constexpr double radiance = 4, bed = -4, a = 0.1;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const WaterPicture p =
        picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, bed, radiance));
    const double again = (1 - 0.934 / (index * index)) * std::exp(6 * a * bed);
    const double lit = radiance * 0.934 * std::exp(1.2 * a * bed) / (1 - again);
    double found = 0, expected = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            if (ray.y < 0.15 || std::acos(ray.y) < std::asin(1 / index) + 0.02) continue;
            const double path = (-camera.eye.y - bed) / ray.y - camera.near / glm::dot(ray, forward);
            found += double{p.color[(size_t{y} * p.width + x) * 4]};
            expected += lit * std::exp(-a * path);
        }
    std::printf("%.3f of what is expected\n", found / expected);
    EXPECT_GT(expected, 100);
    EXPECT_NEAR(found / expected, 1, 0.05);
}

// Foam that sends all light back lets none through to an eye below it.
TEST_F(Underwater, WhiteFoamIsDarkFromBelow) {
    SeaDesc sea = ripples();
    sea.windSpeed = 20;
    sea.fetch = 300e3f;
    const FoamDesc white{.bias = 0.06f, .albedo = 1};
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    for (float& channel : lighting.skyIrradiance) channel = 3;
    const auto mean = [&](const FoamDesc* foam) {
        desc_.foam = foam;
        Camera camera = upwards();
        camera.eye.y = -15;
        camera.fovDegrees = 60;
        camera.width = camera.height = 64;
        const WaterPicture p = picture({makeBody(desc_)}, camera, 20);
        double sum = 0;
        for (size_t i = 0; i < p.color.size(); i += 4) sum += double{p.color[i]};
        return sum;
    };
    const double share = mean(&white) / mean(nullptr);
    std::printf("%.3f of the light without it\n", share);
    EXPECT_LT(share, 0.91);
}

// Parallel lines begin at their near plane, each as deep as that is there: in the dark below, and in the
// light above.
TEST_F(Underwater, ParallelLinesSeeTheWaterOfTheirOwnDepth) {
    refraction_ = {{0.1f, 0.1f, 0.1f}, {0.01f, 0.01f, 0.01f}, 1};
    for (float& channel : lighting.skyIrradiance) channel = 300;
    Body* const body = makeBody(desc_);
    Camera camera = level(-5);
    camera.width = camera.height = 33;
    camera.parallelHeight = 8;
    camera.far = 1000;
    const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::shaded, nothingBehind(camera));
    const double top = double{p.color[4 * 16]}, bottom = double{p.color[4 * (32 * 33 + 16)]},
                 apart = 8.0 * 32 / 33;
    std::printf("above %.4f, below %.4f: %.3f a metre\n", top, bottom, std::log(top / bottom) / apart);
    EXPECT_NEAR(std::log(top / bottom) / apart, 0.11, 0.005);
}

// A beam low over the water, which hides from the eye what its bent rays pass far above.
TEST_F(Underwater, WhatHidesTheWayOfABentRayIsNotWhatItMeets) {
    const Camera camera = upwards();
    constexpr double height = 0.3, radiance = 8, near = 2, far = 3.5; // [m] aside of the eye
    const SceneBehind beam = drawnOver(camera, nothingBehind(camera), radiance, [&](const glm::dvec3& ray) {
        const double distance = (height - camera.eye.y) / ray.y, aside = distance * ray.x;
        return aside > near && aside < far ? distance : 0;
    });
    const WaterPicture p = picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, beam);
    size_t meet = 0, missed = 0, pass = 0, shown = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            glm::dvec3 met;
            if (!bentRayAt(camera, x, y, height, met)) continue;
            const double aside = met.x - camera.eye.x,
                         slack = 0.15; // a twentieth of the way, and a tenth of a metre
            const double enters = index * index * (1 - reflectanceBelow(rayThrough(camera, x, y).y));
            const bool sky = double{p.color[(size_t{y} * p.width + x) * 4]} < 1.5 * enters;
            if (aside > near + 0.1 && aside < far - 0.1 && met.z > camera.eye.z - 2 &&
                met.z < camera.eye.z + 2) {
                ++meet;
                missed += sky;
            }
            if (aside < near - slack || aside > far + slack) {
                ++pass;
                shown += !sky;
            }
        }
    std::printf("%zu of %zu rays that meet it show the sky, %zu of %zu that pass by show it\n", missed, meet,
                shown, pass);
    EXPECT_GT(meet, 500u);
    EXPECT_EQ(shown, 0u);
}

/// What `path` metres from `depth` on scatter into a ray, by Simpson's rule over its sources.
double scatteredIn(double absorption, double backscatter, double down, double depth, double rise,
                   double path) {
    const double k = absorption + backscatter;
    const double deep = down / pi * 0.33 * backscatter / k;
    const int steps = 2000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double s = path * i / steps;
        const double weight = i == 0 || i == steps ? 1 : i % 2 ? 4 : 2;
        sum += weight * 2 * k * deep * std::exp(-k * (depth - rise * s)) * std::exp(-k * s);
    }
    return sum * path / steps / 3;
}

TEST_F(Underwater, WhatIsSeenThroughWaterKeepsBeersAndLambertsLaw) {
    refraction_ = {{0.4f, 0.15f, 0.05f}, {0.01f, 0.02f, 0.03f}, 1};
    lighting.toSun[0] = 0.6;
    lighting.toSun[1] = 0.8;
    lighting.toSun[2] = 0;
    for (float& channel : lighting.sunIrradiance) channel = 5;
    for (float& channel : lighting.skyIrradiance) channel = 2;
    Camera camera = level(-1.5);
    camera.target = {3, -4, -3};
    constexpr float radiance = 4;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    Body* const body = makeBody(desc_);
    const double sine = 0.6 / index, inside = std::sqrt(1 - sine * sine);
    const double s = (0.8 - index * inside) / (0.8 + index * inside);
    const double t = (index * 0.8 - inside) / (index * 0.8 + inside);
    const double sun = 5 * 0.8 * (1 - (s * s + t * t) / 2), sky = 2 * 0.934, down = sun + sky;
    size_t checked = 0;
    // In the shallow the surface turns back half as much as the bed sends up.
    for (const double bed : {-6.0, -2.0}) {
        const WaterPicture p =
            picture({body}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, bed, radiance));
        for (uint32_t y = 5; y < p.height; y += 9)
            for (uint32_t x = 3; x < p.width; x += 17) {
                const glm::dvec3 ray = rayThrough(camera, x, y);
                if (ray.y > -0.05) continue;
                const double nearPlane = camera.near / glm::dot(ray, forward);
                const double path = (bed - camera.eye.y) / ray.y - nearPlane;
                for (size_t channel = 0; channel < 3; ++channel) {
                    const double a = double{refraction_.absorption[channel]},
                                 b = double{refraction_.backscatter[channel]};
                    // In 5 * 0.8 + 2 of light a white bed sends back no more; in water it has what comes down
                    // to it, and what the surface turns back of its own.
                    const double depth = -(a + b) * -bed;
                    const double arriving = sun * std::exp(depth / inside) + sky * std::exp(1.2 * depth);
                    const double again = (1 - 0.934 / (index * index)) * std::exp(6 * depth);
                    const double lit = radiance * arriving / (5 * 0.8 + 2) / (1 - again);
                    const double expected =
                        lit * std::exp(-(a + b) * path) + scatteredIn(a, b, down, -camera.eye.y, ray.y, path);
                    EXPECT_NEAR(p.color[(size_t{y} * p.width + x) * 4 + channel], expected, 2e-3 * expected);
                    ++checked;
                }
            }
    }
    EXPECT_GT(checked, 100u);
}

// The eye looks up a little: what the surface above it mirrors lies below the picture.
TEST_F(Underwater, TheSurfaceMirrorsABedBeyondThePicture) {
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    for (float& channel : lighting.skyIrradiance) channel = 0; // of no light, the bed's is its own
    Camera camera = level(-1.5);
    camera.target = camera.eye + glm::dvec3(0, 0.2, -1);
    constexpr float radiance = 4;
    const WaterPicture p =
        picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, planeBelow(camera, -4, radiance));
    const double critical = std::asin(1 / index);
    size_t mirrors = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const double cosine = rayThrough(camera, x, y).y; // to the surface's normal
            if (cosine < 0.05 || std::acos(cosine) < critical + 0.02) continue;
            ++mirrors;
            EXPECT_NEAR(p.color[(size_t{y} * p.width + x) * 4], radiance, 0.02 * radiance) << x << ' ' << y;
        }
    EXPECT_GT(mirrors, 20000u);
}

// Where the picture's lower border shows a bed on the left alone, what is mirrored of the bed beyond it ends
// by steps, not at an edge that stands in the picture.
TEST_F(Underwater, ABedBeyondThePictureEndsSoftly) {
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    for (float& channel : lighting.skyIrradiance) channel = 0;
    Camera camera = level(-1.5);
    camera.target = camera.eye + glm::dvec3(0, 0.2, -1);
    constexpr float radiance = 4;
    SceneBehind behind = planeBelow(camera, -4, radiance);
    for (size_t i = 0; i < behind.depth.size(); ++i)
        if (i % camera.width >= camera.width / 2) behind.depth[i] = 0; // nothing
    const WaterPicture p = picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, behind);
    const auto at = [&](uint32_t x, uint32_t y) { return p.color[(size_t{y} * p.width + x) * 4]; };
    const double critical = std::asin(1 / index);
    const double lowest = -rayThrough(camera, p.width / 2, p.height - 1).y;
    size_t rows = 0;
    for (uint32_t y = 0; y < p.height / 2; ++y) {
        const double rises = rayThrough(camera, p.width / 2, y).y;
        // The bed's point that is mirrored there, 2.5 m below the eye and as far as 1.5 m up and 4 m down
        // take the ray.
        const double falls = std::sin(std::atan(2.5 / 5.5 * std::tan(std::asin(rises))));
        if (std::acos(rises) < critical + 0.02 || falls < lowest + 0.02) continue;
        ++rows;
        float steepest = 0;
        for (uint32_t x = 1; x < p.width; ++x)
            steepest = std::max(steepest, std::abs(at(x, y) - at(x - 1, y)));
        EXPECT_LT(steepest, 0.3f * radiance) << y;
        EXPECT_GT(at(0, y), 0.99f * radiance) << y;
        EXPECT_LT(at(p.width - 1, y), 0.5f * radiance) << y;
    }
    EXPECT_GT(rows, 5u);
}

// No ray that is nearly level gets out: bright pixels there are far sides of waves, which shone through folds
// of near ones.
TEST_F(Underwater, NoFarSideOfAWaveShinesThroughItsNearSide) {
    const SeaDesc sea = ripples();
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    Body* body = makeBody(desc_);
    size_t checked = 0, bright = 0;
    for (int moment = 0; moment < 6; ++moment) {
        const Camera camera = level(-0.15);
        const WaterPicture p = picture({body}, camera, moment);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t pixel = size_t{y} * p.width + x;
                const double rises = rayThrough(camera, x, y).y;
                if (!p.covered(pixel) || rises < 0 || rises > 0.1) continue;
                ++checked;
                bright += p.color[pixel * 4] > 0.4f; // of the sky's 1
            }
    }
    std::printf("%zu of %zu\n", bright, checked);
    EXPECT_GT(checked, 20000u);
    EXPECT_EQ(bright, 0u);
}

TEST_F(Underwater, TheWaterlineIsWhereTheNearPlaneLeavesTheSurface) {
    SeaDesc sea = ripples();
    sea.choppiness = 2; // so that it matters how far aside waves move what stands there
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    underwater_.meniscus = 0;
    Body* body = makeBody(desc_);
    for (const double roll : {0.0, 35.0, 180.0}) {
        // Looking up, so that no ray from above meets the water.
        Camera camera = level(-0.25);
        camera.target = {3, 12, -10};
        camera.near = 0.4;
        camera.fovDegrees = 36;
        camera.rollDegrees = roll;
        constexpr double unsure = 0.004; // what the maps' interpolation leaves open
        const NearPlaneCount count =
            countNearPlane(picture({body}, camera, 3), camera, *seaglass::sea(body), 3, unsure);
        EXPECT_GT(count.wet, 200u);
        EXPECT_GT(count.dry, 200u);
        EXPECT_EQ(count.wrong, 0u) << "of " << count.wet + count.dry << ", roll " << roll;
    }
}

class Waterline : public Underwater {
  protected:
    /// So steeply up that Snell's window is before the lens.
    WaterPicture drawn(float meniscus) {
        Camera camera = level(-0.37);
        camera.target = {3, 40, -10};
        camera.near = 0.4;
        camera.fovDegrees = 36;
        underwater_.meniscus = meniscus;
        const SceneBehind wall =
            drawnOver(camera, nothingBehind(camera), 3, [](const glm::dvec3&) { return 5.0; });
        return picture({makeBody(desc_)}, camera, 0, SurfaceOutput::shaded, wall);
    }
};

TEST_F(Waterline, IsAsWideAboveTheSurfaceAsBelow) {
    const WaterPicture without = drawn(0), with = drawn(0.04f);
    size_t wet = 0, dry = 0;
    for (size_t i = 0; i < with.depth.size(); ++i)
        if (with.color[i * 4] != without.color[i * 4]) ++(without.covered(i) ? wet : dry);
    std::printf("%zu pixels of the line below the surface, %zu above\n", wet, dry);
    EXPECT_GT(wet, 500u);
    EXPECT_GT(dry, 500u);
    EXPECT_NEAR(static_cast<double>(wet), static_cast<double>(dry), 0.1 * static_cast<double>(wet));
}

// Blended as displays take colour, it takes nearly as much from what shows through it.
TEST_F(Waterline, DimsEncodedColorAsMuch) {
    const auto taken = [&](Encoding encoding) {
        useEncoding(encoding);
        const WaterPicture without = drawn(0);
        return lightAdded(without, drawn(0.04f), encoding);
    };
    const double linear = taken(Encoding::linear), held = taken(Encoding::srgb);
    std::printf("in encoded colour the line takes %.3f of the light that it does in linear\n", held / linear);
    EXPECT_NEAR(held / linear, 1, 0.05);
}

TEST_F(Underwater, CostsNothingWhereItIsNotAskedForOrNotSeen) {
    const SeaDesc sea = ripples();
    desc_.waves = &sea;
    desc_.wavesBackend = fftwWaves();
    Body* asked = makeBody(desc_);
    desc_.underwater = nullptr;
    Body* unasked = makeBody(desc_);
    // Beside the surface, which is listed in three steps, and placed.
    const auto draws = [&](Body* body, double height) {
        spiedCalls().clear();
        picture({body}, level(height));
        EXPECT_EQ(countSpied("CreateImage"), 0u);
        EXPECT_EQ(countSpied("CmdDispatch"), wavesMips() + 3);
        return countSpied("CmdDraw") - 1;
    };
    for (const double height : {5.0, 0.0, -5.0}) picture({asked}, level(height)); // what contexts make once
    picture({unasked}, level(5));
    EXPECT_EQ(draws(asked, 5), 0u);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
    EXPECT_EQ(draws(asked, 0), 2u) << "water, and waterline";
    EXPECT_EQ(draws(asked, -5), 1u);
    for (const double height : {5.0, 0.0, -5.0}) {
        EXPECT_EQ(draws(unasked, height), 0u);
        EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u) << "the surface's own serves, " << height;
    }
    underwater_.meniscus = 0;
    desc_.underwater = &underwater_;
    Body* const dry = makeBody(desc_);
    picture({dry}, level(0)); // its images for the view
    EXPECT_EQ(draws(dry, 0), 1u);

    desc_.underwater = nullptr;
    Estimate without, with;
    ASSERT_EQ(estimate(context(), &desc_, {320, 180}, &without), Status::ok);
    desc_.underwater = &underwater_;
    ASSERT_EQ(estimate(context(), &desc_, {320, 180}, &with), Status::ok);
    EXPECT_EQ(with.bytes, without.bytes);
}

TEST_F(Underwater, BadFieldsAreNamed) {
    const auto expectRefused = [&](const char* field) {
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument) << field;
        EXPECT_NE(message().find(field), std::string::npos) << message();
    };
    for (const float width : {-0.001f, 0.2f, NAN}) {
        underwater_.meniscus = width;
        expectRefused("UnderwaterDesc.meniscus");
    }
    underwater_.meniscus = 0;
    desc_.refraction = nullptr;
    expectRefused("BodyDesc.underwater needs BodyDesc.refraction");
}

} // namespace
