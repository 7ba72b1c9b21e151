// Motion vectors: where the last frame showed the water that a pixel shows now, by exact cameras and by the
// velocities that height queries give.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

glm::dvec2 pixelOf(const Camera& camera, const glm::dvec3& world) {
    const glm::dvec4 clip = projectionMatrix(camera) * viewMatrix(camera) * glm::dvec4(world, 1);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(camera.width, camera.height);
}

class Motion : public WaterTest {
  protected:
    Motion() {
        camera_.eye = {3, 4, 7};
        camera_.target = {3, 2, -3};
        sea_.windSpeed = 8;
        sea_.fetch = 20e3f;
        sea_.samples = 128;
        desc_.motion = true;
    }
    void addWaves() {
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
    }
    WaterPicture motion(Body* body, const Camera& camera, double time) {
        return picture({body}, camera, time, SurfaceOutput::motion);
    }
    template<typename Check>
    void forEachNear(const WaterPicture& p, const Camera& camera, Check&& check) {
        size_t seen = 0;
        for (uint32_t y = 5; y < p.height; y += 9)
            for (uint32_t x = 5; x < p.width; x += 11) {
                const size_t i = size_t{y} * p.width + x;
                if (!p.covered(i)) continue;
                const glm::dvec3 world = worldAt(camera, p, x, y);
                if (glm::length(world - camera.eye) > 25) continue;
                check(glm::dvec2(x + 0.5, y + 0.5), world, glm::dvec2(p.color[i * 4], p.color[i * 4 + 1]));
                ++seen;
            }
        EXPECT_GT(seen, 100u);
    }

    Camera camera_;
    SeaDesc sea_;
    BodyDesc desc_;
};

/// By the camera's own, and by parallel lines of sight.
class StillMotion : public Motion, public testing::WithParamInterface<double> {};

// A vertex that is snapped to sixteenths of a pixel moves by half the diagonal of such a square at most
// [pixels].
constexpr double halfOfCoarse = 0.0442;

TEST_P(StillMotion, IsTheCameras) {
    camera_.parallelHeight = GetParam();
    camera_.far = GetParam() > 0 ? 100 : 0;
    Body* const body = makeBody(desc_);
    const WaterPicture first = motion(body, camera_, 0);
    forEachNear(first, camera_, [](const glm::dvec2&, const glm::dvec3&, const glm::dvec2& moved) {
        EXPECT_NEAR(glm::length(moved), 0, limitOnGrid(limitOnDriver(1e-3, 3e-3), halfOfCoarse));
    });
    Camera next = camera_;
    next.eye += glm::dvec3(0.3, -0.1, -0.2);
    next.rollDegrees = 3;
    const WaterPicture second = motion(body, next, 0);
    forEachNear(second, next, [&](const glm::dvec2& pixel, const glm::dvec3& world, const glm::dvec2& moved) {
        EXPECT_NEAR(glm::length(pixel - pixelOf(camera_, world) - moved), 0,
                    limitOnGrid(0.02, 2 * halfOfCoarse));
    });
}
INSTANTIATE_TEST_SUITE_P(, StillMotion, testing::Values(0.0, 8.0), [](const auto& test) {
    return std::string(test.param > 0 ? "ByParallelLines" : "ByPerspective");
});

// The waves' mesh sinks as the globe's surface does, now as before.
TEST_F(Motion, OfAGlobeThatStandsStillIsNone) {
    sea_.amplitude = 0.01f;
    addWaves();
    desc_.extent.planetRadius = 1e6; // it has sunk by metres where it is still seen
    camera_.eye = {3, 30, 7};
    camera_.target = {3, 24, -93};
    Body* const body = makeBody(desc_);
    motion(body, camera_, 20);
    const WaterPicture p = motion(body, camera_, 20);
    double most = 0;
    size_t seen = 0;
    for (size_t i = 0; i < p.color.size() / 4; ++i) {
        if (!p.covered(i)) continue;
        most = std::max(most, std::hypot(double{p.color[4 * i]}, double{p.color[4 * i + 1]}));
        ++seen;
    }
    std::printf("%.4f pixels at most\n", most);
    EXPECT_GT(seen, 1000u);
    EXPECT_LT(most, 0.1);
}

TEST_F(Motion, OfWavesIsTheirWaters) {
    sea_.cascades = 1; // longer than the mesh's cells
    sea_.largestPatch = 200;
    addWaves();
    Body* const body = makeBody(desc_);
    const double before = 20, now = 20.1;
    motion(body, camera_, before);
    const WaterPicture p = motion(body, camera_, now);
    double worst = 0, greatest = 0;
    forEachNear(p, camera_, [&](const glm::dvec2& pixel, const glm::dvec3& world, const glm::dvec2& moved) {
        const double point[] = {world.x, world.z};
        HeightSample sample;
        sampleHeights(*sea(body), (before + now) / 2, point, 1, &sample);
        const glm::dvec3 velocity(sample.velocity[0], sample.velocity[1], sample.velocity[2]);
        const glm::dvec2 expected = pixel - pixelOf(camera_, world - velocity * (now - before));
        worst = std::max(worst, glm::length(moved - expected));
        greatest = std::max(greatest, glm::length(expected));
    });
    std::printf("motion up to %.2f pixels, off by %.3f at most\n", greatest, worst);
    EXPECT_GT(greatest, 1);
    EXPECT_LT(worst, 0.15 * greatest); // the height queries' sea is not linear between samples
}

TEST_F(Motion, LeavesJitterOutAndBeginsAnewAfterACut) {
    Body* const body = makeBody(desc_);
    // Fused multiply-adds round pixels' places differently, and a coarse grid moves them.
    const double most = limitOnGrid(limitOnDriver(2e-3, 3e-3), halfOfCoarse);
    Camera jittered = camera_;
    changeView = [&](ViewDesc& view) { view.jitter[0] = view.jitter[1] = 0; };
    motion(body, camera_, 0);
    jittered.jitter = {0.4, -0.3};
    changeView = [&](ViewDesc& view) {
        view.jitter[0] = jittered.jitter.x;
        view.jitter[1] = jittered.jitter.y;
    };
    forEachNear(motion(body, jittered, 0), jittered,
                [&](const glm::dvec2&, const glm::dvec3&, const glm::dvec2& moved) {
                    EXPECT_NEAR(glm::length(moved), 0, most);
                });
    Camera far = camera_;
    far.eye.x += 2;
    far.target.x += 2;
    changeView = [](ViewDesc& view) { view.cut = true; };
    forEachNear(motion(body, far, 0), far,
                [&](const glm::dvec2&, const glm::dvec3&, const glm::dvec2& moved) {
                    EXPECT_NEAR(glm::length(moved), 0, most);
                });
}

TEST_F(Motion, IsNoneOfWhatWasBehindTheEye) {
    Body* const body = makeBody(desc_);
    motion(body, camera_, 0);
    Camera turned = camera_;
    turned.target = 2.0 * turned.eye - turned.target;
    turned.target.y = camera_.target.y;
    forEachNear(motion(body, turned, 0), turned,
                [&](const glm::dvec2&, const glm::dvec3& world, const glm::dvec2& moved) {
                    EXPECT_EQ(moved, glm::dvec2(0)) << world.x << ' ' << world.z;
                });
}

TEST_F(Motion, CostsAMapOfWavesWhereItIsAskedForAlone) {
    makeBody({}); // what all bodies share
    addWaves();
    const auto cost = [&](bool motion) {
        desc_.motion = motion;
        desc_.wavesOn = WavesOn::cpu;
        Estimate estimated;
        EXPECT_EQ(estimate(context(), &desc_, {64, 64}, &estimated), Status::ok);
        spiedCalls().clear();
        makeBody(desc_);
        EXPECT_EQ(bytesSpied(), estimated.bytes);
        return std::pair(estimated.bytes, countSpied("CreateImage"));
    };
    const auto off = cost(false), on = cost(true);
    EXPECT_EQ(on.second, off.second + 1);
    uint64_t map = 0;
    for (uint32_t size = sea_.samples; size > 0; size /= 2) map += uint64_t{16} * size * size * sea_.cascades;
    EXPECT_GE(on.first - off.first, map);
}

TEST_F(Motion, OfWavesIsRefusedWhereTheyAreNotKept) {
    addWaves();
    desc_.motion = false;
    Body* const body = makeBody(desc_);
    beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& view) {
        EXPECT_EQ(shade(commands, &body, 1, &view, &lighting, SurfaceOutput::motion),
                  Status::invalidArgument);
        return Status::ok;
    };
    drawing = [](VkCommandBuffer, Target*, const ViewDesc&) { return Status::ok; };
    picture({body}, camera_);
    EXPECT_NE(message().find("BodyDesc.motion"), std::string::npos) << message();
}

/// Beside them, since a target too says what becomes of water.
TEST_F(Motion, DepthStaysWhereTheTargetLeavesIt) {
    addWaves();
    Body* const body = makeBody(desc_);
    const WaterPicture written = picture({body}, camera_, 4);
    leaveDepth();
    const WaterPicture left = picture({body}, camera_, 4);
    size_t covered = 0, differ = 0;
    for (size_t i = 0; i < left.depth.size(); ++i) {
        EXPECT_EQ(left.depth[i], 0) << "the far plane";
        EXPECT_EQ(left.covered(i), written.covered(i));
        covered += left.covered(i);
        differ += left.color[i * 4 + 1] != written.color[i * 4 + 1];
    }
    std::printf("%zu of %zu pixels differ without depth\n", differ, covered);
    EXPECT_GT(covered, 5000u);
    EXPECT_LT(differ, covered / 50);
}

} // namespace
