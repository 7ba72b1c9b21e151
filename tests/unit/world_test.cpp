// seaglass/world.h: cameras that look as their own worlds' makers build them, against Seaglass's.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gpu/view/view.h"
#include "seaglass/world.h"
#include "tests/unit/host_worlds.h"

namespace {

using namespace seaglass;
using namespace tests;

glm::dvec3 fromHost(const World& world, const glm::dvec3& p) {
    double out[3];
    pointFrom(world, {p.x, p.y, p.z}, out);
    return {out[0], out[1], out[2]};
}

ViewDesc hostViewDesc(const HostWorld& host, const Camera& camera) {
    ViewDesc view = tests::viewDesc(camera);
    tests::copyMatrix(hostView(host, camera), view.view);
    tests::copyMatrix(hostProjection(host, camera), view.projection);
    return view;
}

TEST(Worlds, HaveTheirAxesWhereTheTableSays) {
    for (const HostWorld& host : everyWorld()) {
        const double metre = host.world.unitsPerMetre;
        EXPECT_EQ(fromHost(host.world, metre * host.up), glm::dvec3(0, 1, 0));
        EXPECT_EQ(fromHost(host.world, metre * host.right), glm::dvec3(1, 0, 0));
        EXPECT_EQ(fromHost(host.world, metre * host.ahead), glm::dvec3(0, 0, -1));
        const bool leftHanded = glm::dot(glm::cross(host.right, host.up), host.ahead) > 0;
        EXPECT_EQ(host.world.leftHanded, leftHanded);
        const glm::dvec3 p(3, -2, 7);
        double back[3];
        pointTo(host.world, {p.x, p.y, p.z}, back);
        EXPECT_NEAR(glm::length(fromHost(host.world, {back[0], back[1], back[2]}) - p), 0, 1e-12);
    }
}

TEST(Worlds, ShowTheirPictures) {
    for (const HostWorld& host : everyWorld())
        for (const double parallelHeight : {0.0, 8.0})
            for (const bool reversed : {true, false}) {
                Camera camera;
                camera.eye = {3, 4, 7};
                camera.target = {1, 0.5, -6};
                camera.reversed = reversed;
                camera.far = 300;
                camera.parallelHeight = parallelHeight;
                ViewDesc view = hostViewDesc(host, camera);
                const ViewDesc own = view;
                worldFrom(host.world, &view);
                ViewGeometry geometry, truth;
                ASSERT_STREQ(readCamera(view, geometry).text(), "");
                ASSERT_STREQ(readCamera(tests::viewDesc(camera), truth).text(), "");
                EXPECT_EQ(geometry.reversedDepth, reversed);
                EXPECT_EQ(geometry.parallel, parallelHeight > 0);
                EXPECT_NEAR(glm::length(geometry.eye - camera.eye), 0, 1e-12);
                if (geometry.parallel) {
                    EXPECT_NEAR(glm::length(geometry.sight - truth.sight), 0, 1e-9);
                }
                EXPECT_NEAR(glm::length(geometry.forward - truth.forward), 0, 1e-12);
                const glm::dvec3 world(0.5, 1.2, 0);
                const auto pixel = [&](const ViewGeometry& g) {
                    return g.pixelFromRelative * glm::dvec4(world - g.eye, 1);
                };
                EXPECT_NEAR(glm::length(pixel(geometry) - pixel(truth)), 0, 1e-9);
                // And back, as the host draws its scene again.
                double hostsView[16], hostsProjection[16];
                worldTo(host.world, view.view, view.projection, hostsView, hostsProjection);
                for (int i = 0; i < 16; ++i) {
                    EXPECT_NEAR(hostsView[i], own.view[i], 1e-9) << i;
                    EXPECT_NEAR(hostsProjection[i], own.projection[i], 1e-9) << i;
                }
            }
}

TEST(Worlds, KeepWhatLiesInAPlaneAndUnderAShadow) {
    for (const HostWorld& host : everyWorld()) {
        const glm::dvec3 point = toHost(host, {2, 1.5, -3}),
                         normal = glm::normalize(toHost(host, {0.1, 1, 0.2}));
        double plane[4];
        planeFrom(host.world, {normal.x, normal.y, normal.z, -glm::dot(normal, point)}, plane);
        EXPECT_NEAR(plane[0] * 2 + plane[1] * 1.5 + plane[2] * -3 + plane[3], 0, 1e-12);
        EXPECT_GT(plane[1], 0.9);

        const glm::dmat4 texture = hostProjection(host, Camera{}) * hostView(host, Camera{});
        LightingDesc light;
        SunShadow shadow;
        const glm::dvec3 sun = glm::normalize(toHost(host, {0.6, 0.8, 0}));
        for (int i = 0; i < 3; ++i) light.toSun[i] = sun[i];
        tests::copyMatrix(texture, shadow.textureFromWorld[0]);
        worldFrom(host.world, &light, &shadow);
        EXPECT_NEAR(light.toSun[0], 0.6, 1e-12);
        EXPECT_NEAR(light.toSun[1], 0.8, 1e-12);
        const glm::dvec3 world(0.5, 1.2, -4);
        const glm::dvec4 there = texture * glm::dvec4(toHost(host, world), 1);
        const glm::dvec4 here = toMatrix(shadow.textureFromWorld[0]) * glm::dvec4(world, 1);
        EXPECT_NEAR(glm::length(there - here), 0, 1e-9 * glm::length(there));
    }
}

} // namespace
