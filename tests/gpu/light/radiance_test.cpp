// Water keeps light's accounts: it adds none, and waves send as much as the roughness that stands for them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/sea_rig.h"
#include "water/interface/sea_contents.h"

namespace {

using namespace seaglass;
using namespace tests;

class Radiance : public SeaTest {};

/// Everything below the horizon is a plane at height `bed`, all above a wall as far as can be; of one colour,
/// the sky cube's times `radiance`.
SceneBehind evenWorld(const Camera& camera, double bed, float radiance) {
    SceneBehind behind = planeBelow(camera, bed, 1);
    const auto wall = static_cast<float>(camera.near / 1e6);
    for (float& depth : behind.depth) depth = std::max(depth, wall);
    for (size_t i = 0; i < behind.color.size(); ++i)
        behind.color[i] = radiance * static_cast<float>(i % 4 + 1);
    return behind;
}

class WaterByFormula : public Radiance, public testing::WithParamInterface<Fresnel> {};
INSTANTIATE_TEST_SUITE_P(Fresnel, WaterByFormula, testing::ValuesIn(formulas), formulaName);

// Water that absorbs nothing, over a bed as bright as the sky, cannot be told from the sky: what is not
// mirrored shines through, at any angle, smooth or rough. Over a black bed it is darker, never brighter.
TEST_P(WaterByFormula, IsUnseenInAWhiteFurnace) {
    RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
    const ReflectionDesc reflection;
    lighting.skyIrradiance[0] = static_cast<float>(std::numbers::pi);
    lighting.skyIrradiance[1] = 2 * lighting.skyIrradiance[0];
    lighting.skyIrradiance[2] = 3 * lighting.skyIrradiance[0];
    SeaDesc gale = breeze();
    gale.windSpeed = 17;
    const SeaDesc calm = breeze();
    const SeaDesc* const seas[] = {nullptr, &calm, &gale};
    for (const SeaDesc* sea : seas)
        for (const ReflectionDesc* mirror : {static_cast<const ReflectionDesc*>(nullptr), &reflection}) {
            BodyDesc desc;
            desc.waves = sea;
            desc.wavesBackend = fftwWaves();
            clear.scattering = mirror ? 0.0f : 0.5f;
            desc.refraction = &clear;
            desc.reflection = mirror;
            desc.shading.fresnel = GetParam();
            Body* body = makeBody(desc);
            for (const double down : {0.3, 8.0, 300.0}) { // over 10 m: nearly level, and steep
                Camera camera = seaCamera();
                camera.eye = {3, 9, 7};
                camera.target = camera.eye + glm::dvec3(0, -down, -10);
                camera.width = 160;
                camera.height = 90;
                const auto drawn = [&](float bed) {
                    return picture({body}, camera, 5, SurfaceOutput::shaded, evenWorld(camera, -40, bed));
                };
                const WaterPicture white = drawn(1), black = drawn(0);
                double least = 2, most = 0, mirrored = 0;
                size_t seen = 0;
                for (size_t i = 0; i < white.color.size(); ++i) {
                    if (i % 4 == 3 || !white.covered(i / 4)) continue;
                    const double share = double{white.color[i]} / static_cast<double>(i % 4 + 1);
                    least = std::min(least, share);
                    most = std::max(most, share);
                    mirrored = std::max(mirrored, double{black.color[i]} / static_cast<double>(i % 4 + 1));
                    ++seen;
                }
                EXPECT_GT(seen, 3 * 4000u);
                EXPECT_GT(least, 0.99) << down;
                EXPECT_LT(most, 1.01) << down;
                EXPECT_LT(mirrored, 1.001) << down;
            }
        }
}

// What distance takes from the normals goes into the roughness: seen from above, over pixels of centimetres
// or of hectometres, all slopes together are Cox and Munk's.
TEST_F(Radiance, SlopeVarianceIsTheSameAtAnyDistance) {
    SeaDesc desc = breeze();
    desc.windSpeed = 10;
    desc.fetch = 300e3f;
    desc.samples = 128;
    Body* body = wavyBody(desc);
    const double expected = coxMunkSlopeVariance(10);
    double resolvedNear = 0;
    for (const double height : {10.0, 100.0, 1e3, 1e4, 1e5}) {
        double slopes = 0, within = 0;
        size_t count = 0;
        // Near by, many places make the mean.
        const int places = height < 500 ? 24 : 4;
        for (int place = 0; place < places; ++place) {
            Camera camera = seaCamera();
            camera.width = camera.height = 64;
            camera.eye = {place * 137.0, height, place * 71.0};
            camera.target = {place * 137.0 + 0.001 * height, 0, place * 71.0};
            const WaterPicture p = picture({body}, camera, 50 + place * 7, SurfaceOutput::slopes);
            for (size_t i = 0; i < p.color.size(); i += 4) {
                if (!p.covered(i / 4)) continue;
                slopes +=
                    double{p.color[i]} * double{p.color[i]} + double{p.color[i + 1]} * double{p.color[i + 1]};
                within += double{p.color[i + 2]} + double{p.color[i + 3]};
                ++count;
            }
        }
        ASSERT_GT(count, 1000u);
        slopes /= static_cast<double>(count);
        within /= static_cast<double>(count);
        std::printf("from %6.0f m: in normals %.4f, in roughness %.4f, together %.4f of %.4f\n", height,
                    slopes, within, slopes + within, expected);
        EXPECT_NEAR((slopes + within) / expected, 1, 0.1) << height;
        if (resolvedNear == 0) resolvedNear = slopes;
        if (height == 1e5) {
            EXPECT_LT(slopes, 0.1 * resolvedNear);
        }
    }
    EXPECT_GT(resolvedNear, 0.2 * expected);
}

// Waves that are looked for hide a low sun from troughs, and from crests hardly.
TEST_F(Radiance, CrestsAreInTheSunLongerThanTroughs) {
    SeaDesc sea = breeze();
    sea.windSpeed = 10;
    sea.fetch = 300e3f;
    sea.samples = 128;
    const auto crestsToTroughs = [&](uint32_t steps) {
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.shading.waveShadowSteps = steps;
        Body* const body = makeBody(desc);
        Camera camera = seaCamera();
        camera.eye = {0, 25, 0};
        camera.target = {40, 0, 0};
        camera.width = camera.height = 96;
        double light[2] = {}, pixels[2] = {};
        for (const double time : {50.0, 61.0}) {
            shineFrom({0, 1, 0}, 0);
            const WaterPicture dark = picture({body}, camera, time);
            shineFrom({std::cos(0.03), std::sin(0.03), 0}, 50);
            const WaterPicture lit = picture({body}, camera, time);
            const WaterPicture height = picture({body}, camera, time, SurfaceOutput::height);
            const double deviation = significantWaveHeight(*seaglass::sea(body)) / 4;
            for (size_t i = 0; i < lit.color.size(); i += 4) {
                const double h = double{height.color[i]} / deviation;
                if (!lit.covered(i / 4) || std::abs(h) < 0.7) continue;
                light[h > 0] += double{lit.color[i]} - double{dark.color[i]};
                ++pixels[h > 0];
            }
        }
        return light[1] / pixels[1] * pixels[0] / light[0];
    };
    const double searched = crestsToTroughs(16), unsearched = crestsToTroughs(0);
    std::printf("crests to troughs %.3f, and %.3f where no waves are looked for\n", searched, unsearched);
    EXPECT_GT(searched, 1.5 * unsearched);
}

// A sea seen from 1 km has the same radiance whether pixels show its waves, and the mean is taken of them, or
// one pixel's roughness stands for all: whether waves that hide others are looked for or not.
class WaterFromAfar : public Radiance, public testing::WithParamInterface<Quality> {};

INSTANTIATE_TEST_SUITE_P(AtEach, WaterFromAfar, testing::Values(Quality::medium, Quality::highest));

TEST_P(WaterFromAfar, RadianceIsTheSameOfWavesAndOfTheirRoughness) {
    SeaDesc sea = breeze();
    sea.windSpeed = 10;
    sea.fetch = 300e3f;
    sea.samples = 128;
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    setQuality(GetParam(), &desc, nullptr);
    Body* body = makeBody(desc);
    struct Look {
        double distance, fov;
        uint32_t size;
        int places;
    };
    // Near by the mesh is as fine as the slopes, so that what turns away is seen as little of as it should
    // be.
    constexpr Look close{80, 6, 48, 120}, far{1000, 6, 2, 16};
    const auto meanOf = [&](double elevation, const Look& look) {
        double sum = 0;
        size_t count = 0;
        for (int place = 0; place < look.places; ++place) {
            Camera camera = seaCamera();
            camera.fovDegrees = look.fov;
            camera.width = camera.height = look.size;
            camera.target = {std::fmod(place * 331.7, 1500), 0, std::fmod(place * 173.3, 1400)};
            const double up = radians(elevation);
            camera.eye = camera.target + look.distance * glm::dvec3(std::cos(up), std::sin(up), 0);
            const WaterPicture p = picture({body}, camera, 50 + place % 4 * 7);
            for (size_t i = 0; i < p.color.size(); i += 4) {
                if (!p.covered(i / 4)) continue;
                sum += double{p.color[i]};
                ++count;
            }
        }
        return sum / static_cast<double>(count);
    };
    for (const bool sun : {false, true})
        for (const double elevation : {70.0, 40.0, 20.0, 12.0}) {
            const double up = radians(elevation);
            if (sun) shineFrom({-std::cos(up), std::sin(up), 0}, 10);
            const double waves = meanOf(elevation, close), roughness = meanOf(elevation, far);
            std::printf("%s, %2.0f degrees up: waves %.4f, roughness %.4f: %+.1f %%\n", sun ? "sun" : "sky",
                        elevation, waves, roughness, 100 * (roughness / waves - 1));
            EXPECT_NEAR(roughness / waves, 1, 0.05);
        }
}

} // namespace
