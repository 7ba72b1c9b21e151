// A sea on a globe, as it is seen: how far its horizon dips, from the beach to 100 km up.
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double earth = 6.371e6;

class SeaOnAGlobe : public WaterTest {
  protected:
    static Camera camera(double height, double roll) {
        Camera camera;
        camera.eye = {3, height, 7};
        camera.target = camera.eye + glm::dvec3(0.3, -0.3, -1);
        camera.rollDegrees = roll;
        camera.near = 0.05 * height;
        camera.width = 240;
        camera.height = 135;
        return camera;
    }

    static BodyDesc onEarth() {
        BodyDesc desc;
        desc.extent.planetRadius = earth;
        return desc;
    }

    static double dip(double height) { return std::acos(earth / (earth + height)); }
};

TEST_F(SeaOnAGlobe, EndsWhereItsHorizonDips) {
    Body* body = makeBody(onEarth());
    for (const double height : {2.0, 1000.0, 1e4, 1e5})
        for (const double roll : {0.0, 33.0, 180.0}) {
            const Camera c = camera(height, roll);
            const WaterPicture p = picture({body}, c, 0, SurfaceOutput::height);
            size_t holes = 0, above = 0;
            for (uint32_t y = 0; y < p.height; ++y)
                for (uint32_t x = 0; x < p.width; ++x) {
                    const double angle = angleBelowHorizon(c, x, y) - dip(height);
                    const bool covered = p.covered(size_t{y} * p.width + x);
                    holes += angle > 1e-3 && !covered;
                    above += angle < -1e-3 && covered;
                }
            EXPECT_EQ(holes, 0u) << "eye at " << height << " m, roll " << roll;
            EXPECT_EQ(above, 0u) << "eye at " << height << " m, roll " << roll;
        }
}

TEST_F(SeaOnAGlobe, HasNoHolesInItsWaves) {
    SeaDesc sea;
    sea.windSpeed = 8;
    sea.fetch = 50e3f;
    sea.samples = 128;
    sea.cascades = 3;
    BodyDesc desc = onEarth();
    desc.waves = &sea;
    desc.wavesBackend = fftwWaves();
    Body* body = makeBody(desc);
    for (const double height : {3.0, 5000.0, 1e5}) {
        const Camera c = camera(height, 120);
        const WaterPicture p = picture({body}, c, 5);
        for (uint32_t y = 0; y < p.height; ++y)
            for (uint32_t x = 0; x < p.width; ++x) {
                const size_t pixel = size_t{y} * p.width + x;
                if (angleBelowHorizon(c, x, y) - dip(height) < 0.03) continue;
                ASSERT_TRUE(p.covered(pixel)) << x << " " << y << " from " << height << " m";
                ASSERT_TRUE(std::isfinite(p.color[pixel * 4])) << x << " " << y << " from " << height << " m";
            }
    }
}

TEST_F(SeaOnAGlobe, IsLevelEverywhere) {
    Body* body = makeBody(onEarth());
    const Camera c = camera(1e5, 0);
    const WaterPicture heights = picture({body}, c, 0, SurfaceOutput::height);
    const WaterPicture normals = picture({body}, c, 0, SurfaceOutput::normal);
    const glm::dvec3 from(0, c.eye.y + earth, 0); // the ball's middle to the eye
    double highest = 0, leaning = 0;
    for (size_t pixel = 0; pixel < heights.depth.size(); ++pixel) {
        if (!heights.covered(pixel)) continue;
        const auto x = static_cast<uint32_t>(pixel % c.width), y = static_cast<uint32_t>(pixel / c.width);
        if (angleBelowHorizon(c, x, y) - dip(1e5) < 0.02) continue; // where a pixel spans much of the globe
        highest = std::max(highest, std::abs(double{heights.color[pixel * 4]}));
        const glm::dvec3 ray = rayThrough(c, x, y);
        const double along = glm::dot(from, ray);
        const double gap = std::max(along * along - glm::dot(from, from) + earth * earth, 0.0);
        const glm::dvec3 up = glm::normalize(from - ray * (along + std::sqrt(gap)));
        const glm::dvec3 drawn(normals.color[pixel * 4], normals.color[pixel * 4 + 1],
                               normals.color[pixel * 4 + 2]);
        leaning = std::max(leaning, glm::distance(up, drawn));
    }
    std::printf("height %.3f m, normals %.5f off\n", highest, leaning);
    EXPECT_LT(highest, 1) << "of 100 km, in floats";
    EXPECT_LT(leaning, 5e-3);
}

// Far off both axes, where what is level turns about a third.
TEST_F(SeaOnAGlobe, MirrorsTheSunWhereItsBallDoes) {
    constexpr double radius = 1e6;
    BodyDesc desc;
    desc.extent.planetRadius = radius;
    Body* body = makeBody(desc);
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.2 * side, 0.96, -0.25));
        Camera c = camera(3e5, 0);
        const glm::dvec3 place = glm::dvec3(c.eye.x, -radius, c.eye.z) + radius * up;
        const glm::dvec3 toEye = glm::normalize(c.eye - place);
        c.target = place;
        c.fovDegrees = 8;
        c.width = c.height = 81;
        const glm::dvec3 toSun = 2 * glm::dot(up, toEye) * up - toEye;
        for (int i = 0; i < 3; ++i) lighting.toSun[i] = toSun[i];
        std::fill_n(lighting.sunIrradiance, 3, 5.0f);
        const WaterPicture p = picture({body}, c);
        double all = 0;
        glm::dvec2 sum(0);
        for (size_t pixel = 0; pixel < p.depth.size(); ++pixel) {
            const double light = double{p.color[pixel * 4]};
            if (!p.covered(pixel) || light < 20) continue; // the sky is of 1
            all += light;
            sum += light * glm::dvec2(pixel % c.width, pixel / c.width);
        }
        std::printf("%g of light about %.2f, %.2f\n", all, sum.x / all, sum.y / all);
        EXPECT_GT(all, 20);
        EXPECT_LT(glm::distance(sum / all, glm::dvec2(40)), 1.5);
    }
}

TEST_F(SeaOnAGlobe, IsNotLitByASunThatHasSet) {
    const RefractionDesc turbid = {{0.1f, 0.1f, 0.1f}, {0.05f, 0.05f, 0.05f}, 1};
    BodyDesc desc = onEarth();
    desc.refraction = &turbid;
    Body* body = makeBody(desc);
    Camera c = camera(100, 0);
    c.target = c.eye + glm::dvec3(0.3, -2, -1);
    c.width = c.height = 16;
    const std::vector<float> dark = picture({body}, c).color;
    shineFrom({0, -0.6, -0.8}, 50);
    EXPECT_EQ(picture({body}, c).color, dark);
}

TEST_F(SeaOnAGlobe, RefusesABallThatIsNoPlanet) {
    for (const double radius : {-1.0, 1e5, 1e10, std::nan("")}) {
        BodyDesc desc;
        desc.extent.planetRadius = radius;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument) << radius;
        EXPECT_EQ(body, nullptr);
        EXPECT_EQ(message(), "BodyDesc.extent.planetRadius is out of range, expected 0 or 1e+06 to 1e+09 m");
    }
}

} // namespace
