// Water at a shore as it is drawn: that it stands where the height queries say, where it is white, and that a
// sea without a bed knows nothing of it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/spy.h"
#include "tests/gpu/water_rig.h"
#include "water/body.h"
#include "water/sea.h"

namespace {

using namespace seaglass;
using namespace tests;

class ShoreOnGpu : public WaterTest {
  protected:
    static constexpr double slope = 1.0 / 20;

    void SetUp() override {
        WaterTest::SetUp();
        shore_.samples[0] = 104; // whole rows of 64 bytes: no padding in memory
        shore_.samples[1] = 301;
        shore_.origin[0] = -52;
        shore_.origin[1] = -270;
        for (uint32_t j = 0; j < shore_.samples[1]; ++j)
            bed_.insert(bed_.end(), shore_.samples[0], static_cast<float>(slope * (shore_.origin[1] + j)));
        shore_.bed = bed_.data();
        sea_.windSpeed = 4;
        sea_.windDirection = static_cast<float>(std::numbers::pi / 2);
        sea_.fetch = 3e3f;
        sea_.swells[0] = {0.5f, 5.0f, sea_.windDirection, 0.1f, 50};
        sea_.samples = 128;
        sea_.shore = &shore_;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        desc_.mesh.cellSize = 0.1f;
    }

    /// Towards the water's edge from the sea.
    static Camera camera(double aside = 0) {
        Camera camera;
        camera.eye = {aside, 5, -24};
        camera.target = {0, 0, -8};
        camera.width = 320;
        camera.height = 180;
        return camera;
    }

    std::vector<float> bed_;
    ShoreDesc shore_;
    SeaDesc sea_;
    FoamDesc foam_;
    BodyDesc desc_;
};

TEST_F(ShoreOnGpu, TheSurfaceStandsWhereHeightQueriesSay) {
    Body* body = makeBody(desc_);
    const double time = 31.4;
    const WaterPicture p = picture({body}, camera(), time, SurfaceOutput::height);
    std::vector<double> points, drawn;
    for (uint32_t y = 0; y < p.height; y += 5)
        for (uint32_t x = 0; x < p.width; x += 11) {
            if (!p.covered(size_t{y} * p.width + x)) continue;
            const glm::dvec3 world = worldAt(camera(), p, x, y);
            // What lies on the sand as a film is not water's height.
            if (glm::length(world - camera().eye) > 22 || world.y < slope * world.z + 0.06) continue;
            points.insert(points.end(), {world.x, world.z});
            drawn.push_back(world.y);
        }
    ASSERT_GT(drawn.size(), 200u);
    std::vector<HeightSample> samples(drawn.size());
    sampleHeights(*sea(body), time, points.data(), samples.size(), samples.data());
    double worst = 0, highest = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
        worst = std::max(worst, std::abs(drawn[i] - double{samples[i].height}));
        highest = std::max(highest, drawn[i]);
    }
    std::printf("worst difference %.4f m, highest wave %.2f m\n", worst, highest);
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(highest, 0.1);
}

TEST_F(ShoreOnGpu, FoamIsWhereTheWaterThinsAndNotWhereItIsDeep) {
    desc_.foam = &foam_;
    Body* body = makeBody(desc_);
    const auto foamAt = [&](const Camera& seenBy, double from, double to) {
        const WaterPicture p = picture({body}, seenBy, 40, SurfaceOutput::foam);
        double sum = 0, count = 0;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(seenBy, p, x, y);
                if (world.z < from || world.z > to || std::abs(world.x) > 12) continue;
                sum += double{p.color[4 * i]};
                ++count;
            }
        EXPECT_GT(count, 200) << from;
        return sum / count;
    };
    const double surf = foamAt(camera(), -16, -2);
    Camera offshore = camera();
    offshore.eye.z = -214;
    offshore.target.z = -200;
    const double deep = foamAt(offshore, -206, -190);
    std::printf("cover in the surf %.3f, 10 m deep %.4f\n", surf, deep);
    EXPECT_GT(surf, 0.1);
    EXPECT_LT(deep, 0.005);
    // It lies on the water, whoever looks at it.
    EXPECT_NEAR(foamAt(camera(3), -16, -2), surf, 0.03);
}

// The mirror's plane lies in the sand there.
TEST_F(ShoreOnGpu, WaterOnTheSandMirrorsTheSkyAndNotTheSand) {
    Body* const ofSkyAlone = makeBody(desc_);
    const ReflectionDesc reflection;
    desc_.reflection = &reflection;
    Body* const body = makeBody(desc_);
    const Camera seenBy = camera();
    SceneBehind black = planeBelow(seenBy, 0, 0);
    for (uint32_t y = 0; y < seenBy.height; ++y)
        for (uint32_t x = 0; x < seenBy.width; ++x) {
            const glm::dvec3 ray = rayThrough(seenBy, x, y);
            const double distance = (slope * seenBy.eye.z - seenBy.eye.y) / (ray.y - slope * ray.z);
            const double along = distance * glm::dot(ray, glm::normalize(seenBy.target - seenBy.eye));
            black.depth[size_t{y} * seenBy.width + x] =
                distance > 0 ? static_cast<float>(seenBy.near / along) : 0;
        }
    double sum = 0, ofSky = 0, count = 0;
    for (const double time : {30.0, 33.0, 36.0}) {
        const auto mirrored = [&](Body* of) {
            return picture({of}, seenBy, time, SurfaceOutput::reflection, black);
        };
        const WaterPicture p = mirrored(body), sky = mirrored(ofSkyAlone);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(seenBy, p, x, y);
                if (world.y < 0.05 || world.y > slope * world.z + 0.1) continue;
                sum += double{p.color[4 * i]};
                ofSky += double{sky.color[4 * i]};
                ++count;
            }
    }
    std::printf("of the sky's light %.3f\n", sum / ofSky);
    EXPECT_GT(count, 500);
    EXPECT_GT(sum, 0.75 * ofSky); // 0.3 with the sand
}

TEST_F(ShoreOnGpu, ASeaWithoutABedHasNothingOfIt) {
    desc_.foam = &foam_;
    const auto costs = [&](const ShoreDesc* shore, size_t& images, Estimate& estimated) {
        sea_.shore = shore;
        EXPECT_EQ(estimate(context(), &desc_, {320, 180}, &estimated), Status::ok) << message();
        spiedCalls().clear();
        Body* const body = makeBody(desc_);
        images = countSpied("CreateImage");
        EXPECT_GE(bytesSpied(), estimated.bytes);
        EXPECT_LE(bytesSpied(), estimated.bytes + (4u << 10) * countSpied("AllocateMemory"));
        EXPECT_EQ(body->shore.has_value(), shore != nullptr);
        EXPECT_EQ(sea(body)->shore.has_value(), shore != nullptr);
    };
    makeBody({}); // what all bodies share
    size_t with = 0, without = 0;
    Estimate dear, cheap;
    costs(&shore_, with, dear);
    costs(nullptr, without, cheap);
    EXPECT_EQ(with, without + 1);
    EXPECT_EQ(dear.bytes - cheap.bytes, 2u * 104 * 301 * 48);
}

} // namespace
