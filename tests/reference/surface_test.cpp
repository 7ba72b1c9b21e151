// The traced sea is the sea that height queries answer for.
#include <gtest/gtest.h>

#include "tests/reference/box_world.h"

namespace {

using namespace demos;

WaterDesc breezy(double choppiness) {
    WaterDesc water;
    water.levelM = 0.5;
    WavesDesc waves;
    waves.windMps = 8;
    waves.fetchM = 2e4;
    waves.choppiness = choppiness;
    waves.seed = 5;
    water.waves = waves;
    return water;
}

struct Scene {
    reference::World world;
    reference::Frame frame;

    Scene(const WaterDesc& water, uint32_t height) {
        Error error;
        EXPECT_TRUE(tests::lightWorld(glm::vec3(0.5f), world));
        EXPECT_TRUE(reference::setWater(water, world, error)) << error.text;
        reference::FrameDesc desc = tests::smallFrame();
        desc.height = height;
        desc.width = height * 16 / 9;
        desc.timeS = 3.25;
        // Far out, where a float would be off by centimetres.
        for (const size_t i : {size_t(0), size_t(2)}) {
            desc.camera.positionM[i] += 345678.9;
            desc.camera.targetM[i] += 345678.9;
        }
        EXPECT_TRUE(reference::prepareFrame(world, desc, frame, error)) << error.text;
    }
};

TEST(Surface, EndsWhereItsExtentSays) {
    for (const bool wavy : {false, true}) {
        WaterDesc water = breezy(1);
        if (!wavy) water.waves.reset();
        ExtentDesc extent;
        extent.shape = "polygon";
        extent.centerM = {345678.9, 345678.9};
        extent.yawDeg = 10;
        extent.pointsM = {{-6, 3}, {5, 2}, {7, -9}, {0, -4}, {-8, -12}};
        water.extent = extent;
        const Scene scene(water, 90);
        const reference::Frame& frame = scene.frame;
        size_t hits = 0, misses = 0;
        for (uint32_t y = 0; y < frame.desc.height; ++y)
            for (uint32_t x = 0; x < frame.desc.width; ++x) {
                const reference::Ray ray = frame.rayThrough({static_cast<float>(x), static_cast<float>(y)});
                reference::Hit hit;
                if (!frame.geometry.trace(ray, reference::Kind::everything, hit)) {
                    ++misses;
                    continue;
                }
                ++hits;
                EXPECT_TRUE(scene.world.outline->contains(frame.calmAt(hit)));
                // Waves do not carry it over the edge.
                const glm::dvec2 at(frame.camera.eye.x + static_cast<double>(hit.position.x),
                                    frame.camera.eye.z + static_cast<double>(hit.position.z));
                EXPECT_TRUE(scene.world.outline->contains(at) || scene.world.outline->distanceTo(at) < 1e-3);
            }
        EXPECT_GT(hits, 300u);
        EXPECT_GT(misses, 300u);
    }
}

TEST(Surface, LiesWhereHeightsAreSampled) {
    const Scene scene(breezy(1), 180);
    const reference::Frame& frame = scene.frame;
    std::vector<double> points;
    std::vector<float> heights;
    std::vector<double> distances;
    for (uint32_t y = 76; y < frame.desc.height; y += 7)
        for (uint32_t x = 3; x < frame.desc.width; x += 13) {
            const reference::Ray ray = frame.rayThrough({static_cast<float>(x), static_cast<float>(y)});
            reference::Hit hit;
            if (!frame.geometry.trace(ray, reference::Kind::everything, hit)) continue;
            points.push_back(frame.camera.eye.x + static_cast<double>(hit.position.x));
            points.push_back(frame.camera.eye.z + static_cast<double>(hit.position.z));
            heights.push_back(frame.heightOf(hit.position));
            distances.push_back(static_cast<double>(hit.distance));
        }
    ASSERT_GT(heights.size(), 200u);
    std::vector<seaglass::HeightSample> samples(heights.size());
    seaglass::sampleHeights(*scene.world.sea, frame.desc.timeS, points.data(), heights.size(),
                            samples.data());
    const double significant = seaglass::significantWaveHeight(*scene.world.sea);
    double squares = 0, worst = 0, farthest = 0;
    int counted = 0;
    for (size_t i = 0; i < heights.size(); ++i) {
        if (samples[i].folded) continue;
        const double off = static_cast<double>(heights[i]) - static_cast<double>(samples[i].height);
        squares += off * off;
        worst = std::max(worst, std::abs(off));
        farthest = std::max(farthest, distances[i]);
        ++counted;
    }
    // Bilinear maps cut the crests of the shortest waves, and cells grow with distance.
    const double rms = std::sqrt(squares / counted);
    RecordProperty("rms_per_significant_height", std::to_string(rms / significant));
    EXPECT_LT(rms, 0.01 * significant) << counted << " points up to " << farthest << " m";
    EXPECT_LT(worst, 0.05 * significant);
    EXPECT_GT(farthest, 20);
}

/// The mesh's own slopes must be those that light is bent by.
TEST(Surface, SlopesAreThoseOfTheMesh) {
    const Scene scene(breezy(0.6), 360);
    const reference::Frame& frame = scene.frame;
    double squares = 0, reference = 0;
    for (uint32_t y = 240; y < frame.desc.height; y += 9)
        for (uint32_t x = 3; x < frame.desc.width; x += 17) {
            const reference::Ray ray = frame.rayThrough({static_cast<float>(x), static_cast<float>(y)});
            reference::Hit hit;
            if (!frame.geometry.trace(ray, reference::Kind::everything, hit)) continue;
            const glm::vec2 mesh = -glm::vec2(hit.facing().x, hit.facing().z) / hit.facing().y;
            const glm::vec2 slope = frame.surface.slopes(frame.calmAt(hit), 0).mean;
            squares += static_cast<double>(glm::dot(mesh - slope, mesh - slope));
            reference += static_cast<double>(glm::dot(slope, slope));
        }
    ASSERT_GT(reference, 0);
    EXPECT_LT(std::sqrt(squares / reference), 0.35);
}

/// What the maps lose between their samples is roughness, or the sea would be smoother than the wind makes
/// it.
TEST(Surface, SlopesHaveAllOfTheSeasVariance) {
    WaterDesc water = breezy(0);
    water.waves->warp = 0; // which makes waves here longer, there shorter
    const Scene scene(water, 90);
    const reference::WaterSurface& surface = scene.frame.surface;
    double sum = 0;
    constexpr int points = 400; // a side
    for (int i = 0; i < points * points; ++i) {
        const glm::dvec2 calm(1.37 * (i % points), 1.73 * (i / points));
        const reference::WaterSurface::Slopes s = surface.slopes(calm, 0);
        sum += static_cast<double>(glm::dot(s.mean, s.mean) + s.covariance.x + s.covariance.y);
    }
    const seaglass::Sea& sea = *scene.world.sea;
    const double all = seaglass::resolvedSlopeVariance(sea) + seaglass::unresolvedSlopeVariance(sea);
    EXPECT_NEAR(sum / (points * points), all, 0.03 * all);
}

TEST(Surface, HasNoHoles) {
    const Scene scene(breezy(1), 90);
    const reference::Frame& frame = scene.frame;
    // Straight down through the whole mesh, in view and out of it.
    for (int i = 0; i < 20000; ++i) {
        reference::Random random(static_cast<uint32_t>(i), 0, 7);
        const float distance = std::pow(10.0f, 5 * random.next() - 1), angle = 6.2831853f * random.next();
        reference::Ray ray;
        ray.origin = {distance * std::cos(angle), 50, distance * std::sin(angle)};
        ray.direction = glm::normalize(glm::vec3(0.01f * random.next(), -1, 0.01f * random.next()));
        ray.footprint = reference::footprintAfter(ray.origin, ray.direction, 0, 1e-3f);
        reference::Hit hit;
        ASSERT_TRUE(frame.geometry.trace(ray, reference::Kind::surface, hit))
            << distance << " m, " << angle << " rad";
    }
}

} // namespace
