// Where the drawn surface is: it covers the sea, stands where height queries say, and is the same far away.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/sea_rig.h"
#include "water/body/body.h"
#include "water/interface/waves_backend.h"
#include "water/waves/waves_part.h"

namespace {

using namespace seaglass;
using namespace tests;

class Water : public SeaTest {};

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

// Two of 700 views in which one did, where patches had their shared vertices in places of their own, an ulp
// apart.
TEST_F(Water, NoPixelFallsBetweenPatches) {
    SeaDesc rough = breeze();
    rough.windSpeed = 12;
    Body* body = wavyBody(rough);
    for (const int n : {184, 458}) {
        Camera camera = seaCamera();
        camera.eye = {1234.567 * n + 0.123 * n * n, 2.0 + 0.35 * (n % 60), -777.77 * n};
        camera.target = camera.eye + glm::dvec3(std::sin(n), -0.35, std::cos(n));
        camera.rollDegrees = 7 * n;
        const WaterPicture p = picture({body}, camera, 5, SurfaceOutput::height);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x)
                EXPECT_TRUE(angleBelowHorizon(camera, x, y) <= 0.05 || p.covered(size_t{y} * p.width + x))
                    << n << ": " << x << ", " << y;
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

} // namespace
