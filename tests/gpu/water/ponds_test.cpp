// Water at several heights and tilts in one view: two ponds, and the channel that runs down from one to the
// other.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double fall = 2, run = 8; ///< of the channel, from z = -8 to 0

/// Two hollows in the grass, and a ditch between them.
double groundAt(double x, double z) {
    const double upper = std::clamp(std::max(std::abs(x) - 4, std::abs(z + 12) - 4), -1.1, 0.25);
    const double lower = std::clamp(std::max(std::abs(x) - 5, std::abs(z - 5) - 5), -1.2, 0.25);
    const double slope = fall * std::clamp(-z / run, 0.0, 1.0);
    const double ditch = slope + std::clamp(2 * (std::abs(x) - 1), -0.5, 0.25);
    if (z < -run) return z > -run - 1 ? std::min(fall + upper, ditch) : fall + upper;
    if (z > 0) return z < 1 ? std::min(lower, ditch) : lower;
    return ditch;
}

/// A rectangle of a plane that does not lean along x.
struct Water {
    glm::dvec3 normal;
    double d;
    double uLow, uHigh, vLow, vHigh; ///< what is covered of it

    double heightOf(const glm::dvec3& p) const { return glm::dot(normal, p) + d; }
    /// Of a point of the plane, by (u, v) as seaglass/sea.h has them.
    bool contains(const glm::dvec3& p, double margin) const {
        const double v = p.z - normal.z * (p.y - d) / (1 + normal.y);
        return p.x > uLow + margin && p.x < uHigh - margin && v > vLow + margin && v < vHigh - margin;
    }
};

const double steepness = std::hypot(fall, run);
const Water waters[] = {
    {{0, 1, 0}, -fall, -4, 4, -16, -8},
    {{0, run / steepness, fall / steepness}, 0, -1, 1, -steepness, 0.5},
    {{0, 1, 0}, 0, -5, 5, 0, 10},
};

class Ponds : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        camera_.eye = {6, 5, 7};
        camera_.target = {0.4, 0, -4};
        camera_.width = 320;
        camera_.height = 180;
        const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.5, 0.5, -0.55));
        for (int i = 0; i < 3; ++i) {
            lighting.toSun[i] = sun[i];
            lighting.sunIrradiance[i] = 2;
            lighting.skyIrradiance[i] = 3;
        }
        for (const Water& water : waters) bodies_.push_back(make(water));
    }

    Body* make(const Water& water) {
        BodyDesc desc;
        for (int i = 0; i < 3; ++i) desc.plane[i] = water.normal[i];
        desc.plane[3] = water.d;
        desc.extent.shape = ExtentShape::rectangle;
        desc.extent.center[0] = (water.uLow + water.uHigh) / 2;
        desc.extent.center[1] = (water.vLow + water.vHigh) / 2;
        desc.extent.size[0] = water.uHigh - water.uLow;
        desc.extent.size[1] = water.vHigh - water.vLow;
        SeaDesc sea;
        sea.windSpeed = 4;
        sea.windDirection = 1.5f;
        sea.fetch = 100;
        sea.samples = 64;
        sea.amplitude = water.normal.z > 0 ? 1.0f : 0.5f;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.refraction = &refraction_;
        desc.reflection = &reflection_;
        desc.mesh.cellSize = 0.1f;
        return makeBody(desc);
    }

    /// Grass, and soil under it.
    SceneBehind ground() const {
        SceneBehind behind;
        const glm::dvec3 forward = glm::normalize(camera_.target - camera_.eye);
        for (uint32_t y = 0; y < camera_.height; ++y)
            for (uint32_t x = 0; x < camera_.width; ++x) {
                const glm::dvec3 ray = rayThrough(camera_, x, y);
                double t = 0.5;
                const auto above = [&] {
                    const glm::dvec3 p = camera_.eye + t * ray;
                    return p.y - groundAt(p.x, p.z);
                };
                while (t < 60 && above() > 0) t += 0.02;
                const bool met = t < 60;
                const glm::dvec3 p = camera_.eye + t * ray;
                const float wet = std::clamp(
                    static_cast<float>(groundAt(p.x, p.z) - fall * std::clamp(-p.z / run, 0.0, 1.0)) * 6,
                    0.0f, 1.0f);
                const auto pebble = static_cast<float>(0.9 + 0.1 * std::sin(7 * p.x + std::sin(5 * p.z)) *
                                                                 std::sin(6 * p.z + std::sin(4 * p.x)));
                behind.depth.push_back(met ? static_cast<float>(camera_.near / (t * glm::dot(ray, forward)))
                                           : 0);
                const glm::vec3 color =
                    met ? pebble * glm::mix(glm::vec3(0.5f, 0.42f, 0.3f), glm::vec3(0.25f, 0.45f, 0.12f), wet)
                        : glm::vec3(1, 2, 3);
                behind.color.insert(behind.color.end(), {color.x, color.y, color.z, 1});
            }
        return behind;
    }

    Camera camera_;
    RefractionDesc refraction_{{0.5f, 0.2f, 0.15f}, {0.003f, 0.006f, 0.006f}, 1};
    ReflectionDesc reflection_;
    std::vector<Body*> bodies_;
};

TEST_F(Ponds, ShowTheSameInWhateverOrderTheyAreDrawn) {
    const SceneBehind behind = ground();
    std::vector<size_t> order = {0, 1, 2};
    const WaterPicture first =
        picture({bodies_[0], bodies_[1], bodies_[2]}, camera_, 2, SurfaceOutput::shaded, behind);
    while (std::ranges::next_permutation(order).found) {
        const WaterPicture p = picture({bodies_[order[0]], bodies_[order[1]], bodies_[order[2]]}, camera_, 2,
                                       SurfaceOutput::shaded, behind);
        EXPECT_EQ(p.depth, first.depth);
        EXPECT_EQ(p.color, first.color);
    }
}

TEST_F(Ponds, AreSeenWhereTheyLie) {
    const WaterPicture p = picture(bodies_, camera_, 2);
    size_t seen[std::size(waters)] = {};
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera_, x, y);
            double nearest = 1e9;
            size_t expected = std::size(waters);
            bool beside = false;
            for (size_t i = 0; i < std::size(waters); ++i) {
                const double t = -waters[i].heightOf(camera_.eye) / glm::dot(waters[i].normal, ray);
                if (!(t > 0)) continue;
                const glm::dvec3 at = camera_.eye + t * ray;
                beside = beside || waters[i].contains(at, 0.2) != waters[i].contains(at, -0.2);
                if (!waters[i].contains(at, 0) || t > nearest) continue;
                nearest = t;
                expected = i;
            }
            if (beside) continue;
            const size_t pixel = size_t{y} * p.width + x;
            ASSERT_EQ(p.covered(pixel), expected < std::size(waters)) << x << ' ' << y;
            if (!p.covered(pixel)) continue;
            EXPECT_NEAR(waters[expected].heightOf(worldAt(camera_, p, x, y)), 0, 0.06) << x << ' ' << y;
            ++seen[expected];
        }
    std::printf("pixels of the upper pond %zu, the channel %zu, the lower %zu\n", seen[0], seen[1], seen[2]);
    for (const size_t pixels : seen) EXPECT_GT(pixels, 200u);
}

} // namespace
