// The two formulas for what share of light water mirrors: how far apart they are, and that each is drawn.
#include <array>
#include <cmath>
#include <numbers>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// docs/tradeoffs.md, Fresnel: degrees off straight on, per cent mirrored, and by how many per cent of the
/// exact share Schlick's is off.
struct Row {
    double angle, exact, schlick, off;
};

constexpr Row table[] = {{0, 2.04, 2.04, 0},       {20, 2.06, 2.04, -0.9},  {40, 2.45, 2.11, -14.0},
                         {60, 5.97, 5.10, -14.6},  {70, 13.35, 14.12, 5.8}, {75, 21.24, 23.95, 12.8},
                         {80, 34.79, 39.78, 14.4}, {85, 58.35, 64.13, 9.9}, {89, 89.63, 91.74, 2.4}};

double at(double degrees, Fresnel formula) {
    return reflectance(std::cos(radians(degrees)), formula);
}

/// Of an even sky: 2 R cos over the cosine from 0 to 1, by the midpoint rule.
double diffuse(Fresnel formula) {
    constexpr int steps = 100000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = (i + 0.5) / steps;
        sum += 2 * cosine * reflectance(cosine, formula);
    }
    return sum / steps;
}

TEST(FresnelFormulas, AreAsFarApartAsTheDocumentsSay) {
    for (const Row& row : table) {
        EXPECT_NEAR(100 * at(row.angle, Fresnel::exact), row.exact, 0.005) << row.angle;
        EXPECT_NEAR(100 * at(row.angle, Fresnel::schlick), row.schlick, 0.005) << row.angle;
        EXPECT_NEAR(100 * at(row.angle, Fresnel::schlick) / at(row.angle, Fresnel::exact) - 100, row.off,
                    0.05)
            << row.angle;
    }
    EXPECT_NEAR(diffuse(Fresnel::exact), 0.0664, 5e-5);
    EXPECT_NEAR(diffuse(Fresnel::schlick), 0.0670, 5e-5);
    double most = 0, mostAt = 0, least = 0, leastAt = 0, share = 0, shareAt = 0;
    for (double degrees = 0; degrees < 90; degrees += 0.01) {
        const double exact = at(degrees, Fresnel::exact), off = at(degrees, Fresnel::schlick) - exact;
        if (off > most) most = off, mostAt = degrees;
        if (off / exact > share) share = off / exact, shareAt = degrees;
        if (off / exact < least) least = off / exact, leastAt = degrees;
    }
    EXPECT_NEAR(most, 0.059, 5e-4);
    EXPECT_NEAR(mostAt, 84, 0.5);
    EXPECT_NEAR(share, 0.145, 5e-4);
    EXPECT_NEAR(shareAt, 79, 0.5);
    EXPECT_NEAR(least, -0.227, 5e-4);
    EXPECT_NEAR(leastAt, 51, 0.5);
    EXPECT_GT(at(67.2, Fresnel::schlick), at(67.2, Fresnel::exact));
    EXPECT_LT(at(67.0, Fresnel::schlick), at(67.0, Fresnel::exact));
}

class BodyFresnel : public WaterTest {
  protected:
    static BodyDesc by(Fresnel formula) {
        BodyDesc desc;
        desc.shading.fresnel = formula;
        return desc;
    }
    /// From straight down to the horizon.
    static Camera wide() {
        Camera camera;
        camera.eye = {3, 4, 7};
        camera.target = {3, 0, 3};
        camera.fovDegrees = 100;
        camera.width = camera.height = 256;
        return camera;
    }
    /// A sun low over the horizon that the camera looks towards.
    void setSun(double elevationDegrees) {
        const double elevation = radians(elevationDegrees);
        shineFrom({0, std::sin(elevation), -std::cos(elevation)}, 2);
    }
    /// What the picture has of the sun alone.
    double sunlight(BodyDesc desc, const Camera& camera, Fresnel formula) {
        desc.shading.fresnel = formula;
        Body* const body = makeBody(desc);
        const LightingDesc lit = lighting;
        const WaterPicture with = picture({body}, camera);
        for (float& channel : lighting.sunIrradiance) channel = 0;
        const WaterPicture without = picture({body}, camera);
        lighting = lit;
        double sum = 0;
        for (size_t i = 0; i < with.color.size(); i += 4)
            if (with.covered(i / 4)) sum += double{with.color[i]} - double{without.color[i]};
        return sum;
    }
};

class DrawnFresnel : public BodyFresnel, public testing::WithParamInterface<Fresnel> {};

TEST_P(DrawnFresnel, FlatWaterMirrorsTheSkyByTheFormula) {
    const Camera camera = wide();
    const WaterPicture p = picture({makeBody(by(GetParam()))}, camera);
    std::array<bool, 90> seen{};
    for (uint32_t y = 0; y < p.height; ++y)
        for (uint32_t x = 0; x < p.width; ++x) {
            const double cosine = -rayThrough(camera, x, y).y;
            if (cosine < 0.01) continue;
            seen[static_cast<size_t>(std::acos(cosine) * 180 / std::numbers::pi)] = true;
            const auto mirroredAt = [&](uint32_t column, uint32_t row) {
                return reflectance(-rayThrough(camera, column, row).y, GetParam());
            };
            const double expected = mirroredAt(x, y);
            // Lines of sight lean by as much of a pixel as vertices are snapped by.
            const double aPixel =
                std::abs(mirroredAt(x + 1, y) - expected) + std::abs(mirroredAt(x, y + 1) - expected);
            const double leaning = limitOnGrid(0, 1.0 / 32) * aPixel;
            for (size_t channel = 0; channel < 3; ++channel) {
                const auto light = static_cast<double>(channel + 1);
                ASSERT_NEAR(p.color[(size_t{y} * p.width + x) * 4 + channel], expected * light,
                            2e-3 * expected + (leaning + expected / 2048) * light) // of halves
                    << x << ' ' << y;
            }
        }
    for (size_t degrees = 1; degrees < seen.size(); ++degrees) EXPECT_TRUE(seen[degrees]) << degrees;
}

// All of it is mirrored by facets of one angle, and what is not goes through them.
TEST_P(DrawnFresnel, TheSunsGlintAndItsWayThroughAreShares) {
    constexpr double elevation = 10;
    setSun(elevation);
    Camera low = wide();
    low.target = low.eye + glm::dvec3(0, std::sin(radians(-elevation)), -std::cos(radians(elevation)));
    low.fovDegrees = 6;
    const double mirrored = std::sin(radians(elevation));
    EXPECT_NEAR(sunlight({}, low, GetParam()) / sunlight({}, low, Fresnel::exact),
                reflectance(mirrored, GetParam()) / reflectance(mirrored), 2e-3);

    const RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
    const UnderwaterDesc underwater;
    BodyDesc pool;
    pool.refraction = &clear;
    pool.underwater = &underwater;
    Camera within = low;
    within.eye.y = -4;
    const glm::dvec3 sun(lighting.toSun[0], lighting.toSun[1], lighting.toSun[2]);
    within.target = within.eye - glm::refract(-sun, glm::dvec3(0, 1, 0), 1 / waterIndex);
    EXPECT_NEAR(sunlight(pool, within, GetParam()) / sunlight(pool, within, Fresnel::exact),
                (1 - reflectance(mirrored, GetParam())) / (1 - reflectance(mirrored)), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(By, DrawnFresnel, testing::ValuesIn(formulas), formulaName);

// One formula of a body's own, in one call.
TEST_F(BodyFresnel, IsEachBodysOwnAndSharesPipelines) {
    const auto half = [&](double side, Fresnel formula) {
        BodyDesc desc = by(formula);
        desc.extent.shape = ExtentShape::rectangle;
        desc.extent.center[0] = 50 * side;
        desc.extent.size[0] = 100;
        desc.extent.size[1] = 200;
        return makeBody(desc);
    };
    Camera camera = wide();
    camera.eye.x = camera.target.x = 0;
    Body* const left = half(-1, Fresnel::schlick);
    Body* const right = half(1, Fresnel::exact);
    spiedCalls().clear();
    const WaterPicture p = picture({left, right}, camera);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 2u);
    for (uint32_t y = 3; y < p.height; y += 7)
        for (uint32_t x = 3; x < p.width; x += 7) {
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const size_t i = size_t{y} * p.width + x;
            if (ray.y > -0.1 || !p.covered(i)) continue;
            const double expected = reflectance(-ray.y, x < p.width / 2 ? Fresnel::schlick : Fresnel::exact);
            EXPECT_NEAR(p.color[4 * i], expected, 1e-3 * expected) << x << ' ' << y;
        }
    spiedCalls().clear();
    picture({half(-1, Fresnel::schlick), half(1, Fresnel::exact)}, camera);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
}

} // namespace
