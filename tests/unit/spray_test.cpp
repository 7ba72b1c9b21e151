// How much wind tears off, and where a view has particles for it.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/vec2.hpp>

#include "tests/unit/cameras.h"
#include "water/spray/spray_lattice.h"
#include "water/spray/spume.h"

namespace {

using namespace seaglass;
using tests::Camera;

TEST(Spume, IsTornByWindFromNineMetresASecondOn) {
    EXPECT_EQ(tornShare(0), 0);
    EXPECT_EQ(tornShare(9), 0);
    EXPECT_EQ(spumeFlux(9), 0);
    double before = 0;
    for (double wind = 9.5; wind < 31; wind += 0.5) {
        const double share = tornShare(wind);
        EXPECT_GT(share, before) << wind;
        before = share;
    }
    EXPECT_NEAR(tornShare(31), 1, 1e-12);
    EXPECT_NEAR(tornShare(100), 1, 1e-12);
    // A fresh breeze has next to none, a strong gale plenty.
    EXPECT_LT(tornShare(11), 0.03);
    EXPECT_GT(tornShare(22.6), 0.4);
}

// Integrated by steps of a hundredth of a micrometre, from Andreas' three laws.
TEST(Spume, IsTheIntegralOfItsSizes) {
    const double wind = 20, at14 = 1.03 * wind;
    const double smallest =
        std::pow(10, 0.0676 * at14 + 2.43) * std::exp(-3.1 * std::pow(std::log(10 / 2.1), 2)) +
        std::pow(10, 0.959 * std::sqrt(at14) - 1.476) * std::exp(-3.3 * std::pow(std::log(10 / 9.2), 2));
    double flux = 0, number = 3.5 * smallest;
    constexpr double step = 0.01;
    for (double r = 10; r < 500; r += step) {
        const double law = r < 37.5 ? 1 : r < 100 ? 2.8 : 8;
        flux += number * tests::radians(180) * r * r * step * 1e-12;
        number *= std::pow((r + step) / r, -law);
    }
    EXPECT_NEAR(spumeFlux(wind) / flux, 1, 0.002);
    // What whitecaps and drops of that size give, to the order: 1e-4 to 1e-3 of the sea a second.
    EXPECT_GT(flux, 1e-4);
    EXPECT_LT(flux, 1e-3);
}

ViewGeometry geometryOf(const Camera& camera) {
    ViewGeometry geometry;
    EXPECT_EQ(std::string(readCamera(tests::viewDesc(camera), geometry).text()), "");
    return geometry;
}

std::vector<Camera> cameras() {
    std::vector<Camera> all;
    for (const double fov : {20.0, 60.0, 110.0, 150.0})
        for (const double height : {-1.0, 2.0, 40.0, 300.0})
            for (const double azimuth : {0.0, 30.0, 45.0, 200.0})
                for (const double dip : {-20.0, 0.0, 15.0, 60.0, 89.0}) {
                    Camera camera;
                    camera.fovDegrees = fov;
                    camera.eye = {1e5, height, -3e4};
                    const double a = tests::radians(azimuth), d = tests::radians(dip);
                    camera.target = camera.eye + glm::dvec3(std::cos(a) * std::cos(d), -std::sin(d),
                                                            std::sin(a) * std::cos(d));
                    all.push_back(camera);
                }
    return all;
}

TEST(SprayLattice, HasNoMoreThanItsCap) {
    for (const uint32_t most : {1024u, 65536u})
        for (const Camera& camera : cameras()) {
            const ViewGeometry geometry = geometryOf(camera);
            const SprayLattice lattice = sprayLattice({geometry, camera.eye.y, 8, 30}, most);
            uint32_t count = 0;
            for (const SprayLevel& level : lattice.levels) count += level.count();
            EXPECT_EQ(count, lattice.count);
            EXPECT_LE(count, most);
        }
}

// Water that a view shows has a cell of the level for its distance, as far as that goes.
TEST(SprayLattice, CoversWhatIsSeen) {
    size_t seen = 0;
    for (const Camera& camera : cameras()) {
        const ViewGeometry geometry = geometryOf(camera);
        const SprayLattice lattice = sprayLattice({geometry, camera.eye.y, 8, 30}, 65536);
        std::vector<glm::dvec2> places;
        for (int i = 0; i < 400; ++i) {
            const double distance = 3 * std::pow(1.013, i), turn = 2.399963 * i;
            places.push_back(distance * glm::dvec2(std::cos(turn), std::sin(turn)));
        }
        // And just within a level's reach, where its last cells are.
        for (const SprayLevel& level : lattice.levels) {
            const double across =
                std::sqrt(std::max(level.reach * level.reach - camera.eye.y * camera.eye.y, 0.0));
            for (const glm::dvec2 along :
                 {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
                places.push_back(0.9999 * across * along);
        }
        for (const glm::dvec2& place : places) {
            const glm::dvec3 at(place.x, -camera.eye.y, place.y);
            const glm::dvec4 pixel = geometry.pixelFromRelative * glm::dvec4(at, 1);
            const glm::dvec2 p = glm::dvec2(pixel) / pixel.w;
            if (!(pixel.w > 0 && p.x > 0 && p.y > 0 && p.x < geometry.regionSize.x &&
                  p.y < geometry.regionSize.y))
                continue;
            for (const SprayLevel& level : lattice.levels) {
                if (level.count() == 0 || glm::length(at) > level.reach) continue;
                const double u = (camera.eye.x + at.x) / level.cell - level.first.x;
                const double v = (camera.eye.z + at.z) / level.cell - level.first.y;
                EXPECT_TRUE(u >= 0 && v >= 0 && u <= level.alongU && v <= level.alongV)
                    << place.x << ' ' << place.y;
                ++seen;
            }
        }
    }
    EXPECT_GT(seen, 10000u);
}

// An eye that moves sees other cells of the same ones.
TEST(SprayLattice, LiesStill) {
    Camera camera;
    for (int i = 0; i < 50; ++i) {
        const ViewGeometry geometry = geometryOf(camera);
        const SprayLattice lattice = sprayLattice({geometry, 2, 8, 30}, 65536);
        SprayBlock block{};
        lattice.fill(geometry.eye, block);
        for (int level = 0; level < sprayLevels; ++level) {
            const double corner = double{block.places[level].x} + camera.eye.x;
            EXPECT_NEAR(corner, double{block.places[level].z} * block.cells[level].x, 1e-3);
        }
        camera.eye.x += 0.37;
        camera.target.x += 0.37;
    }
}

} // namespace
