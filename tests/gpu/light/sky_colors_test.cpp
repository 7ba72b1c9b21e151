// A sky of three colours against a cube that holds the same.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include <glm/ext/matrix_transform.hpp>

#include "host/passes/sky_image.h"
#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/cube_edges.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/light/sky_colors.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr uint32_t cubeSize = 256, cubeMips = 9;

glm::dvec3 radianceOf(const LightingDesc& light, const glm::dvec3& along) {
    float radiance[3];
    skyRadiance(light, {along.x, along.y, along.z}, radiance);
    return {radiance[0], radiance[1], radiance[2]};
}

/// Around a direction, over a Gaussian [rad].
glm::dvec3 blurred(const LightingDesc& light, const glm::dvec3& along, double deviation) {
    // The means of seven equal shares.
    constexpr double shares[] = {-1.579, -0.806, -0.370, 0, 0.370, 0.806, 1.579};
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0.31, 0.57, -0.76), along));
    const glm::dvec3 v = glm::cross(along, u);
    glm::dvec3 sum(0);
    for (const double a : shares)
        for (const double b : shares)
            sum += radianceOf(light, glm::normalize(along + deviation * 1.033 * (a * u + b * v)));
    return sum / 49.0;
}

/// Each mip spreads by 0.65 of its texels' width, of which what reads it between them makes 0.41.
demos::Image cubeOf(const LightingDesc& light) {
    std::vector<std::vector<float>> levels(cubeMips);
    for (uint32_t mip = 0; mip < cubeMips; ++mip) {
        const uint32_t size = cubeSize >> mip;
        for (uint32_t face = 0; face < 6; ++face)
            for (uint32_t y = 0; y < size; ++y)
                for (uint32_t x = 0; x < size; ++x) {
                    const glm::dvec3 at =
                        demos::faceDirection(face, (x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1);
                    const double width = 2 / glm::length(at) / size;
                    const glm::dvec3 radiance = mip == 0 ? radianceOf(light, glm::normalize(at))
                                                         : blurred(light, glm::normalize(at), 0.506 * width);
                    for (int i = 0; i < 3; ++i) levels[mip].push_back(static_cast<float>(radiance[i]));
                    levels[mip].push_back(1);
                }
    }
    std::vector<std::span<const std::byte>> bytes;
    for (const std::vector<float>& level : levels) bytes.push_back(std::as_bytes(std::span(level)));
    demos::ImageDesc desc;
    desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    desc.extent = {cubeSize, cubeSize};
    desc.cube = true;
    desc.mips = cubeMips;
    demos::Image cube;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device(), desc, bytes, cube, error)) << error.text;
    copyEdges(device(), cube);
    return cube;
}

LightingDesc coloredSky() {
    LightingDesc light;
    const float zenith[3] = {0.2f, 0.5f, 1.2f}, horizon[3] = {1.5f, 1.2f, 0.8f}, ground[3] = {0.3f, 0.1f, 0};
    std::memcpy(light.skyZenith, zenith, sizeof zenith);
    std::memcpy(light.skyHorizon, horizon, sizeof horizon);
    std::memcpy(light.skyGround, ground, sizeof ground);
    return light;
}

/// By a sum over the whole sphere.
glm::dvec3 summedIrradiance(const LightingDesc& light, const glm::dvec3& normal) {
    constexpr int steps = 400;
    glm::dvec3 sum(0);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double y = 2 * (i + 0.5) / steps - 1, angle = 2 * std::numbers::pi * (j + 0.5) / steps;
            const double level = std::sqrt(1 - y * y);
            const glm::dvec3 along(level * std::cos(angle), y, level * std::sin(angle));
            sum += std::max(glm::dot(along, normal), 0.0) * radianceOf(light, along);
        }
    return sum * (4 * std::numbers::pi / (steps * steps));
}

TEST(SkyColors, IrradianceIsThatOfTheirRadiance) {
    const LightingDesc light = coloredSky();
    for (const glm::dvec3& normal : {glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(0.3, 0.9, -0.2)),
                                     glm::normalize(glm::dvec3(-1, 0.3, 0.5))}) {
        const glm::dvec3 truth = summedIrradiance(light, normal), found = skyIrradiance(light, normal);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / truth[i], 1, 0.003) << i;
    }
    LightingDesc told = light;
    told.skyIrradiance[1] = 7;
    EXPECT_EQ(skyIrradiance(told, {0, 1, 0}), glm::dvec3(0, 7, 0));
}

class SkyOfColors : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        colors_ = coloredSky();
        colors_.toSun[0] = 0.6;
        colors_.toSun[1] = 0.8;
        useGround(false);
        camera_.eye = {3, 4, 7};
        camera_.target = {3, 2, -3};
    }

    /// Both hosts' pictures: the worst pixel, the worst mean of a column and a row of 16, over the mean.
    struct Difference {
        double worst = 0, inMean = 0;
    };
    Difference difference(const BodyDesc& desc, const SceneBehind& behind = {}) {
        Body* const body = makeBody(desc);
        lighting = colors_;
        const WaterPicture colored = picture({body}, camera_, 5, SurfaceOutput::shaded, behind);
        lighting.skyCube = cube_.view.get();
        lighting.skyCubeMipLevels = cubeMips;
        const glm::dvec3 up = glm::normalize(glm::dvec3(desc.plane[0], desc.plane[1], desc.plane[2]));
        const glm::dvec3 irradiance = summedIrradiance(colors_, up);
        for (int i = 0; i < 3; ++i) lighting.skyIrradiance[i] = static_cast<float>(irradiance[i]);
        const WaterPicture baked = picture({body}, camera_, 5, SurfaceOutput::shaded, behind);
        double worst = 0, sum = 0, apart = 0;
        size_t count = 0;
        for (size_t i = 0; i < baked.color.size(); ++i) {
            if (i % 4 == 3 || !baked.covered(i / 4)) continue;
            const double d = double{colored.color[i]} - double{baked.color[i]};
            worst = std::max(worst, std::abs(d));
            apart += d;
            sum += double{baked.color[i]};
            ++count;
        }
        EXPECT_GT(count, 30000u);
        const double mean = sum / static_cast<double>(count);
        std::printf("worst %.4f, mean %.4f of %.3f\n", worst / mean, apart / sum, mean);
        return {worst / mean, std::abs(apart / sum)};
    }

    /// Cubes blur the ground into what rough water mirrors, colours do not: to compare them, level water is
    /// over a ground as bright as the horizon.
    void useGround(bool own) {
        colors_.skyGround[0] = own ? 0.3f : colors_.skyHorizon[0];
        colors_.skyGround[1] = own ? 0.1f : colors_.skyHorizon[1];
        colors_.skyGround[2] = own ? 0.0f : colors_.skyHorizon[2];
        cube_ = cubeOf(colors_);
    }

    LightingDesc colors_;
    demos::Image cube_;
    Camera camera_;
    RefractionDesc refraction_;
};

TEST_F(SkyOfColors, StillWaterMirrorsThemAsItDoesTheirCube) {
    BodyDesc desc;
    desc.refraction = &refraction_;
    const Difference d = difference(desc);
    EXPECT_LT(d.worst, 0.01);
    EXPECT_LT(d.inMean, 0.002);
}

TEST_F(SkyOfColors, RoughWaterBlursThemAsItDoesTheirCube) {
    refraction_.scattering = 0.1f;
    for (const float wind : {3.0f, 8.0f, 17.0f}) {
        SeaDesc sea = breeze();
        sea.windSpeed = wind;
        const FoamDesc foam;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.refraction = &refraction_;
        desc.foam = &foam;
        const Difference d = difference(desc);
        EXPECT_LT(d.worst, 0.08) << wind;
        EXPECT_LT(d.inMean, 0.008) << wind;
    }
}

TEST_F(SkyOfColors, ACubeIsBlurredByTheMipsThatItHas) {
    SeaDesc sea = breeze();
    sea.windSpeed = 12;
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    Body* const body = makeBody(desc);
    camera_.width = 96;
    camera_.height = 64;
    lighting = colors_;
    lighting.skyCube = cube_.view.get();
    lighting.skyCubeMipLevels = cubeMips;
    const WaterPicture told = picture({body}, camera_, 5);
    lighting.skyCubeMipLevels = cubeMips + 4;
    EXPECT_EQ(picture({body}, camera_, 5).color, told.color) << "a host that says more";
    lighting.skyCubeMipLevels = cubeMips - 4;
    EXPECT_NE(picture({body}, camera_, 5).color, told.color) << "nothing here looks mips up";
}

TEST_F(SkyOfColors, TiltedWaterSeesThemAsTheWorldHasThem) {
    BodyDesc desc;
    desc.refraction = &refraction_;
    desc.plane[0] = 0.3;
    desc.plane[2] = 0.2;
    useGround(true);
    const Difference d = difference(desc);
    EXPECT_LT(d.worst, 0.05); // a texel at the edge of the ground
    EXPECT_LT(d.inMean, 0.002);
}

TEST_F(SkyOfColors, LevelWaterMirrorsNoGround) {
    const SeaDesc sea = breeze();
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    Body* const body = makeBody(desc);
    lighting = colors_;
    const WaterPicture bright = picture({body}, camera_, 5);
    for (float& channel : lighting.skyGround) channel = 100;
    EXPECT_EQ(picture({body}, camera_, 5).color, bright.color);
}

TEST_F(SkyOfColors, ShineIntoTheWaterAsTheirCubeDoes) {
    const SeaDesc sea = breeze();
    const UnderwaterDesc underwater;
    BodyDesc desc;
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    desc.refraction = &refraction_;
    desc.underwater = &underwater;
    camera_.eye = {3, -5, 7};
    camera_.target = {3, 0, 2};
    const Difference d = difference(desc);
    EXPECT_LT(d.worst, 0.05);
    EXPECT_LT(d.inMean, 0.005);
}

// Not even a flat body, of which nothing is recorded before, wants a cube.
TEST_F(SkyOfColors, NoShaderCouldReadACube) {
    useOwnContext();
    BodyDesc desc;
    Body* const body = makeBody(desc);
    lighting = colors_;
    beforeReflection = [](VkCommandBuffer) { spiedCalls().clear(); };
    picture({body}, camera_);
    size_t pipelines = 0;
    for (const SpiedCall& call : spiedCalls())
        if (!call.stages.empty()) {
            ++pipelines;
            const std::vector<uint32_t>& words = call.stages.back().spirv;
            // OpDecorate of Binding 2
            const uint32_t binding[] = {4u << 16 | 71u, 33, 2};
            for (size_t i = 0; i + 3 < words.size(); ++i)
                EXPECT_FALSE(words[i] == binding[0] && words[i + 2] == binding[1] &&
                             words[i + 3] == binding[2]);
        }
    EXPECT_EQ(pipelines, 6u) << "it is found, listed in three steps, shaded and placed";
}

} // namespace
