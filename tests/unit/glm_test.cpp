// seaglass/glm.h: what goes in comes out where the plain arrays say it is.
#include <seaglass/glm.h>
#include <seaglass/reflection.h>
#include <seaglass/water.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace {

TEST(Glm, MatricesAreColumnMajor) {
    seaglass::ViewDesc view;
    seaglass::assign(view.view, glm::translate(glm::mat4(1), glm::vec3(3, 4, 5)));
    EXPECT_EQ(view.view[0], 1);
    EXPECT_EQ(view.view[3], 0);
    EXPECT_EQ(view.view[12], 3);
    EXPECT_EQ(view.view[13], 4);
    EXPECT_EQ(view.view[14], 5);
}

TEST(Glm, DoublesKeepTheirBits) {
    const glm::dmat4 far = glm::translate(glm::dmat4(1), glm::dvec3(100000.1, -0.3, 1.0 / 3));
    seaglass::PlanarView planar;
    seaglass::assign(planar.view, far);
    EXPECT_EQ(seaglass::toMat4<double>(planar.view), far);
    EXPECT_EQ(seaglass::toMat4<float>(planar.view), glm::mat4(far));
}

TEST(Glm, AViewOfACameraOverTheWholeAttachment) {
    const glm::mat4 camera = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)), lens(2);
    const seaglass::ViewDesc view = seaglass::viewDesc(camera, lens, {640, 360});
    EXPECT_EQ(seaglass::toMat4<float>(view.view), camera);
    EXPECT_EQ(seaglass::toMat4<float>(view.projection), lens);
    EXPECT_EQ(view.viewport.x, 0);
    EXPECT_EQ(view.viewport.y, 0);
    EXPECT_EQ(view.viewport.width, 640);
    EXPECT_EQ(view.viewport.height, 360);
    EXPECT_EQ(view.viewport.minDepth, 0);
    EXPECT_EQ(view.viewport.maxDepth, 1);
    EXPECT_EQ(view.viewIndex, 0u);
}

TEST(Glm, LightOfThreeVectors) {
    const seaglass::LightingDesc light =
        seaglass::lightingDesc(glm::vec3(0, 1, 0), glm::vec3(1, 2, 3), glm::vec3(4, 5, 6));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(light.toSun[i], i == 1 ? 1 : 0);
        EXPECT_EQ(light.sunIrradiance[i], static_cast<float>(1 + i));
        EXPECT_EQ(light.skyIrradiance[i], static_cast<float>(4 + i));
    }
}

TEST(Glm, APlaneThroughAPoint) {
    seaglass::BodyDesc body;
    seaglass::assignPlane(body.plane, glm::vec3(3, 2, 1), glm::vec3(0, 2, 0));
    EXPECT_EQ(body.plane[0], 0);
    EXPECT_EQ(body.plane[1], 2);
    EXPECT_EQ(body.plane[3], -4); // water 2 m up
}

TEST(Glm, VectorsOfEitherPrecision) {
    seaglass::LightingDesc light;
    seaglass::assign(light.toSun, glm::vec3(0.25f, 0.5f, 0.75f));
    seaglass::assign(light.sunIrradiance, glm::dvec3(1, 2, 3));
    EXPECT_EQ(light.toSun[1], 0.5);
    EXPECT_EQ(light.sunIrradiance[2], 3.0f);
    seaglass::ReflectorDesc floor;
    seaglass::assign(floor.plane, glm::vec4(0, 0, 1, -2));
    EXPECT_EQ(floor.plane[2], 1);
    EXPECT_EQ(floor.plane[3], -2);
}

} // namespace
