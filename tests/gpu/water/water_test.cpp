// Water as it is drawn: that it covers the sea, stands where the height queries say, and keeps light's
// accounts.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/traced_scene.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/unit/sea/statistics.h"
#include "water/body/body.h"
#include "water/foam/foam_part.h"
#include "water/reflection/reflection_part.h"
#include "water/waves/waves_part.h"

namespace {

using namespace seaglass;
using namespace tests;

Camera seaCamera() {
    Camera camera;
    camera.eye = {3, 4, 7};
    camera.target = {3, 3, -10};
    camera.width = 320;
    camera.height = 180;
    return camera;
}

/// How far a ray, unit, goes from a point until it meets something; less than nothing: it does not.
using Along = std::function<double(const glm::dvec3& from, const glm::dvec3& ray)>;

/// What a pixel of water mirrors by its drawn normal, and by a level one.
struct BentLook {
    double bent, flat; ///< how far away what is mirrored lies
    glm::dvec3 met;    ///< where, of the bent one
    bool says;         ///< whether the surface takes its reflection from something
    glm::dvec2 source; ///< then from which pixel
};

/// Before the boxes of a harbour.
Camera boxCamera() {
    Camera camera = seaCamera();
    camera.eye = {-1, 2.2, 9};
    camera.target = {-0.5, 1.2, 0};
    return camera;
}

class Water : public WaterTest {
  protected:
    Body* wavyBody(const SeaDesc& sea) {
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        return makeBody(desc);
    }
    Body* flatBody() { return makeBody({}); }
    /// As described, with a breeze's waves that mirror the scene.
    Body* mirroringBreeze(BodyDesc desc, const ReflectionDesc& reflection = {}) {
        const SeaDesc sea = breeze();
        desc.waves = &sea;
        desc.reflection = &reflection;
        return makeBody(desc);
    }
    /// Of a scene of that which `along` meets.
    std::vector<BentLook> bentSamples(Body* body, const Camera& camera, const Along& along);
    /// How bright a lit band 60 m away makes each of 90 rows of the water before it, in pictures of `scale`
    /// times as many: seen from 3 m above the water, or as far below it.
    std::vector<double> columnOfBand(double above, uint32_t looks, uint32_t scale);
    void expectColumn(double above, const std::map<uint32_t, double>& offByLooks);
};

TEST_F(Water, FlatWaterCoversAllBelowTheHorizon) {
    Body* body = flatBody();
    for (const double height : {0.01, 2.0, 5000.0})
        for (const double roll : {0.0, 50.0, 180.0}) {
            Camera camera = seaCamera();
            camera.eye.y = height;
            camera.target.y = height - 1;
            camera.rollDegrees = roll;
            camera.near = 1e-3;
            const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::height);
            size_t holes = 0, above = 0;
            for (uint32_t y = 0; y < p.height; ++y)
                for (uint32_t x = 0; x < p.width; ++x) {
                    const double angle = angleBelowHorizon(camera, x, y);
                    const bool covered = p.covered(size_t{y} * p.width + x);
                    holes += angle > 0.003 && !covered;
                    above += angle < 0 && covered;
                }
            EXPECT_EQ(holes, 0u) << "eye at " << height << " m, roll " << roll;
            EXPECT_LE(static_cast<double>(above), limitOnGrid(0, 6)) // where the horizon passes their centres
                << "eye at " << height << " m, roll " << roll;
        }
}

// The mesh ends with square patches, at 100 km: seen through a lens of half a degree.
TEST_F(Water, TheHorizonIsStraight) {
    Body* body = flatBody();
    for (const double yaw : {0.0, 0.5, 1.2, 2.9, 4.4}) {
        Camera camera = seaCamera();
        camera.eye.y = 15;
        camera.target = camera.eye + glm::dvec3(std::sin(yaw), 0, -std::cos(yaw));
        camera.fovDegrees = 0.5;
        const WaterPicture p = picture({body}, camera, 0, SurfaceOutput::height);
        uint32_t first = p.height, last = 0;
        for (uint32_t x = 0; x < p.width; ++x) {
            uint32_t y = 0;
            while (y < p.height && !p.covered(size_t{y} * p.width + x)) ++y;
            first = std::min(first, y);
            last = std::max(last, y);
        }
        EXPECT_LE(last - first, 1u) << yaw;
        EXPECT_NEAR(first, 0.5 * p.height, 1) << yaw;
    }
}

TEST_F(Water, WavesLeaveNoHoles) {
    Body* body = wavyBody(breeze());
    for (const double height : {1.5, 6.0, 60.0, 700.0}) {
        Camera camera = seaCamera();
        camera.eye.y = height;
        camera.target.y = height * 0.6;
        camera.rollDegrees = 20;
        const WaterPicture p = picture({body}, camera, 5, SurfaceOutput::height);
        size_t holes = 0;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x)
                holes += angleBelowHorizon(camera, x, y) > 0.02 && !p.covered(size_t{y} * p.width + x);
        EXPECT_EQ(holes, 0u) << "eye at " << height << " m";
    }
}

TEST_F(Water, TheSurfaceStandsWhereHeightQueriesSay) {
    SeaDesc desc = breeze();
    desc.samples = 256;
    Body* body = wavyBody(desc);
    const Camera camera = seaCamera();
    const double time = 123.4;
    const WaterPicture p = picture({body}, camera, time, SurfaceOutput::height);
    std::vector<double> points;
    std::vector<double> drawn;
    for (uint32_t y = 0; y < p.height; y += 7)
        for (uint32_t x = 0; x < p.width; x += 13) {
            if (!p.covered(size_t{y} * p.width + x)) continue;
            const glm::dvec3 world = worldAt(camera, p, x, y);
            if (glm::length(world - camera.eye) > 25) continue; // finest cells
            points.insert(points.end(), {world.x, world.z});
            drawn.push_back(world.y);
        }
    ASSERT_GT(drawn.size(), 100u);
    std::vector<HeightSample> samples(drawn.size());
    sampleHeights(*sea(body), time, points.data(), samples.size(), samples.data());
    double worst = 0, scale = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
        worst = std::max(worst, std::abs(drawn[i] - double{samples[i].height}));
        scale = std::max(scale, std::abs(drawn[i]));
    }
    std::printf("worst difference %.4f m, highest wave %.2f m\n", worst, scale);
    // What is left is the maps' linear interpolation, 16 texels to the peak's wave and 4 to the shortest.
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(scale, 0.3);
}

TEST_F(Water, MapsHoldWhatTheBackendEvaluated) {
    const SeaDesc desc = breeze();
    Body* body = wavyBody(desc);
    const double time = 42;
    picture({body}, seaCamera(), time);
    const Sea& s = *sea(body);
    const size_t floats = size_t{desc.samples} * desc.samples * 4;
    void* state = fftwWaves()->create(s);
    for (uint32_t c = 0; c < cascadeCount(s); ++c) {
        std::vector<float> maps[3] = {std::vector<float>(floats), std::vector<float>(floats),
                                      std::vector<float>(floats)};
        fftwWaves()->evaluate(state, c, time, {maps[0].data(), maps[1].data(), maps[2].data()});
        for (uint32_t m = 0; m < 3; ++m) {
            const VkImage image = body->find<WavesPart>()->waves.maps().images[m].handle();
            const VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
            EXPECT_EQ(download(image, format, {desc.samples, desc.samples}, 0, c), maps[m]);
            const uint32_t half = desc.samples / 2;
            const std::vector<float> mip = download(image, format, {half, half}, 1, c);
            const auto at = [&](uint32_t x, uint32_t y) {
                return maps[m][(size_t{y} * desc.samples + x) * 4 + 1];
            };
            for (uint32_t i = 0; i < half; i += 5) {
                const float mean = (at(2 * i, 6) + at(2 * i + 1, 6) + at(2 * i, 7) + at(2 * i + 1, 7)) / 4;
                EXPECT_NEAR(mip[(size_t{3} * half + i) * 4 + 1], mean, 1e-5f);
            }
        }
    }
    fftwWaves()->destroy(state);
}

TEST_F(Water, WhatLiesBelowIsDimmedByBeerAndLambert) {
    const RefractionDesc refraction = {{0.5f, 0.2f, 0.1f}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &refraction;
    Body* body = makeBody(desc);
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
                const double through = std::exp(-double{refraction.absorption[channel]} * path);
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
TEST_F(Water, ShowsNothingTwiceWhereTheRayLeavesThePicture) {
    const RefractionDesc refraction = {{0, 0, 0}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &refraction;
    Body* body = makeBody(desc);
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
TEST_F(Water, TheBedIsSeenAsFarAsTheBentRayMeetsIt) {
    const RefractionDesc refraction = {{0.5f, 0.2f, 0.1f}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &refraction;
    Body* body = makeBody(desc);
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
                const double through = std::exp(double{refraction.absorption[channel]} * bed / cosine);
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
TEST_F(Water, TheBedGoesOnAsItRisesWhereItIsNotSeen) {
    const RefractionDesc refraction = {{0.5f, 0.2f, 0.1f}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &refraction;
    Body* body = makeBody(desc);
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
                const glm::dvec3 expected = RisingBed::expected(camera, refraction, x, y);
                for (glm::length_t c = 0; c < 3; ++c)
                    most = std::max(
                        most, std::abs(double{p.color[i * 4 + static_cast<size_t>(c)]} / expected[c] - 1));
            }
        EXPECT_LT(most, 0.03);
    }
}

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

class WaterByFormula : public Water, public testing::WithParamInterface<Fresnel> {};
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

TEST_F(Water, FlatWaterShowsTheTracedReflection) {
    const ReflectionDesc reflection;
    BodyDesc desc;
    desc.reflection = &reflection;
    Body* body = makeBody(desc);
    const Camera camera = boxCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const WaterPicture p =
        picture({body}, camera, 0, SurfaceOutput::reflection, {traced.color, traced.depth});
    std::vector<double> errors;
    size_t skyPixels = 0, skyRight = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        const float* c = &p.color[i * 4];
        if (traced.truth[i] == Truth::recoverable)
            errors.push_back(glm::length(glm::dvec2(c[0], c[1]) * glm::dvec2(traced.width, traced.height) -
                                         traced.source[i]));
        if (traced.truth[i] == Truth::sky) {
            ++skyPixels;
            skyRight += std::abs(c[0] - 1) < 0.02 && std::abs(c[1] - 2) < 0.04 && std::abs(c[2] - 3) < 0.06;
        }
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.6);
    EXPECT_LT(errors[errors.size() * 9 / 10], 3);
    EXPECT_GT(static_cast<double>(skyRight), 0.98 * static_cast<double>(skyPixels));
}

/// What a picture shows, at an offset in a larger one of nothing but sky.
SceneBehind placedIn(const Camera& larger, const TracedView& traced, uint32_t left, uint32_t top) {
    const size_t pixels = size_t{larger.width} * larger.height;
    SceneBehind placed{std::vector<float>(pixels * 4, 9.0f), std::vector<float>(pixels, 0.0f)};
    for (uint32_t y = 0; y < traced.height; ++y) {
        const size_t from = size_t{y} * traced.width, to = size_t{y + top} * larger.width + left;
        std::copy_n(&traced.color[from * 4], size_t{traced.width} * 4, &placed.color[to * 4]);
        std::copy_n(&traced.depth[from], traced.width, &placed.depth[to]);
    }
    return placed;
}

TEST_F(Water, FlatWaterShowsTheSameReflectionWithinALargerPicture) {
    Camera alone = boxCamera();
    alone.width = 200;
    alone.height = 120;
    Camera larger = alone;
    larger.width = 248;
    larger.height = 144;
    constexpr uint32_t left = 40, top = 16;
    const TracedView traced = Tracer(alone, harbourOfBoxes()).run();
    for (const uint32_t downscale : {1u, 2u}) {
        ReflectionDesc reflection;
        reflection.downscale = downscale;
        BodyDesc desc;
        desc.reflection = &reflection;
        Body* body = makeBody(desc);
        changeView = nullptr;
        const WaterPicture expected =
            picture({body}, alone, 0, SurfaceOutput::reflection, {traced.color, traced.depth});
        changeView = [&](ViewDesc& view) {
            view.viewport = {left, top, 200, 120, 0, 1};
            copyMatrix(projectionMatrix(alone), view.projection);
        };
        const WaterPicture found = picture({makeBody(desc)}, larger, 0, SurfaceOutput::reflection,
                                           placedIn(larger, traced, left, top));
        size_t water = 0;
        double worst = 0;
        for (uint32_t y = 0; y < alone.height; ++y)
            for (uint32_t x = 0; x < alone.width; ++x) {
                const size_t a = size_t{y} * alone.width + x, b = size_t{y + top} * larger.width + x + left;
                ASSERT_EQ(expected.covered(a), found.covered(b));
                if (!expected.covered(a)) continue;
                ++water;
                for (size_t c = 0; c < 3; ++c)
                    worst = std::max(
                        worst, std::abs(double{expected.color[a * 4 + c]} - double{found.color[b * 4 + c]}));
            }
        EXPECT_GT(water, 10000u);
        EXPECT_LT(worst, 1e-3) << "downscale " << downscale;
    }
}

/// The boxes over flat water, and what the reflection image knows of each pixel.
struct Mirrored {
    std::vector<float> color; ///< RGBA, before Fresnel
    std::vector<float> info;
};

class WaterLook : public Water {
  protected:
    Mirrored mirrored(const ReflectionDesc& reflection, const TracedView& traced) {
        BodyDesc desc;
        desc.reflection = &reflection;
        Body* body = makeBody(desc);
        const WaterPicture p =
            picture({body}, boxCamera(), 0, SurfaceOutput::reflection, {traced.color, traced.depth});
        const ReflectionImages images = reflectionImages(body, 0);
        return {p.color, download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
    }
};

bool sameColor(const std::vector<float>& a, const std::vector<float>& b, size_t pixel, float tolerance) {
    for (size_t i = pixel * 4; i < pixel * 4 + 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
    return true;
}

TEST_F(WaterLook, ScatterBlursBeyondTheClearDistanceAlone) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    ReflectionDesc desc;
    const Mirrored sharp = mirrored(desc, traced);
    desc.scatter = 0.2f;
    desc.clearDistance = 2;
    const Mirrored scattered = mirrored(desc, traced);
    desc.blurLevels = 0;
    const Mirrored withoutMips = mirrored(desc, traced);
    size_t near = 0, nearMoved = 0, far = 0, farMoved = 0, movedWithoutMips = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::recoverable) continue;
        const bool moved = !sameColor(sharp.color, scattered.color, i, 1e-4f);
        movedWithoutMips += !sameColor(sharp.color, withoutMips.color, i, 1e-4f);
        if (sharp.info[i] > 0 && sharp.info[i] < 1.99f) ++near, nearMoved += moved;
        if (sharp.info[i] > 4) ++far, farMoved += moved;
    }
    EXPECT_GT(near, 300u);
    EXPECT_GT(far, 300u);
    EXPECT_EQ(nearMoved, 0u);
    EXPECT_GT(farMoved, far * 9 / 10);
    EXPECT_EQ(movedWithoutMips, 0u);
}

TEST_F(WaterLook, FadesToTheSkyWithDistance) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    ReflectionDesc desc;
    const Mirrored plain = mirrored(desc, traced);
    desc.skyFadeDistance = 6;
    const Mirrored faded = mirrored(desc, traced);
    size_t near = 0, nearSame = 0, far = 0, farSky = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (traced.truth[i] != Truth::recoverable || !(plain.info[i] > 0)) continue;
        if (plain.info[i] < 3) ++near, nearSame += sameColor(plain.color, faded.color, i, 1e-4f);
        if (plain.info[i] >= 6) {
            ++far;
            farSky +=
                std::abs(faded.color[i * 4] - 1) < 0.01f && std::abs(faded.color[i * 4 + 1] - 2) < 0.02f;
        }
    }
    EXPECT_GT(near, 300u);
    EXPECT_GT(far, 100u);
    EXPECT_EQ(nearSame, near);
    EXPECT_EQ(farSky, far);
}

// Texels of a smaller reflection lie under what stands before the water, too, and know nothing.
TEST_F(WaterLook, ASmallerReflectionLetsNoSkyInAlongWhatStandsBeforeIt) {
    const TracedView traced = Tracer(boxCamera(), harbourOfBoxes()).run();
    for (const uint32_t downscale : {2u, 4u}) {
        ReflectionDesc desc;
        desc.downscale = downscale;
        const Mirrored result = mirrored(desc, traced);
        const int reach = static_cast<int>(downscale);
        size_t beside = 0, skyInIt = 0;
        double squares = 0;
        size_t counted = 0;
        for (int y = reach; y < static_cast<int>(traced.height) - reach; ++y)
            for (int x = reach; x < static_cast<int>(traced.width) - reach; ++x) {
                const auto at = [&](int column, int line) {
                    return static_cast<size_t>(line) * traced.width + static_cast<size_t>(column);
                };
                const size_t i = at(x, y);
                if (traced.truth[i] != Truth::recoverable) continue;
                const glm::dvec2 shown = glm::dvec2(result.color[i * 4], result.color[i * 4 + 1]) -
                                         traced.source[i] / glm::dvec2(traced.width, traced.height);
                squares += glm::dot(shown, shown);
                ++counted;
                bool hits = true, stands = false;
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx) {
                        const Truth truth = traced.truth[at(x + dx, y + dy)];
                        hits = hits && truth != Truth::sky && truth != Truth::lost;
                        stands = stands || (truth == Truth::none && traced.depth[at(x + dx, y + dy)] > 0);
                    }
                if (!hits || !stands) continue;
                ++beside;
                // The scene's blue is 1, the sky's 3.
                skyInIt += result.color[i * 4 + 2] > 1.2f;
            }
        const double psnr = 10 * std::log10(2 * static_cast<double>(counted) / squares);
        std::printf("1/%u: PSNR %.2f dB, %zu of %zu beside things are the sky's in part\n", downscale, psnr,
                    skyInIt, beside);
        EXPECT_GT(beside, 300u);
        EXPECT_LE(skyInIt, beside / 25) << downscale;
        EXPECT_GE(psnr, 13.5) << downscale;
    }
}

// Waves far off bend rays so steeply up that the flat mirror shows, where those are looked up, things close
// to the eye. The rays go away from them, to the sky or to what the flat mirror shows behind them.
TEST_F(Water, WavesDoNotMirrorWhatLiesBeforeThem) {
    BodyDesc desc;
    desc.shading.reflectionSamples = 4;
    Body* body = mirroringBreeze(desc);
    Camera camera = seaCamera();
    camera.target = {3, 2, -10};
    const SceneBehind sky = nothingBehind(camera);
    const SceneBehind wall = drawnOver(camera, sky, 5, [&](const glm::dvec3& ray) {
        const double distance = (-100 - camera.eye.z) / ray.z;
        return camera.eye.y + distance * ray.y < 0 ? -1 : distance;
    });
    for (const bool walled : {false, true}) {
        const SceneBehind& open = walled ? wall : sky;
        // A bright board 15 m away, above the water.
        const SceneBehind behind = drawnOver(camera, open, 50, [&](const glm::dvec3& ray) {
            const double distance = (-8 - camera.eye.z) / ray.z;
            const glm::dvec3 at = camera.eye + distance * ray;
            return at.y < 0.5 || at.y > 2 || std::abs(at.x - 3) > 3 ? -1 : distance;
        });
        const WaterPicture without = picture({body}, camera, 2, SurfaceOutput::shaded, open);
        const WaterPicture with = picture({body}, camera, 2, SurfaceOutput::shaded, behind);
        double most = 0, farOff = 0, near = 0;
        size_t counted = 0;
        for (uint32_t y = 0; y < with.height; ++y)
            for (uint32_t x = 0; x < with.width; ++x) {
                const size_t i = size_t{y} * with.width + x;
                const double angle = angleBelowHorizon(camera, x, y);
                const double gained = double{with.color[4 * i]} - double{without.color[4 * i]};
                if (angle > 0.25) near = std::max(near, gained);
                if (angle > 0.01 && angle < 0.09) most = std::max(most, std::abs(gained));
                if (angle < 0.03 || angle > 0.15 || behind.color[4 * i] == 50) continue;
                farOff += std::abs(gained);
                ++counted;
            }
        farOff /= static_cast<double>(counted);
        std::printf("changed by %.5f far off, %.5f at most, by up to %.2f near\n", farOff, most, near);
        EXPECT_GT(near, 1) << "the board is mirrored before itself";
        // A blur by where the board is mirrored holds some of it, where it is no sky. Without looking: 0.236.
        EXPECT_LT(farOff, walled ? 0.03 : 1e-3);
        if (!walled) {
            EXPECT_LT(most, 1e-3);
        }
    }
}

// Rays of the picture's outermost columns are bent out of it as often as not. What is mirrored goes on there.
TEST_F(Water, MirrorsAtTheBorderWhatItMirrorsBesideIt) {
    ReflectionDesc reflection;
    reflection.edgeFade = 0;
    Camera camera = seaCamera();
    camera.target = camera.eye + glm::dvec3(0, 0, -10);
    const SceneBehind wall = drawnOver(camera, nothingBehind(camera), 50, [&](const glm::dvec3& ray) {
        const double distance = (-12 - camera.eye.z) / ray.z;
        return camera.eye.y + distance * ray.y < 0 ? -1 : distance;
    });
    const WaterPicture p =
        picture({mirroringBreeze({}, reflection)}, camera, 2, SurfaceOutput::reflection, wall);
    double border = 0, inside = 0;
    size_t borders = 0, insides = 0;
    for (uint32_t y = p.height / 2; y < p.height * 7 / 8; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const size_t i = size_t{y} * p.width + x;
            if (!p.covered(i) || wall.depth[i] > 0) continue;
            const uint32_t off = std::min(x, p.width - 1 - x);
            if (off < 3) border += double{p.color[4 * i]}, ++borders;
            if (off > 20 && off < 80) inside += double{p.color[4 * i]}, ++insides;
        }
    ASSERT_GT(borders, 100u);
    border /= static_cast<double>(borders);
    inside /= static_cast<double>(insides);
    std::printf("%.2f at the border, %.2f beside it\n", border, inside);
    EXPECT_GT(inside, 25) << "the wall is what is mirrored";
    EXPECT_NEAR(border / inside, 1, 0.05);
}

std::vector<BentLook> Water::bentSamples(Body* body, const Camera& camera, const Along& along) {
    const SceneBehind behind = drawnOver(camera, nothingBehind(camera), 50,
                                         [&](const glm::dvec3& ray) { return along(camera.eye, ray); });
    const WaterPicture normals = picture({body}, camera, 2, SurfaceOutput::normal, behind);
    const WaterPicture sources = picture({body}, camera, 2, SurfaceOutput::reflectionSource, behind);
    std::vector<BentLook> looks;
    for (uint32_t y = 0; y < normals.height; ++y)
        for (uint32_t x = 0; x < normals.width; ++x) {
            const size_t i = size_t{y} * normals.width + x;
            if (!normals.covered(i) || behind.depth[i] > 0) continue;
            const glm::dvec3 from = worldAt(camera, normals, x, y), ray = rayThrough(camera, x, y);
            const float* const normal = &normals.color[4 * i];
            const float* const source = &sources.color[4 * i];
            const glm::dvec3 bent = glm::reflect(ray, glm::dvec3(normal[0], normal[1], normal[2]));
            const double distance = along(from, bent);
            looks.push_back({distance,
                             along(from, ray * glm::dvec3(1, -1, 1)),
                             from + distance * bent,
                             source[3] == 2.0f,
                             {source[0], source[1]}});
        }
    return looks;
}

// Where the flat mirror shows the sky, a facet that leans towards the eye mirrors what floats near by: the
// tail of its reflection, in pieces.
TEST_F(Water, MirrorsTheTailOfWhatFloats) {
    const ReflectionDesc reflection;
    SeaDesc sea = breeze();
    sea.windSpeed = 3;
    sea.fetch = 1e3f;
    sea.warp = 0; // strays are so few that each sea has its own number of them
    BodyDesc desc;
    desc.waves = &sea;
    desc.reflection = &reflection;
    Camera camera = seaCamera();
    camera.width = 640;
    camera.height = 360;
    camera.target = camera.eye + glm::dvec3(0, -0.6, -2);
    // 2 m high, 10 m away.
    const auto alongToBoard = [](const glm::dvec3& from, const glm::dvec3& ray) {
        const double distance = ray.z < 0 ? (-3 - from.z) / ray.z : -1;
        const glm::dvec3 at = from + distance * ray;
        return at.y < -1 || at.y > 2 || std::abs(at.x - 3) > 0.5 ? -1 : distance;
    };
    size_t tail = 0, found = 0, beside = 0, strays = 0;
    for (const BentLook& look : bentSamples(makeBody(desc), camera, alongToBoard)) {
        if (look.bent > 0 && !(look.flat > 0)) ++tail, found += look.says;
        if (!(look.bent > 0)) ++beside, strays += look.says;
    }
    std::printf("%zu of %zu in the tail are found, %zu of %zu beside it\n", found, tail, strays, beside);
    EXPECT_GT(tail, 200u);
    EXPECT_GT(found, 8 * tail / 10);
    EXPECT_LT(strays, beside / 5000);
}

// Waves near an eye that looks down mirror a wall far off, which the flat mirror shows far away from them,
// where it has but a short way to it.
TEST_F(Water, MirrorsAWallFarBeforeTheWavesThatAreSteepEnough) {
    Camera camera = seaCamera();
    camera.width = 640;
    camera.height = 360;
    camera.eye = {0, 14, 0};
    camera.target = {0, 0, -30};
    const auto alongToWall = [](const glm::dvec3& from, const glm::dvec3& ray) {
        const double distance = ray.z < 0 ? (-60 - from.z) / ray.z : -1;
        const double y = from.y + distance * ray.y;
        return y < -1 || y > 14 ? -1 : distance;
    };
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    const glm::dvec2 size(camera.width, camera.height);
    size_t beyondFlat = 0;
    std::vector<double> off;
    for (const BentLook& look : bentSamples(mirroringBreeze({}), camera, alongToWall)) {
        if (!(look.bent > 0) || look.flat > 0) continue;
        const glm::dvec4 p = clip * glm::dvec4(look.met, 1);
        const glm::dvec2 truth = (glm::dvec2(p) / p.w * 0.5 + 0.5) * size;
        // Off the border, where what is not shown cannot be found.
        const glm::dvec2 inside = glm::min(truth, size - truth);
        if (std::min(inside.x, inside.y) <= 20) continue;
        ++beyondFlat;
        if (look.says) off.push_back(glm::length(truth - look.source));
    }
    std::ranges::sort(off);
    ASSERT_GT(beyondFlat, 1000u);
    ASSERT_GT(off.size(), 9 * beyondFlat / 10);
    std::printf("%zu of %zu are found, off by %.1f px in the median, %.1f at p90\n", off.size(), beyondFlat,
                off[off.size() / 2], off[off.size() * 9 / 10]);
    EXPECT_LT(off[off.size() / 2], 0.3);
    EXPECT_LT(off[off.size() * 9 / 10], 1.5);
}

std::vector<double> Water::columnOfBand(double above, uint32_t looks, uint32_t scale) {
    const RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
    BodyDesc desc;
    desc.refraction = &clear;
    const UnderwaterDesc underwater;
    if (above < 0) desc.underwater = &underwater;
    desc.shading.reflectionSamples = looks;
    Camera camera = seaCamera();
    camera.width = 160 * scale;
    camera.height = 90 * scale;
    camera.eye = {0, above, 0};
    camera.target = {0, above, -60};
    const SceneBehind dark = nothingBehind(camera);
    const SceneBehind lit = drawnOver(camera, dark, 50, [&](const glm::dvec3& ray) {
        const double distance = ray.z < 0 ? -60 / ray.z : -1;
        const glm::dvec3 at = camera.eye + distance * ray;
        return at.y / above < 2 || at.y / above > 8.0 / 3 || std::abs(at.x) > 80 ? -1 : distance;
    });
    Body* const body = mirroringBreeze(desc);
    const WaterPicture without = picture({body}, camera, 2, SurfaceOutput::reflection, dark);
    const WaterPicture with = picture({body}, camera, 2, SurfaceOutput::reflection, lit);
    std::vector<double> rows(90);
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const size_t i = size_t{y} * camera.width + x;
            if (std::abs(ray.x / ray.z) >= 0.5 || !with.covered(i)) continue;
            rows[y / scale] += double{with.color[4 * i]} - double{without.color[4 * i]};
        }
    for (double& row : rows) row /= scale * scale;
    return rows;
}

/// Rows by so many looks are off by less than that share of the light from those of four times the
/// resolution.
void Water::expectColumn(double above, const std::map<uint32_t, double>& offByLooks) {
    const std::vector<double> fine = columnOfBand(above, 4, 4);
    const double light = std::accumulate(fine.begin(), fine.end(), 0.0);
    for (const auto& [looks, most] : offByLooks) {
        const std::vector<double> rows = columnOfBand(above, looks, 1);
        double off = 0;
        for (size_t y = 0; y < rows.size(); ++y) off += std::abs(rows[y] - fine[y]);
        std::printf("%u looks: rows are off by %.3f of the light\n", looks, off / light);
        EXPECT_LT(off / light, most) << looks;
    }
}

// Few looks at what a pixel's slopes mirror, each pixel's at the same slopes, show a light once for each, one
// below the other. Off by 1.45, 0.96 and 0.38 then; seen from below by 1.15, 0.62 and 0.26.
TEST_F(Water, MirrorsALightAsOneColumnByFewLooks) {
    expectColumn(3, {{1, 0.62}, {2, 0.53}, {4, 0.31}});
}

TEST_F(Water, MirrorsALightBelowAsOneColumnByFewLooks) {
    expectColumn(-3, {{1, 0.50}, {2, 0.32}, {4, 0.20}});
}

TEST_F(Water, SaysWhereTheReflectionIsTakenFrom) {
    const ReflectionDesc reflection;
    BodyDesc desc;
    desc.reflection = &reflection;
    Body* body = makeBody(desc);
    const Camera camera = boxCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const SceneBehind behind = {traced.color, traced.depth};
    const WaterPicture colors = picture({body}, camera, 0, SurfaceOutput::reflection, behind);
    const WaterPicture sources = picture({body}, camera, 0, SurfaceOutput::reflectionSource, behind);
    std::vector<double> fromTruth, fromColors;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        const float* const source = &sources.color[i * 4];
        if (source[3] != 2.0f || traced.truth[i] != Truth::recoverable) continue;
        const glm::dvec2 pixel(source[0], source[1]);
        const float* const c = &colors.color[i * 4];
        fromTruth.push_back(glm::length(pixel - traced.source[i]));
        fromColors.push_back(
            glm::length(glm::dvec2(c[0], c[1]) * glm::dvec2(traced.width, traced.height) - pixel));
    }
    ASSERT_GT(fromTruth.size(), 1000u);
    std::ranges::sort(fromTruth);
    std::ranges::sort(fromColors);
    EXPECT_LT(fromTruth[fromTruth.size() / 2], 0.15);
    EXPECT_LT(fromTruth[fromTruth.size() * 9 / 10], 0.5);
    // Colours are those of whole pixels.
    EXPECT_LT(fromColors[fromColors.size() / 2], 0.6);

    const WaterPicture sky = picture({makeBody({})}, camera, 0, SurfaceOutput::reflectionSource, behind);
    for (size_t i = 0; i < traced.truth.size(); ++i)
        if (sky.covered(i)) {
            const float* const source = &sky.color[i * 4];
            ASSERT_TRUE(source[0] == -1.0f && source[1] == -1.0f && source[3] == 1.0f) << i;
        }
}

/// A bed and a wall before it, in squares of the picture: what is looked up beside its place differs.
SceneBehind chequeredBedAndWall(const Camera& camera) {
    SceneBehind behind = drawnOver(camera, planeBelow(camera, -3, 1), 2, [&](const glm::dvec3& ray) {
        const double distance = (-20 - camera.eye.z) / ray.z, height = camera.eye.y + distance * ray.y;
        return height < -3 || height > 3 ? -1 : distance;
    });
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x)
            if ((x / 4 + y / 4) % 2)
                for (size_t c = 0; c < 3; ++c) behind.color[(size_t{y} * camera.width + x) * 4 + c] *= 0.25f;
    return behind;
}

/// A sea of one cascade, which repeats every 60 m, and its foam's lace every 384: both do after 1920.
class WaterAMillionMetresAway : public Water {
  protected:
    WaterAMillionMetresAway() {
        sea_ = breeze();
        sea_.cascades = 1;
        sea_.largestPatch = 60;
        sea_.warp = 0; // the same sea lies there
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        for (float& channel : lighting.skyIrradiance) channel = 1;
        for (float& channel : lighting.sunIrradiance) channel = 1;
        near_.eye += glm::dvec3(0.137, 0, 0.291); // floats have no such places far off
        near_.target += glm::dvec3(0.137, 0, 0.291);
    }

    void expectTheSamePicture(const SceneBehind& behind = {}) {
        Body* const body = makeBody(desc_);
        Camera far = near_;
        const glm::dvec3 whole(1920.0 * 521, 0, -1920.0 * 521);
        far.eye += whole;
        far.target += whole;
        const WaterPicture a = picture({body}, near_, 3, SurfaceOutput::shaded, behind);
        const WaterPicture b = picture({body}, far, 3, SurfaceOutput::shaded, behind);
        double worst = 0;
        size_t count = 0;
        for (size_t i = 0; i < a.color.size(); ++i) {
            if (!a.covered(i / 4) || !b.covered(i / 4)) continue;
            worst = std::max(worst, std::abs(double{a.color[i]} - double{b.color[i]}));
            ++count;
        }
        std::printf("differs by %.4f / 255 at most\n", worst * 255);
        EXPECT_GT(count, 50000u);
        EXPECT_LT(worst, 1.0 / 255); // and the sky's radiance goes up to 3
    }

    SeaDesc sea_;
    BodyDesc desc_;
    Camera near_ = seaCamera();
};

TEST_F(WaterAMillionMetresAway, WavesAreTheSamePicture) {
    expectTheSamePicture();
}

TEST_F(WaterAMillionMetresAway, FoamIsTheSamePicture) {
    const FoamDesc foam{.bias = 0.2f};
    desc_.foam = &foam;
    expectTheSamePicture();
}

TEST_F(WaterAMillionMetresAway, ABedIsTheSamePicture) {
    const RefractionDesc refraction = {{0.3f, 0.1f, 0.05f}, {0.01f, 0.01f, 0.01f}, 1};
    desc_.refraction = &refraction;
    expectTheSamePicture(chequeredBedAndWall(near_));
}

TEST_F(WaterAMillionMetresAway, WhatIsMirroredIsTheSamePicture) {
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::hybrid}) {
        ReflectionDesc reflection;
        reflection.technique = technique;
        desc_.reflection = &reflection;
        expectTheSamePicture(chequeredBedAndWall(near_));
    }
}

TEST_F(Water, TheSameTimeGivesTheSameBits) {
    Body* body = wavyBody(breeze());
    const WaterPicture first = picture({body}, seaCamera(), 10);
    picture({body}, seaCamera(), 777);
    EXPECT_EQ(picture({body}, seaCamera(), 10).color, first.color);
}

TEST_F(Water, NormalsAreUnitAndFaceUp) {
    Body* body = wavyBody(breeze());
    const WaterPicture p = picture({body}, seaCamera(), 1, SurfaceOutput::normal);
    double tilted = 0;
    for (size_t i = 0; i < p.color.size() / 4; ++i) {
        if (!p.covered(i)) continue;
        const glm::dvec3 n(p.color[i * 4], p.color[i * 4 + 1], p.color[i * 4 + 2]);
        EXPECT_NEAR(glm::length(n), 1, 1e-4);
        EXPECT_GT(n.y, 0);
        tilted = std::max(tilted, 1 - n.y);
    }
    EXPECT_GT(tilted, 0.01);
}

// From so near that a pixel is narrower than the waves are.
TEST_F(Water, NormalsAreThoseOfHeightQueries) {
    SeaDesc desc = breeze();
    desc.windDirection = 0.6f;
    desc.cascades = 2;
    desc.samples = 256;
    Body* const body = wavyBody(desc);
    Camera camera = seaCamera();
    camera.target = {3, 0, 6.9};
    camera.width = 96;
    camera.height = 54;
    double apart = 0, steep = 0;
    for (const double time : {1.0, 5.0, 9.0}) {
        const WaterPicture places = picture({body}, camera, time, SurfaceOutput::height),
                           normals = picture({body}, camera, time, SurfaceOutput::normal);
        for (uint32_t y = 0; y < camera.height; y += 3)
            for (uint32_t x = 0; x < camera.width; x += 3) {
                const glm::dvec3 world = worldAt(camera, places, x, y);
                const double point[] = {world.x, world.z};
                HeightSample sample;
                sampleHeights(*sea(body), time, point, 1, &sample);
                const float* const drawn = &normals.color[(size_t{y} * camera.width + x) * 4];
                for (const int axis : {0, 2}) {
                    const double expected = double{sample.normal[axis]} / double{sample.normal[1]};
                    const double off = double{drawn[axis]} / double{drawn[1]} - expected;
                    apart += off * off;
                    steep += expected * expected;
                }
            }
    }
    std::printf("slopes are off by %.4f of what they are\n", std::sqrt(apart / steep));
    EXPECT_LT(std::sqrt(apart / steep), 0.068); // 0.076 with tiles' warp along the other axis
}

// Waves far too narrow to be seen: what their slopes make of sun and sky depends on how all lies to each
// other.
TEST_F(Water, LooksTheSameTurnedWithItsWind) {
    const auto brightness = [&](double falls, double turn) {
        const auto turned = [&](const glm::dvec3& p) {
            return glm::dvec3(p.x * std::cos(turn) - p.z * std::sin(turn), p.y,
                              p.x * std::sin(turn) + p.z * std::cos(turn));
        };
        SeaDesc desc = breeze();
        desc.windSpeed = 14;
        desc.windDirection = static_cast<float>(turn);
        Camera camera;
        camera.eye = {0, 5e3, 0};
        camera.target = camera.eye + turned({10, -10 * falls, 0});
        camera.width = camera.height = 16;
        camera.fovDegrees = 2;
        const glm::dvec3 toSun = turned(glm::normalize(glm::dvec3(1, 1.6, 0)));
        for (int i = 0; i < 3; ++i) lighting.toSun[i] = toSun[i];
        const WaterPicture p = picture({wavyBody(desc)}, camera, 5);
        double sum = 0;
        for (size_t i = 0; i < p.color.size(); i += 4) sum += double{p.color[i]};
        return sum / (16 * 16);
    };
    for (const double falls : {0.05, 0.1, 1.0}) {
        std::ranges::fill(lighting.sunIrradiance, falls == 1.0 ? 20.0f : 0.0f);
        const double straight = brightness(falls, 0);
        for (const double turn : {0.25, -0.25, 0.5}) {
            const double share = brightness(falls, turn * std::numbers::pi) / straight;
            std::printf("%.2f down, turned by %.2f: %.4f of it\n", falls, turn, share);
            EXPECT_NEAR(share, 1, falls == 1.0 ? 0.03 : 0.01) << turn;
        }
    }
}

TEST_F(Water, StaysFiniteWhateverTheSea) {
    for (const float wind : {0.0f, 0.01f, 3.0f, 60.0f})
        for (const float choppiness : {0.0f, 1.0f, 10.0f}) {
            SeaDesc desc = breeze();
            desc.windSpeed = wind;
            desc.choppiness = choppiness;
            const FoamDesc foam;
            const RefractionDesc refraction;
            const ReflectionDesc reflection;
            BodyDesc body;
            body.waves = &desc;
            body.wavesBackend = fftwWaves();
            body.foam = &foam;
            body.refraction = &refraction;
            body.reflection = &reflection;
            Body* made = makeBody(body);
            for (const double height : {3.0, 0.0, -1.0}) {
                Camera camera = seaCamera();
                camera.width = 96;
                camera.height = 54;
                camera.eye.y = height;
                lighting.sunIrradiance[0] = lighting.sunIrradiance[1] = lighting.sunIrradiance[2] = 5;
                const WaterPicture p = picture({made}, camera, 1e8);
                EXPECT_TRUE(std::ranges::all_of(p.color, [](float v) { return std::isfinite(v); }))
                    << "wind " << wind << " choppiness " << choppiness << " eye " << height;
            }
        }
}

TEST_F(Water, FoamGathersWhereTheSeaIsRough) {
    const auto cover = [&](float wind) {
        SeaDesc desc = breeze();
        desc.windSpeed = wind;
        desc.fetch = 300e3f;
        desc.samples = 128;
        const FoamDesc foam;
        BodyDesc body;
        body.waves = &desc;
        body.wavesBackend = fftwWaves();
        body.foam = &foam;
        Camera camera = seaCamera();
        camera.eye.y = 30;
        camera.target.y = 10;
        const WaterPicture p = picture({makeBody(body)}, camera, 20, SurfaceOutput::foam);
        double sum = 0, count = 0;
        for (size_t i = 0; i < p.color.size() / 4; ++i) {
            if (!p.covered(i)) continue;
            EXPECT_GE(p.color[i * 4], 0);
            EXPECT_LE(p.color[i * 4], 1);
            sum += double{p.color[i * 4]};
            ++count;
        }
        return sum / count;
    };
    const double calm = cover(3);
    const double fresh = cover(10);
    const double gale = cover(20);
    EXPECT_LT(calm, fresh);
    EXPECT_LT(fresh, gale);
    EXPECT_LT(gale, 0.5);
    EXPECT_GT(fresh, 0);
}

// What distance takes from the normals goes into the roughness: seen from above, over pixels of centimetres
// or of hectometres, all slopes together are Cox and Munk's.
TEST_F(Water, SlopeVarianceIsTheSameAtAnyDistance) {
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

// A sea seen from 1 km has the same radiance whether pixels show its waves, and the mean is taken of them, or
// one pixel's roughness stands for all: whether waves that hide others are looked for or not.
class WaterFromAfar : public Water, public testing::WithParamInterface<Quality> {};

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

class WaterFoam : public Water {
  protected:
    /// Under a wind along no axis.
    Body* foamyBody(WavesOn on = WavesOn::cpu) {
        SeaDesc sea = breeze();
        sea.windSpeed = 15;
        sea.windDirection = 0.6f;
        sea.fetch = 300e3f;
        const FoamDesc foam;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesOn = on;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam;
        return makeBody(desc);
    }
    /// Thick foam, drawn out by a gale along x.
    Body* streakyBody(uint32_t slopeSamples = 1) {
        SeaDesc sea = breeze();
        sea.windSpeed = 20;
        sea.windDirection = 0;
        sea.fetch = 500e3f;
        const FoamDesc foam{.bias = 0.03f};
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam;
        desc.shading.slopeSamples = slopeSamples;
        return makeBody(desc);
    }
    static Camera above() {
        Camera camera = seaCamera();
        camera.eye.y = 40;
        camera.target.y = 10;
        return camera;
    }
    static constexpr double foamTime = 60;
    /// What of each pixel is white at that time.
    std::vector<double> white(Body* body, const Camera& camera) {
        const WaterPicture p = picture({body}, camera, foamTime, SurfaceOutput::foam);
        std::vector<double> shares;
        for (size_t i = 0; i < p.color.size(); i += 4) {
            const bool covered = p.covered(i / 4);
            holes_ += !covered;
            shares.push_back(covered ? double{p.color[i]} : 0);
        }
        return shares;
    }
    /// Pixels of all white() so far that no water covers.
    size_t holes() const { return holes_; }
    /// Each pixel as the mean of `finer` times as many each way.
    std::vector<double> whiteOf(Body* body, Camera camera, uint32_t finer) {
        const uint32_t width = camera.width;
        std::vector<double> means(size_t{width} * camera.height);
        camera.width *= finer;
        camera.height *= finer;
        const std::vector<double> fine = white(body, camera);
        for (size_t i = 0; i < fine.size(); ++i)
            means[i / camera.width / finer * width + i % camera.width / finer] += fine[i] / (finer * finer);
        return means;
    }

  private:
    size_t holes_ = 0;
};

/// Share of pixels that are neither white nor dark.
double partly(const std::vector<double>& white) {
    const auto between = [](double share) { return share > 0.05 && share < 0.95; };
    return static_cast<double>(std::ranges::count_if(white, between)) / static_cast<double>(white.size());
}

// A first frame has a lifetime to catch up, and slow frames after it two seconds at most.
TEST_F(WaterFoam, OfAHostThatFallsBehindTakesNoMoreThanEightSteps) {
    Body* body = foamyBody(WavesOn::gpu);
    const auto dispatches = [&](double time) {
        spiedCalls().clear();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, time), Status::ok) << message();
        });
        return countSpied("CmdDispatch");
    };
    const size_t first = dispatches(100);
    const size_t none = dispatches(100.1), one = dispatches(100.3);
    const size_t aStep = one - none;
    EXPECT_GT(aStep, 2u);
    EXPECT_GT(first, none + 45 * aStep);
    EXPECT_EQ(dispatches(150), first) << "a single gap is made up for";
    for (const double time : {155.0, 161.0, 400.0, 403.0})
        EXPECT_LE(dispatches(time), one + 7 * aStep) << time;
    EXPECT_EQ(dispatches(404), one + 3 * aStep);
}

TEST_F(WaterFoam, IsTheSamePictureWhateverWasDrawnBefore) {
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    for (const WavesOn on : {WavesOn::cpu, WavesOn::gpu}) {
        Body* steady = foamyBody(on);
        for (double time = 45; time < 60.6; time += 0.9) picture({steady}, camera, time);
        const WaterPicture after = picture({steady}, camera, 60.61, SurfaceOutput::foam);
        EXPECT_EQ(picture({foamyBody(on)}, camera, 60.61, SurfaceOutput::foam).color, after.color);
        Body* jumped = foamyBody(on);
        picture({jumped}, camera, 1e6);
        EXPECT_EQ(picture({jumped}, camera, 60.61, SurfaceOutput::foam).color, after.color);
        EXPECT_NE(picture({jumped}, camera, 61.61, SurfaceOutput::foam).color, after.color);
    }
}

TEST_F(WaterFoam, IsTheSameOnTheGpuAsOnTheCpu) {
    const auto texels = [&](WavesOn on) {
        Body* body = foamyBody(on);
        for (const double time : {59.0, 59.3, 59.8}) picture({body}, above(), time);
        std::vector<float> all;
        for (uint32_t c = 0; c < body->find<FoamPart>()->foam.cascades(); ++c)
            for (const uint32_t mip : {0u, 1u}) {
                const uint32_t size = 64u >> mip;
                const std::vector<float> layer =
                    download(body->find<FoamPart>()->foam.image(), VK_FORMAT_R16G16B16A16_SFLOAT,
                             {size, size}, mip, c);
                all.insert(all.end(), layer.begin(), layer.end());
            }
        return all;
    };
    const std::vector<float> cpu = texels(WavesOn::cpu), gpu = texels(WavesOn::gpu);
    ASSERT_EQ(cpu.size(), gpu.size());
    double worst = 0, sum = 0;
    for (size_t i = 0; i < cpu.size(); ++i) {
        worst = std::max(worst, std::abs(double{cpu[i]} - double{gpu[i]}));
        sum += double{cpu[i]};
    }
    std::printf("foam on the GPU off the CPU's by %.4f at most\n", worst);
    EXPECT_GT(sum / static_cast<double>(cpu.size()), 0.005);
    EXPECT_LT(worst, 0.02); // half floats, rounded at each step
}

// Broken up near by, a mean from afar, white is the share of the sea that is measured without a picture, be
// it thin or thick.
class WaterFoamFromAbove : public WaterFoam, public testing::WithParamInterface<float> {};

TEST_P(WaterFoamFromAbove, CoversAsMuchFromAnyHeight) {
    const float bias = GetParam();
    SeaDesc desc = breeze();
    desc.windSpeed = 15;
    desc.fetch = 300e3f;
    desc.warp = 0; // one tile stands for all; FoamGate.IsOpenAsOftenAsItSays has the rest
    // A picture shows so little from near by that it takes many to know the sea's mean.
    struct Look {
        double height;
        int places;
    };
    constexpr Look looks[] = {{40, 1200}, {100, 400}, {400, 100}, {4000, 8}};
    const FoamDesc foam{.bias = bias};
    BodyDesc bodyDesc;
    bodyDesc.waves = &desc;
    bodyDesc.wavesBackend = fftwWaves();
    bodyDesc.foam = &foam;
    Body* body = makeBody(bodyDesc);
    double expected = 0;
    ASSERT_TRUE(whitecapCover(*sea(body), *fftwWaves(), foam, foamTime, &expected));
    EXPECT_GT(expected, bias > 0 ? 0.1 : 0.02);
    EXPECT_LT(expected, 0.5);
    const double tile = cascade(*sea(body), 0).patch;
    for (const Look& look : looks) {
        std::vector<double> shown, ofPart, ofSamples;
        for (int place = 0; place < look.places; ++place) {
            Camera camera = seaCamera();
            camera.width = camera.height = 64;
            // Evenly over the largest tile (Roberts 2018).
            const double u = tile * std::fmod(place * 0.7548776662466927, 1);
            const double v = tile * std::fmod(place * 0.5698402909980532, 1);
            camera.eye = {u, look.height, v};
            camera.target = {u + 0.001 * look.height, 0, v};
            const std::vector<double> here = white(body, camera);
            shown.insert(shown.end(), here.begin(), here.end());
            if (place >= 16) continue;
            const std::vector<double> samples = whiteOf(body, camera, 8);
            ofPart.insert(ofPart.end(), here.begin(), here.end());
            ofSamples.insert(ofSamples.end(), samples.begin(), samples.end());
        }
        std::printf("bias %.2f, from %4.0f m: %.4f white, expected %.4f; partly so %.3f of the pixels, and "
                    "%.3f as means of 64 samples\n",
                    static_cast<double>(bias), look.height, meanOf(shown), expected, partly(ofPart),
                    partly(ofSamples));
        EXPECT_NEAR(meanOf(shown) / expected, 1, 0.05) << look.height;
        EXPECT_NEAR(partly(ofPart), partly(ofSamples), 0.2 * partly(ofSamples)) << "a haze, or too hard";
    }
    // Of twenty million pixels: where a level of the mesh meets the next, snapped vertices are no longer on
    // a line.
    EXPECT_LE(static_cast<double>(holes()), limitOnGrid(0, 50));
}
INSTANTIATE_TEST_SUITE_P(, WaterFoamFromAbove, testing::Values(0.0f, 0.06f),
                         [](const auto& info) { return info.param > 0 ? "Thick" : "Thin"; });

// The pattern repeats every 24 m, across the wind without a bend: from the air its rafts would stand in rows.
TEST_F(WaterFoam, RaftsStandInNoRows) {
    Body* body = streakyBody();
    constexpr size_t rows = 64; // of pixels, to a tile
    Camera camera = seaCamera();
    camera.width = camera.height = 8 * rows;
    const double height = 24.0 * 8 / 2 / std::tan(glm::radians(camera.fovDegrees) / 2);
    camera.eye = {0, height, 0};
    camera.target = {0.001 * height, 0, 0};
    double most = -1, elsewhere = 0;
    for (const bool alongX : {true, false}) {
        const WaterPicture p = picture({body}, camera, 60, SurfaceOutput::foam);
        const auto correlation = [&](size_t lag) {
            double sum = 0, squares = 0, products = 0, count = 0;
            for (size_t y = 0; y < camera.height; ++y)
                for (size_t x = 0; x + lag < camera.width; ++x) {
                    const size_t i = alongX ? y * camera.width + x : x * camera.width + y;
                    const double a = p.color[4 * i], b = p.color[4 * (i + lag * (alongX ? 1 : camera.width))];
                    sum += a + b;
                    squares += a * a + b * b;
                    products += a * b;
                    ++count;
                }
            const double mean = sum / (2 * count);
            return (products / count - mean * mean) / (squares / (2 * count) - mean * mean);
        };
        for (const size_t lag : {rows, 2 * rows, 3 * rows}) most = std::max(most, correlation(lag));
        for (const size_t lag : {rows + rows / 2, 2 * rows + rows / 2})
            elsewhere = std::max(elsewhere, std::abs(correlation(lag)));
    }
    std::printf("correlation a tile apart %.3f, between %.3f\n", most, elsewhere);
    EXPECT_LT(most - elsewhere, 0.1); // thick foam has likeness of its own
}

// From an aeroplane a pixel is twice as long as wide and as large as the rafts: they stay white on dark, not
// a veil.
TEST_F(WaterFoam, IsNoVeilFromTheAir) {
    Camera camera = seaCamera();
    camera.width = 128;
    camera.height = 72;
    camera.fovDegrees = 46;
    camera.eye = {0, 400, 0};
    for (const bool downwind : {false, true})
        for (const uint32_t looks : {1u, 4u}) {
            Body* body = streakyBody(looks);
            camera.target = downwind ? glm::dvec3(600, 100, 0) : glm::dvec3(0, 100, 600);
            std::vector<double> drawn = white(body, camera), mean = whiteOf(body, camera, 4);
            for (std::vector<double>* half : {&drawn, &mean}) // the lower
                half->erase(half->begin(), half->begin() + static_cast<std::ptrdiff_t>(half->size() / 2));
            const double contrast = deviationOf(drawn) / deviationOf(mean);
            std::printf("%s, %u looks: %.3f white, %.3f of 16 samples; contrast %.3f of theirs\n",
                        downwind ? "downwind" : "across the wind", looks, meanOf(drawn), meanOf(mean),
                        contrast);
            EXPECT_GT(contrast, 0.9);
            EXPECT_LT(contrast, 1.1);
        }
}

// Between steps it glides: no picture differs from the one before by more than its share of a step.
TEST_F(WaterFoam, GlidesFromStepToStep) {
    Body* body = foamyBody();
    Camera camera = above();
    camera.width = 96;
    camera.height = 54;
    std::vector<double> changes;
    std::vector<float> last;
    for (int frame = 0; frame < 24; ++frame) {
        const WaterPicture p = picture({body}, camera, 60 + frame / 60.0, SurfaceOutput::foam);
        double change = 0;
        for (size_t i = 0; !last.empty() && i < p.color.size(); i += 4)
            change += std::abs(double{p.color[i]} - double{last[i]});
        if (!last.empty()) changes.push_back(change);
        last = p.color;
    }
    const double largest = *std::ranges::max_element(changes);
    std::ranges::sort(changes);
    EXPECT_GT(changes[changes.size() / 2], 0);
    // All of a step at once would be fifteen times a frame's share.
    EXPECT_LT(largest, 3 * changes[changes.size() / 2]);
}

TEST_F(WaterFoam, UploadsAtItsOwnRate) {
    Body* body = foamyBody();
    picture({body}, above(), 60);
    const auto uploads = [&](double time) {
        spiedCalls().clear();
        picture({body}, above(), time);
        return countSpied("CmdCopyBufferToImage");
    };
    const size_t without = uploads(60.01);
    EXPECT_EQ(uploads(60.2), without);
    EXPECT_EQ(uploads(60.26), without + 1);
    EXPECT_EQ(uploads(60.27), without);
}

TEST_F(WaterFoam, DispatchesAtItsOwnRate) {
    Body* body = foamyBody(WavesOn::gpu);
    picture({body}, above(), 60);
    const auto dispatches = [&](double time) {
        spiedCalls().clear();
        picture({body}, above(), time);
        return countSpied("CmdDispatch");
    };
    const size_t wavesAlone = dispatches(60.01);
    EXPECT_EQ(dispatches(60.2), wavesAlone);
    const size_t without = wavesAlone + onGpus(2); // foam's mips
    EXPECT_EQ(dispatches(60.26), without + 3);     // the waves once more, and a step
    EXPECT_EQ(dispatches(60.8), without + 6);
    EXPECT_LE(dispatches(1e6),
              without + 3 * static_cast<size_t>(fadingOf({}).foam.steps + fadingOf({}).plume.steps + 2));
}

TEST_F(Water, AFeatureThatIsOffIsNotThere) {
    Body* flat = flatBody();
    EXPECT_FALSE(flat->sea);
    EXPECT_FALSE(flat->find<WavesPart>());
    EXPECT_FALSE(flat->find<FoamPart>());
    EXPECT_FALSE(flat->find<ReflectionPart>());

    SeaDesc calm = breeze();
    calm.windSpeed = 0;
    BodyDesc desc;
    desc.waves = &calm;
    desc.wavesBackend = fftwWaves();
    Body* still = makeBody(desc);
    EXPECT_FALSE(still->find<WavesPart>());
    EXPECT_EQ(sea(still), nullptr);

    const FoamDesc foam;
    desc.foam = &foam;
    Body* stillFoam = makeBody(desc);
    calm.windSpeed = 1;
    for (Body* unbroken : {stillFoam, makeBody(desc)}) {
        EXPECT_FALSE(unbroken->find<FoamPart>());
    }

    ReflectionDesc sky;
    sky.technique = ReflectionTechnique::sky;
    BodyDesc skyOnly;
    skyOnly.reflection = &sky;
    EXPECT_FALSE(makeBody(skyOnly)->find<ReflectionPart>());
}

TEST_F(Water, AFlatPondCreatesAndRecordsNextToNothing) {
    // What a context makes once, each frame slot, and a body for the view.
    Body* pond = flatBody();
    for (int slot = 0; slot < 2; ++slot) picture({pond}, seaCamera());
    spiedCalls().clear();
    picture({pond}, seaCamera());
    EXPECT_EQ(countSpied("CreateImage"), 0u);
    EXPECT_EQ(countSpied("AllocateMemory"), 0u);
    EXPECT_EQ(countSpied("CreateComputePipelines"), 0u);
    EXPECT_EQ(countSpied("CmdCopyBufferToImage"), 0u);
    // It is found, its tiles are listed in three steps, shaded and placed.
    EXPECT_EQ(countSpied("CmdDrawIndexed"), 1u);
    EXPECT_EQ(countSpied("CmdDispatch"), 3u);
    EXPECT_EQ(countSpied("CmdDispatchIndirect"), 1u);
    EXPECT_EQ(countSpied("CmdDraw"), 1u);
    EXPECT_LE(countSpied("CmdPipelineBarrier2"), 9u);
}

TEST_F(Water, TheEstimateIsWhatIsAllocated) {
    makeBody({}); // what all bodies share
    const SeaDesc waves = breeze();
    const FoamDesc foam;
    const ReflectionDesc reflection;
    BodyDesc desc;
    const auto agrees = [&](const char* what) {
        Estimate estimated;
        ASSERT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::ok) << message();
        spiedCalls().clear();
        makeBody(desc);
        EXPECT_EQ(bytesSpied(), estimated.bytes) << what;
    };
    agrees("flat");
    desc.waves = &waves;
    desc.wavesBackend = fftwWaves();
    desc.wavesOn = WavesOn::cpu;
    agrees("waves");
    desc.wavesOn = WavesOn::gpu;
    agrees("waves by compute shaders");
    desc.foam = &foam;
    agrees("foam");

    Estimate estimated;
    desc.reflection = &reflection;
    ASSERT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::ok) << message();
    EXPECT_GE(estimated.bytesPerView, 320u * 180 * 14);
    EXPECT_EQ(estimate(context(), &desc, {0, 180}, &estimated), Status::invalidArgument);
    EXPECT_NE(message().find("extent"), std::string::npos);
}

TEST_F(Water, BadDescriptionsAreNamedAndLeaveNothing) {
    SeaDesc waves = breeze();
    FoamDesc foam;
    ReflectionDesc reflection;
    const auto refused = [&](auto&& spoil) {
        BodyDesc desc;
        spoil(desc);
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
        EXPECT_EQ(body, nullptr);
        return message();
    };
    const auto names = [](const std::string& text, const char* field) {
        return text.find(field) != std::string::npos;
    };
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.plane[1] = 0; }), "plane"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.plane[1] = -1; }), "plane"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) { d.foam = &foam; }), "foam"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          d.waves = &waves;
                          d.wavesOn = WavesOn::cpu;
                      }),
                      "wavesBackend"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.wavesOn = static_cast<WavesOn>(7); }), "wavesOn"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.mesh.cellSize = NAN; }), "cellSize"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.mesh.cellsPerLevel = 3; }), "cellsPerLevel"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.shading.waveShadowSteps = 1; }), "waveShadowSteps"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.shading.waveShadowSteps = 33; }), "waveShadowSteps"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          waves.samples = 100;
                          d.waves = &waves;
                          d.wavesBackend = fftwWaves();
                      }),
                      "samples"));
    for (const float bad : {-1.0f, NAN, INFINITY})
        for (int channel = 0; channel < 3; ++channel) {
            RefractionDesc refraction;
            refraction.absorption[channel] = bad;
            const auto useIt = [&](BodyDesc& d) { d.refraction = &refraction; };
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.absorption")) << bad << ' ' << channel;
            refraction = {};
            refraction.backscatter[channel] = bad;
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.backscatter")) << bad << ' ' << channel;
            refraction = {};
            refraction.scattering = bad;
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.scattering")) << bad;
        }
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          reflection.edgeFade = 2;
                          d.reflection = &reflection;
                      }),
                      "edgeFade"));
}

TEST_F(Water, DrawingBeforeSimulatingIsAnError) {
    Body* body = wavyBody(breeze());
    Target* target = nullptr;
    const TargetDesc desc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
    ASSERT_EQ(createTarget(context(), &desc, &target), Status::ok);
    const demos::Image color = uploadFloats(4, 4, 4, std::vector<float>(64));
    const demos::Image depth = uploadFloats(4, 4, 1, std::vector<float>(16));
    Camera camera = seaCamera();
    camera.width = camera.height = 4;
    ViewDesc view = viewDesc(camera);
    view.sceneColor = asSeaglass(color);
    view.sceneDepth = asSeaglass(depth);
    frame([&](VkCommandBuffer commands) {
        EXPECT_MISUSE(draw(commands, target, &body, 1, &view, &lighting), "was never called", message());
        EXPECT_EQ(simulate(commands, &body, 1, NAN), Status::invalidArgument);
    });
    destroyTarget(target);
}

TEST_F(Water, WithoutRefractionNeedsNoScene) {
    Body* opaque = wavyBody(breeze());
    const WaterPicture before = picture({opaque}, seaCamera());
    changeView = [](ViewDesc& view) { view.sceneColor = view.sceneDepth = {}; };
    EXPECT_EQ(picture({opaque}, seaCamera()).color, before.color);
}

/// A camera that cannot be drawn for, by a body without anything.
class WaterRefuses : public Water {
  protected:
    void expectRefused(Camera camera, Status status, const char* words) {
        const demos::Image color = uploadFloats(4, 4, 4, std::vector<float>(64));
        const demos::Image depth = uploadFloats(4, 4, 1, std::vector<float>(16));
        camera.width = camera.height = 4;
        ViewDesc view = viewDesc(camera);
        view.sceneColor = asSeaglass(color);
        view.sceneDepth = asSeaglass(depth);
        Target* target = nullptr;
        const TargetDesc targetDesc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
        ASSERT_EQ(createTarget(context(), &targetDesc, &target), Status::ok);
        Body* body = makeBody({});
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(draw(commands, target, &body, 1, &view, &lighting), status);
            EXPECT_NE(message().find(words), std::string::npos) << message();
        });
        destroyTarget(target);
    }
};

TEST_F(WaterRefuses, DepthThatRunsAgainstTheTarget) {
    Camera camera = seaCamera();
    camera.reversed = false;
    camera.far = 100;
    expectRefused(camera, Status::invalidArgument, "expected TargetDesc.reversedDepth to be false");
}

TEST_F(Water, BodiesMayGoWhileTheGpuUsesThem) {
    const SeaDesc waves = breeze();
    for (int i = 0; i < 4; ++i) {
        BodyDesc desc;
        desc.waves = &waves;
        desc.wavesBackend = fftwWaves();
        Body* body = nullptr;
        ASSERT_EQ(createBody(context(), &desc, &body), Status::ok) << message();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, i), Status::ok) << message();
            destroyBody(body); // recorded, not yet executed
        });
    }
}

} // namespace
