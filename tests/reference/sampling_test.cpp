// Random samples: the same whoever draws them, and energy neither made nor lost.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/reference/box_world.h"
#include "tests/reference/traced_picture.h"

namespace {

using namespace demos;

WaterDesc waves() {
    WaterDesc water;
    water.waves = WavesDesc{};
    water.waves->samples = 64;
    water.waves->windMps = 9;
    water.foam.emplace();
    water.refraction = RefractionDesc{};
    return water;
}

Picture draw(const reference::World& world, const reference::FrameDesc& desc) {
    return tests::traced(world, desc).color;
}

reference::FrameDesc tiny(uint32_t samples) {
    reference::FrameDesc desc = tests::smallFrame();
    desc.width = 48;
    desc.height = 27;
    desc.samples = samples;
    return desc;
}

TEST(Sampling, TheSameBitsWithAnyNumberOfThreads) {
    reference::World world;
    Error error;
    SunDesc sun;
    sun.elevationDeg = 15;
    sun.azimuthDeg = 270;
    ASSERT_TRUE(
        reference::makeLight(tests::evenSky(glm::vec3(0.4f, 0.6f, 0.8f)), {}, sun, world.light, error));
    tests::addMesh("boxes", tests::shiningBoxes(tests::harbourOfBoxes(), glm::vec3(0.1f)), world);
    ASSERT_TRUE(reference::setWater(waves(), world, error)) << error.text;
    reference::FrameDesc desc = tiny(4);
    desc.threads = 1;
    const Picture one = draw(world, desc);
    for (const uint32_t threads : {2u, 5u}) {
        desc.threads = threads;
        EXPECT_TRUE(draw(world, desc).rgba == one.rgba) << threads << " threads";
    }
    desc.seed = 2;
    EXPECT_FALSE(draw(world, desc).rgba == one.rgba) << "another seed";
}

/// Under a sky of radiance 1 a mirror that loses nothing shows 1 everywhere: what is missing went into the
/// water.
TEST(Sampling, WavesMakeNoLight) {
    reference::World world;
    ASSERT_TRUE(tests::lightWorld(glm::vec3(1), world));
    Error error;
    WaterDesc water = waves();
    water.foam.reset();
    water.refraction.reset();
    ASSERT_TRUE(reference::setWater(water, world, error)) << error.text;
    for (const uint32_t samples : {1u, 16u}) {
        const Picture picture = draw(world, tiny(samples));
        for (size_t i = 0; i < picture.rgba.size(); ++i) {
            ASSERT_TRUE(std::isfinite(picture.rgba[i]));
            EXPECT_GE(picture.rgba[i], 0);
            EXPECT_LE(picture.rgba[i], 1.001f);
        }
    }
}

/// With the sun behind the eye, or well to the side, no wave mirrors it. A density that never quite falls to
/// nothing, or a lone sample that may count without bound, shows as sparks far brighter than the sky.
TEST(Sampling, NoSparksAwayFromTheSun) {
    reference::World world;
    Error error;
    for (const double azimuth : {90.0, 345.0, 310.0}) {
        SunDesc sun;
        sun.elevationDeg = azimuth == 310 ? 12 : 2;
        sun.azimuthDeg = azimuth;
        sun.irradiance = {8, 5, 2};
        ASSERT_TRUE(reference::makeLight(tests::evenSky(glm::vec3(0.5f)), {}, sun, world.light, error));
        WaterDesc water = waves();
        water.foam.reset();
        water.waves->windMps = 14;
        ASSERT_TRUE(reference::setWater(water, world, error)) << error.text;
        const Picture picture = draw(world, tiny(64));
        // The left third of the picture, where there is nothing brighter than the sky.
        float brightest = 0;
        for (size_t i = 0; i < picture.rgba.size(); i += 4)
            if (i / 4 % picture.width < picture.width / 3) brightest = std::max(brightest, picture.rgba[i]);
        EXPECT_LT(brightest, 2) << azimuth << " degrees";
    }
}

/// More samples approach a mean: two halves of them agree better than two quarters.
TEST(Sampling, Converges) {
    reference::World world;
    Error error;
    SunDesc sun;
    sun.elevationDeg = 30;
    sun.azimuthDeg = 270;
    ASSERT_TRUE(
        reference::makeLight(tests::evenSky(glm::vec3(0.4f, 0.6f, 0.8f)), {}, sun, world.light, error));
    ASSERT_TRUE(reference::setWater(waves(), world, error)) << error.text;
    const auto difference = [&](uint32_t samples) {
        reference::FrameDesc desc = tiny(samples);
        const Picture a = draw(world, desc);
        desc.seed = 99;
        const Picture b = draw(world, desc);
        double squares = 0;
        for (size_t i = 0; i < a.rgba.size(); ++i) {
            const auto d = static_cast<double>(a.rgba[i] - b.rgba[i]);
            squares += d * d;
        }
        return std::sqrt(squares / static_cast<double>(a.rgba.size()));
    };
    EXPECT_LT(difference(64), 0.6 * difference(8));
}

} // namespace
