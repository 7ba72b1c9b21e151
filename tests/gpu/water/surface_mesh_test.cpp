// The surface's mesh as it is seen: from a millimetre to 100 km up at any roll, while levels take over from
// each other, and under jitter.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class SurfaceMesh : public WaterTest {
  protected:
    static Camera camera(double height) {
        Camera camera;
        camera.eye = {3, height, 7};
        camera.target = {3, 0.8 * height, 7 - 1.3 * height};
        camera.width = 240;
        camera.height = 135;
        return camera;
    }

    static SeaDesc breeze() {
        SeaDesc sea;
        sea.windSpeed = 8;
        sea.fetch = 50e3f;
        sea.samples = 128;
        sea.cascades = 3;
        return sea;
    }

    Body* wavyBody() {
        const SeaDesc sea = breeze();
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        return makeBody(desc);
    }
};

TEST_F(SurfaceMesh, CoversAllBelowTheHorizonFromAMillimetreTo100Km) {
    Body* body = makeBody({});
    for (const double height : {1e-3, 0.1, 300.0, 1e5})
        for (const double roll : {0.0, 33.0, 90.0, 180.0, 251.0}) {
            Camera c = camera(height);
            c.near = height * 0.05;
            c.target = c.eye + glm::dvec3(0.3, -0.5, -1);
            c.rollDegrees = roll;
            const WaterPicture p = picture({body}, c, 0, SurfaceOutput::height);
            size_t holes = 0, above = 0;
            for (uint32_t y = 0; y < p.height; ++y)
                for (uint32_t x = 0; x < p.width; ++x) {
                    const double angle = angleBelowHorizon(c, x, y);
                    const bool covered = p.covered(size_t{y} * p.width + x);
                    holes += angle > 0.003 && !covered;
                    above += angle < -1e-4 && covered;
                }
            EXPECT_EQ(holes, 0u) << "eye at " << height << " m, roll " << roll;
            EXPECT_LE(static_cast<double>(above), limitOnGrid(0, 3)) // where the horizon passes their centres
                << "eye at " << height << " m, roll " << roll;
        }
}

TEST_F(SurfaceMesh, WithWavesHasNoHolesFromFarUp) {
    Body* body = wavyBody();
    for (const double height : {3.0, 5000.0, 1e5})
        for (const double roll : {0.0, 120.0}) {
            Camera c = camera(height);
            c.rollDegrees = roll;
            const WaterPicture p = picture({body}, c, 5);
            for (uint32_t y = 0; y < p.height; ++y)
                for (uint32_t x = 0; x < p.width; ++x) {
                    const size_t pixel = size_t{y} * p.width + x;
                    if (angleBelowHorizon(c, x, y) < 0.03) continue;
                    ASSERT_TRUE(p.covered(pixel))
                        << x << " " << y << " from " << height << " m, roll " << roll;
                    ASSERT_TRUE(std::isfinite(p.color[pixel * 4]))
                        << x << " " << y << " from " << height << " m";
                }
        }
}

/// Mean difference of the surface's height between two pictures [m].
double change(const WaterPicture& a, const WaterPicture& b) {
    double sum = 0;
    for (size_t i = 0; i < a.depth.size(); ++i)
        sum += std::abs(double{a.color[i * 4]} - double{b.color[i * 4]});
    return sum / static_cast<double>(a.depth.size());
}

TEST_F(SurfaceMesh, LevelsTakeOverWithoutAJump) {
    // Straight down, where what is seen stays while the eye rises: past 32 m and 64 m, where levels end.
    Body* body = wavyBody();
    std::vector<double> changes;
    WaterPicture last;
    for (double height = 21; height < 70; height *= 1.02) {
        Camera c = camera(height);
        c.width = c.height = 96;
        c.target = c.eye - glm::dvec3(0, 1, 0);
        c.fovDegrees = 4;
        WaterPicture next = picture({body}, c, 5, SurfaceOutput::height);
        if (!last.depth.empty()) changes.push_back(change(last, next));
        last = std::move(next);
    }
    double worst = 0;
    for (size_t i = 1; i + 1 < changes.size(); ++i)
        worst = std::max(worst, changes[i] / std::max(changes[i - 1], changes[i + 1]));
    std::printf("steps change %.2f mm at most, %.2f times their neighbours\n",
                1e3 * *std::ranges::max_element(changes), worst);
    EXPECT_LT(worst, 2);
}

/// A pale bed 3 m down, and a wall of another colour that stands in the water 40 m away.
SceneBehind bedAndWall(const Camera& camera) {
    return drawnOver(camera, planeBelow(camera, -3, 1), 2, [&](const glm::dvec3& ray) {
        const double distance = (-40 - camera.eye.z) / ray.z, height = camera.eye.y + distance * ray.y;
        return height < -3 || height > 4 ? -1 : distance;
    });
}

class Jittered : public SurfaceMesh {
  protected:
    Jittered() {
        lighting.toSun[0] = 0;
        lighting.toSun[1] = std::sqrt(0.5f);
        lighting.toSun[2] = -std::sqrt(0.5f);
        for (float& irradiance : lighting.sunIrradiance) irradiance = 0.5f;
        for (float& irradiance : lighting.skyIrradiance) irradiance = 2;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
    }

    void expectTheMeanIsTheUnjittered(SceneBehind (*sceneOf)(const Camera&)) {
        Body* const body = makeBody(desc_);
        Camera c = camera(6);
        const WaterPicture still = picture({body}, c, 5, SurfaceOutput::shaded, sceneOf(c));
        std::vector<double> sum(still.color.size());
        std::vector<int> covered(still.depth.size());
        for (int i = 0; i < 16; ++i) {
            c.jitter = {(i % 4 + 0.5) / 4 - 0.5, (i / 4 + 0.5) / 4 - 0.5};
            const WaterPicture p = picture({body}, c, 5, SurfaceOutput::shaded, sceneOf(c));
            for (size_t k = 0; k < sum.size(); ++k) sum[k] += double{p.color[k]} / 16;
            for (size_t k = 0; k < covered.size(); ++k) covered[k] += p.covered(k);
        }
        // The sky's radiance is 3 in blue: as white as a picture gets.
        double total = 0;
        size_t count = 0;
        for (size_t i = 0; i < covered.size(); ++i) {
            if (covered[i] != 16 || !still.covered(i)) continue;
            for (size_t k = 0; k < 3; ++k)
                total += std::abs(sum[i * 4 + k] - double{still.color[i * 4 + k]}) / 3;
            count += 3;
        }
        const double mean = total / static_cast<double>(count);
        std::printf("mean difference %.2f / 255 over %zu values\n", mean * 255, count);
        EXPECT_GT(count, 30000u);
        EXPECT_LT(mean, 2.0 / 255);
    }

    const SeaDesc sea_ = breeze();
    BodyDesc desc_;
};

TEST_F(Jittered, SixteenFramesOfWavesAverageToTheUnjittered) {
    expectTheMeanIsTheUnjittered(nothingBehind);
}

TEST_F(Jittered, SixteenFramesOfFoamAverageToTheUnjittered) {
    const FoamDesc foam{.bias = 0.1f};
    desc_.foam = &foam;
    expectTheMeanIsTheUnjittered(nothingBehind);
}

TEST_F(Jittered, SixteenFramesOfABedAverageToTheUnjittered) {
    const RefractionDesc refraction = {{0.3f, 0.1f, 0.05f}, {0.01f, 0.01f, 0.01f}, 1};
    desc_.refraction = &refraction;
    expectTheMeanIsTheUnjittered(bedAndWall);
}

TEST_F(Jittered, SixteenFramesOfWhatIsMirroredAverageToTheUnjittered) {
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    expectTheMeanIsTheUnjittered(bedAndWall);
}

} // namespace
