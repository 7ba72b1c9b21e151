// The cube that a lat-long sky is filtered into.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/passes/sky_image.h"

namespace {

/// Each pixel differs from its neighbours.
demos::SkyImage speckled(uint32_t width) {
    demos::SkyImage sky{width, width / 2, {}};
    std::mt19937 random(7);
    for (uint32_t i = 0; i < width * width / 2; ++i)
        sky.radiance.push_back(glm::vec3(random() % 1000, random() % 1000, random() % 1000) / 1000.0f);
    return sky;
}

// Of what the image shows there, looked up direction by direction.
TEST(SkyCube, HoldsTheImagesMeansOnEachFace) {
    const demos::SkyImage sky = speckled(200);
    const double turned = 33, angle = glm::radians(-turned);
    const demos::SkyCube cube = demos::filterSky(sky, turned, 2).cube;
    const uint32_t size = cube.faceSize;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                glm::vec3 sum(0);
                for (uint32_t i = 0; i < 4; ++i) {
                    const glm::dvec3 d = glm::normalize(demos::faceDirection(
                        face, (2 * x + i % 2 + 0.5) / size - 1, (2 * y + i / 2 + 0.5) / size - 1));
                    sum += sampleSky(sky, {std::cos(angle) * d.x - std::sin(angle) * d.z, d.y,
                                           std::sin(angle) * d.x + std::cos(angle) * d.z});
                }
                const glm::vec3 held = cube.mips[0][(size_t(face) * size + y) * size + x];
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(held[c], sum[c] / 2, 2e-5f) << face << ": " << x << ", " << y;
            }
}

// A cube is as fine as its image, which is all that there is to show.
TEST(SkyCube, IsAsFineAsItsImage) {
    EXPECT_EQ(demos::filterSky(speckled(16), 0, 1).cube.faceSize, 64u);
    EXPECT_EQ(demos::filterSky(speckled(200), 0, 1).cube.faceSize, 128u);
    EXPECT_EQ(demos::filterSky(speckled(300), 0, 1).cube.faceSize, 256u);
    EXPECT_EQ(demos::filterSky(speckled(1026), 0, 1).cube.faceSize, 512u);
}

} // namespace
