// Bodies that end: each shape covers what its outline encloses, shows there what an endless body shows, and
// costs nothing where it is not seen.
#include <algorithm>
#include <cmath>
#include <set>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/traced_scene.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/body/body.h"

namespace {

using namespace seaglass;
using namespace tests;

SeaDesc breeze() {
    SeaDesc sea;
    sea.windSpeed = 8;
    sea.fetch = 20e3f;
    sea.samples = 64;
    return sea;
}

/// Triangles of half a metre over a square.
struct Pond {
    std::vector<double> points;
    std::vector<uint32_t> indices;

    Pond() {
        constexpr uint32_t cells = 24, row = cells + 1;
        for (uint32_t j = 0; j <= cells; ++j)
            for (uint32_t i = 0; i <= cells; ++i) points.insert(points.end(), {i * 0.5 - 6, j * 0.5 - 10});
        for (uint32_t j = 0; j < cells; ++j)
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = j * row + i;
                indices.insert(indices.end(), {a, a + row, a + 1, a + 1, a + row, a + row + 1});
            }
    }
};

class Extents : public WaterTest {
  protected:
    static ExtentDesc pool() {
        ExtentDesc extent;
        extent.shape = ExtentShape::rectangle;
        extent.center[1] = -4;
        extent.size[0] = 12;
        extent.size[1] = 7;
        extent.yaw = 0.4;
        return extent;
    }
    ExtentDesc lake() const {
        ExtentDesc extent;
        extent.shape = ExtentShape::polygon;
        extent.points = shore_.data();
        extent.pointCount = static_cast<uint32_t>(shore_.size() / 2);
        return extent;
    }
    ExtentDesc pond() const {
        ExtentDesc extent;
        extent.shape = ExtentShape::mesh;
        extent.points = pond_.points.data();
        extent.pointCount = static_cast<uint32_t>(pond_.points.size() / 2);
        extent.indices = pond_.indices.data();
        extent.indexCount = static_cast<uint32_t>(pond_.indices.size());
        return extent;
    }
    std::vector<ExtentDesc> all() const { return {pool(), lake(), pond()}; }

    Body* bodyOver(const ExtentDesc& extent, const SeaDesc* waves = nullptr) {
        BodyDesc desc;
        desc.extent = extent;
        desc.waves = waves;
        desc.wavesBackend = fftwWaves();
        desc.mesh.cellsPerLevel = 1024; // waves are seen in the shape from afar
        return makeBody(desc);
    }

    static Camera above(double height) {
        Camera camera;
        camera.eye = {2, height, 9};
        camera.target = {1, 0, -4};
        camera.width = 320;
        camera.height = 180;
        return camera;
    }

  private:
    const std::vector<double> shore_ = {-7, -9, 6, -11, 8, 1, 3, 0, 2, -5, -2, 2, -6, 1};
    const Pond pond_;
};

/// Pixels drawn that should not be, or the other way round; those within `tolerance` of the outline do not
/// count.
size_t wronglyCovered(const Camera& camera, const WaterPicture& p, const ExtentDesc& extent,
                      double tolerance) {
    const Outline outline = outlineOf(extent);
    size_t wrong = 0;
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const glm::dvec3 at = camera.eye - ray * (camera.eye.y / ray.y);
            const glm::dvec2 calm(at.x, at.z);
            if (ray.y < 0 && outline.distanceTo(calm) < tolerance) continue;
            wrong += p.covered(size_t{y} * p.width + x) != (ray.y < 0 && outline.contains(calm));
        }
    return wrong;
}

TEST_F(Extents, CoverWhatTheirOutlineEncloses) {
    for (const ExtentDesc& extent : all())
        for (const double height : {0.5, 8.0, 3000.0}) {
            Camera camera = above(height);
            if (height > 1000) camera.fovDegrees = 0.5;
            const WaterPicture p = picture({bodyOver(extent)}, camera, 0, SurfaceOutput::height);
            const size_t wrong = wronglyCovered(camera, p, extent, 1e-3 * (1 + height / 100));
            EXPECT_LE(static_cast<double>(wrong),
                      limitOnGrid(0, 3)) // edges that pass pixels' centres closely
                << "shape " << static_cast<int>(extent.shape) << " from " << height << " m";
        }
}

TEST_F(Extents, WavesMoveNothingAcrossTheOutline) {
    // From so high up that heights hardly move what is seen sideways.
    const SeaDesc sea = breeze();
    for (const ExtentDesc& extent : all()) {
        Camera camera = above(300);
        camera.eye = {0, 300, -4};
        camera.target = {0, 0, -4};
        camera.fovDegrees = 3.5;
        Body* body = bodyOver(extent, &sea);
        const WaterPicture p = picture({body}, camera, 3, SurfaceOutput::height);
        EXPECT_EQ(wronglyCovered(camera, p, extent, 0.05), 0u) << "shape " << static_cast<int>(extent.shape);
        float highest = 0;
        for (size_t i = 0; i < p.depth.size(); ++i)
            if (p.covered(i)) highest = std::max(highest, std::abs(p.color[i * 4]));
        EXPECT_GT(highest, 0.02f) << "shape " << static_cast<int>(extent.shape);
    }
}

TEST_F(Extents, LeaveNoCracks) {
    const SeaDesc sea = breeze();
    for (const ExtentDesc& extent : all())
        for (const double height : {0.9, 3.0, 30.0}) {
            Camera camera = above(height);
            camera.rollDegrees = 20;
            const WaterPicture p = picture({bodyOver(extent, &sea)}, camera, 3, SurfaceOutput::height);
            // A pixel without water between four with it.
            size_t cracks = 0;
            const auto covered = [&](uint32_t x, uint32_t y) { return p.covered(size_t{y} * p.width + x); };
            for (uint32_t y = 1; y + 1 < p.height; ++y)
                for (uint32_t x = 1; x + 1 < p.width; ++x)
                    cracks += !covered(x, y) && covered(x - 1, y) && covered(x + 1, y) && covered(x, y - 1) &&
                              covered(x, y + 1);
            EXPECT_EQ(cracks, 0u) << "shape " << static_cast<int>(extent.shape) << " from " << height << " m";
        }
}

TEST_F(Extents, ShowWhatAnEndlessBodyShows) {
    const ReflectionDesc reflection;
    const RefractionDesc refraction;
    const Camera camera = above(2.2);
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    BodyDesc desc;
    desc.reflection = &reflection;
    desc.refraction = &refraction;
    const SceneBehind behind = {traced.color, traced.depth};
    const WaterPicture endless = picture({makeBody(desc)}, camera, 0, SurfaceOutput::shaded, behind);
    for (const ExtentDesc& extent : all()) {
        desc.extent = extent;
        const WaterPicture p = picture({makeBody(desc)}, camera, 0, SurfaceOutput::shaded, behind);
        size_t compared = 0, apart = 0;
        for (size_t i = 0; i < p.color.size(); ++i)
            if (p.covered(i / 4)) {
                ++compared;
                apart += std::abs(double{p.color[i]} - double{endless.color[i]}) > 2e-3;
            }
        EXPECT_GT(compared, 4 * 2500u);
        // A bent ray that only just passes an edge may, from other triangles, only just meet it.
        EXPECT_LE(static_cast<double>(apart), static_cast<double>(compared) * limitOnGrid(1e-3, 1.4e-3))
            << "shape " << static_cast<int>(extent.shape);
    }
}

TEST_F(Extents, AreTheSameAMillionMetresAway) {
    const ExtentDesc near = pool();
    ExtentDesc far = near;
    far.center[0] += 1e6;
    far.center[1] -= 1e6;
    const Camera camera = above(3);
    Camera moved = camera;
    moved.eye += glm::dvec3(1e6, 0, -1e6);
    moved.target += glm::dvec3(1e6, 0, -1e6);
    const WaterPicture a = picture({bodyOver(near)}, camera), b = picture({bodyOver(far)}, moved);
    size_t differ = 0;
    for (size_t i = 0; i < a.depth.size(); ++i) differ += a.covered(i) != b.covered(i);
    EXPECT_LE(differ, 2u);
}

TEST_F(Extents, OutOfSightDrawAndReflectNothing) {
    const ReflectionDesc reflection;
    const SeaDesc sea = breeze();
    for (const ExtentDesc& extent : all()) {
        BodyDesc desc;
        desc.extent = extent;
        desc.reflection = &reflection;
        for (const SeaDesc* const waves : {static_cast<const SeaDesc*>(nullptr), &sea}) {
            desc.waves = waves;
            desc.wavesBackend = fftwWaves();
            Body* body = makeBody(desc);
            Camera camera = above(2);
            picture({body}, camera);
            EXPECT_GT(countSpied("CmdDrawIndexed"), 0u);
            camera.eye.z = -40;
            camera.target.z = -60;
            spiedCalls().clear();
            const WaterPicture p = picture({body}, camera);
            EXPECT_EQ(countSpied("CmdDrawIndexed"), 0u);
            EXPECT_EQ(countSpied("CmdDispatch"), waves ? wavesMips() : 0);
            EXPECT_EQ(countSpied("CmdDispatchIndirect"), 0u);
            for (size_t i = 0; i < p.depth.size(); ++i) ASSERT_FALSE(p.covered(i));
        }
    }
}

TEST_F(Extents, EndlessBodiesHoldNothingOfThem) {
    Body* endless = makeBody({});
    EXPECT_FALSE(endless->placing.outline.has_value());
    EXPECT_FALSE(endless->placing.hostMesh.has_value());
    picture({endless}, above(2));
    EXPECT_TRUE(endless->placing.outlined.patches.empty());
    EXPECT_FALSE(bodyOver(pool())->placing.hostMesh.has_value());
    spiedCalls().clear();
    bodyOver(pool());
    bodyOver(lake());
    EXPECT_EQ(bytesSpied(), 0u);
}

TEST_F(Extents, TheEstimateCountsAMeshOfTheHosts) {
    BodyDesc desc;
    desc.extent = pond();
    Estimate estimated;
    ASSERT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::ok) << message();
    EXPECT_GE(estimated.bytes, 16u * 25 * 25 + 4u * 6 * 24 * 24);
    spiedCalls().clear();
    makeBody(desc);
    EXPECT_EQ(bytesSpied(), estimated.bytes);
}

TEST_F(Extents, ThatAreBadAreNamedAndLeaveNothing) {
    BodyDesc desc;
    desc.extent.shape = ExtentShape::rectangle;
    Body* body = nullptr;
    spiedCalls().clear();
    EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
    EXPECT_EQ(body, nullptr);
    EXPECT_NE(message().find("BodyDesc.extent.size"), std::string::npos);
    Estimate estimated;
    EXPECT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::invalidArgument);
    EXPECT_EQ(countSpied("CreateBuffer"), 0u);
}

/// Two pools on a slope and the sea at its foot: each pixel shows the one that is seen first.
TEST_F(Extents, OfSeveralHeightsAreSeenTogether) {
    const ReflectionDesc reflection;
    const RefractionDesc refraction;
    const SeaDesc ripples = [] {
        SeaDesc sea = breeze();
        sea.amplitude = 0.02f;
        return sea;
    }();
    std::vector<Body*> bodies;
    const double levels[] = {0, 1, 3};
    for (const double level : levels) {
        BodyDesc desc;
        desc.plane[3] = -level;
        desc.refraction = &refraction;
        desc.reflection = &reflection;
        if (level == 1) {
            desc.waves = &ripples;
            desc.wavesBackend = fftwWaves();
        }
        if (level > 0) {
            desc.extent.shape = ExtentShape::rectangle;
            desc.extent.center[0] = level == 1 ? -4 : 3;
            desc.extent.center[1] = level == 1 ? -3 : -9;
            desc.extent.size[0] = 6;
            desc.extent.size[1] = 4;
        }
        bodies.push_back(makeBody(desc));
    }
    const Camera camera = above(6);
    for (const std::vector<Body*>& order : {bodies, {bodies[2], bodies[0], bodies[1]}}) {
        const WaterPicture p = picture(order, camera, 1);
        std::set<double> seen;
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                if (!p.covered(size_t{y} * p.width + x) || angleBelowHorizon(camera, x, y) < 0.05) continue;
                const glm::dvec3 ray = rayThrough(camera, x, y);
                const auto hit = [&](double level) {
                    return camera.eye + ray * ((level - camera.eye.y) / ray.y);
                };
                const auto in = [&](double level, double cx, double cz, double slack) {
                    const glm::dvec3 at = hit(level);
                    return std::abs(at.x - cx) < 3 + slack && std::abs(at.z - cz) < 2 + slack;
                };
                // Beside an edge either may show.
                if (in(1, -4, -3, 0.1) != in(1, -4, -3, -0.1) || in(3, 3, -9, 0.1) != in(3, 3, -9, -0.1))
                    continue;
                const double level = in(3, 3, -9, 0) ? 3 : in(1, -4, -3, 0) ? 1 : 0;
                ASSERT_NEAR(worldAt(camera, p, x, y).y, level, 0.06) << x << " " << y;
                seen.insert(level);
            }
        EXPECT_EQ(seen.size(), 3u);
    }
}

} // namespace
