// Fog before the water, held against the formula in double, and against what the host has fogged itself.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/gpu/rig/fresnel.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr double sky[3] = {1, 2, 3}; // the rig's

FogDesc misty(FogShape shape) {
    FogDesc fog;
    fog.shape = shape;
    fog.density = 0.01f;
    fog.start = 5;
    fog.end = 400;
    fog.falloff = 0.15f;
    fog.baseHeight = 1;
    fog.color[0] = 0.7f;
    fog.color[1] = 0.2f;
    fog.color[2] = 5;
    fog.overSky = false;
    return fog;
}

Camera overTheSea() {
    Camera camera;
    camera.eye = {3, 6, 0};
    camera.target = {0, 5, -20};
    camera.width = 96;
    camera.height = 64;
    return camera;
}

/// Along the line of sight of a pixel, to `end`.
double passesTo(const FogDesc& fog, const Camera& camera, uint32_t x, uint32_t y, const glm::dvec3& end) {
    const glm::dvec3 from = lineThrough(camera, x, y).from;
    return fogTransmittance(fog, from.y, end.y - from.y, glm::length(end - from));
}

class FogOverWater : public WaterTest {
  protected:
    WaterPicture fogged(Body* body, const Camera& camera, const FogDesc* fog,
                        const SceneBehind& behind = {}) {
        lighting.fog = fog;
        return picture({body}, camera, 0, SurfaceOutput::shaded, behind);
    }

    /// What surfaces are shaded into holds halves, of 11 bits: either picture is off by half of the last.
    static constexpr double ofHalves = 1.0 / 1024;

    /// The clear picture's pixels as the formula fogs them, but for the farthest, which are a pixel long.
    void expectFormula(Body* body, const Camera& camera, const FogDesc& fog, double most = ofHalves,
                       float farthest = 1e-6f) {
        const WaterPicture clear = fogged(body, camera, nullptr), seen = fogged(body, camera, &fog);
        size_t held = 0;
        for (uint32_t y = 0; y < seen.height; ++y)
            for (uint32_t x = 0; x < seen.width; ++x) {
                const size_t i = size_t{y} * seen.width + x;
                if (!seen.covered(i) || seen.depth[i] < farthest) continue;
                const double passes = passesTo(fog, camera, x, y, worldAt(camera, seen, x, y));
                ++held;
                for (size_t c = 0; c < 3; ++c) {
                    const double color = double{fog.color[c]};
                    const double expected = color + passes * (double{clear.color[i * 4 + c]} - color);
                    ASSERT_NEAR(double{seen.color[i * 4 + c]}, expected, most * (expected + 1))
                        << "shape " << static_cast<int>(fog.shape) << " at " << x << ", " << y << ", where "
                        << passes << " passes";
                }
                ASSERT_EQ(seen.color[i * 4 + 3], 1);
            }
        EXPECT_GT(held, 1000u);
    }

    BodyDesc desc_;
};

constexpr FogShape shapes[] = {FogShape::linear, FogShape::exponential, FogShape::exponentialSquared,
                               FogShape::height};

TEST_F(FogOverWater, IsTheFormulasFromTheEye) {
    Body* const body = makeBody(desc_);
    for (const FogShape shape : shapes) expectFormula(body, overTheSea(), misty(shape));
    FogDesc half = misty(FogShape::exponential);
    half.most = 0.5f;
    expectFormula(body, overTheSea(), half);
}

TEST_F(FogOverWater, IsTheFormulasFarFromTheOriginAndOnTiltedWater) {
    Camera far = overTheSea();
    far.eye += glm::dvec3(2e5, 300, -1e5);
    far.target += glm::dvec3(2e5, 300, -1e5);
    desc_.plane[3] = -300;
    FogDesc fog = misty(FogShape::height);
    fog.baseHeight = 295;
    expectFormula(makeBody(desc_), far, fog);
    desc_ = {};
    desc_.plane[0] = 0.2;
    desc_.plane[2] = -0.1;
    expectFormula(makeBody(desc_), overTheSea(), misty(FogShape::height));
}

TEST_F(FogOverWater, ReachesFromTheNearPlaneAlongParallelLines) {
    Body* const body = makeBody(desc_);
    Camera camera = overTheSea();
    camera.eye = {0, 30, 40};
    camera.target = {0, 0, 0};
    camera.parallelHeight = 30;
    camera.far = 200;
    camera.near = 8;
    for (const FogShape shape : shapes) expectFormula(body, camera, misty(shape));
}

TEST_F(FogOverWater, IsNumbersAtExtremes) {
    Body* const body = makeBody(desc_);
    for (const double height : {0.02, 2.0, 1e4, 1e5})
        for (const float density : {0.0f, 1e-7f, 1000.0f})
            for (const float falloff : {0.0f, 1e-6f, 10.0f})
                for (const double base : {-1e6, 0.0, 1e6})
                    for (const FogShape shape : {FogShape::height, FogShape::exponentialSquared}) {
                        if (shape != FogShape::height && (falloff > 0 || base != 0)) continue;
                        FogDesc fog = misty(shape);
                        fog.density = density;
                        fog.falloff = falloff;
                        fog.baseHeight = base;
                        fog.overSky = false;
                        Camera camera = overTheSea();
                        camera.eye.y = height;
                        camera.target.y = height - 12;
                        camera.near = height / 100;
                        camera.width = 64;
                        camera.height = 48;
                        expectFormula(body, camera, fog, 1e-3, 1e-7f);
                    }
}

// Mirrored sky is the host's, which fogs it, too: all along the mirrored ray, which never ends.
TEST_F(FogOverWater, LiesOverTheSkyThatIsMirrored) {
    FogDesc fog = misty(FogShape::height);
    fog.overSky = true;
    fog.density = 0.03f;
    const Camera camera = overTheSea();
    const WaterPicture clear = fogged(makeBody(desc_), camera, nullptr),
                       seen = fogged(makeBody(desc_), camera, &fog);
    double most = 0, least = 1;
    for (uint32_t y = 0; y < seen.height; ++y)
        for (uint32_t x = 0; x < seen.width; ++x) {
            const size_t i = size_t{y} * seen.width + x;
            if (!seen.covered(i) || seen.depth[i] < 1e-5f) continue;
            const glm::dvec3 at = worldAt(camera, seen, x, y);
            const double up = -rayThrough(camera, x, y).y;
            const double fromSky = fogTransmittance(fog, at.y, 1e9 * up, 1e9);
            const double passes = passesTo(fog, camera, x, y, at);
            most = std::max(most, fromSky);
            least = std::min(least, fromSky);
            for (size_t c = 0; c < 3; ++c) {
                const double color = double{fog.color[c]};
                const double water = double{clear.color[i * 4 + c]} - reflectance(up) * sky[c];
                const double mirrored = color + fromSky * (sky[c] - color);
                const double expected = color + passes * (water + reflectance(up) * mirrored - color);
                ASSERT_NEAR(double{seen.color[i * 4 + c]}, expected, 2e-3 * (expected + 1)) << x << ", " << y;
            }
        }
    EXPECT_GT(most, 0.5);
    EXPECT_LT(least, 0.05);
}

// A sky of one radiance everywhere: the fog's colour is that.
TEST_F(FogOverWater, MayHaveTheSkysColour) {
    FogDesc fog = misty(FogShape::exponential);
    const Camera camera = overTheSea();
    Body* const body = makeBody(desc_);
    fog.fromSky = 0.25f;
    const WaterPicture ofSky = fogged(body, camera, &fog);
    fog.fromSky = 0;
    for (size_t c = 0; c < 3; ++c) fog.color[c] = 0.75f * fog.color[c] + 0.25f * static_cast<float>(sky[c]);
    const WaterPicture ofColor = fogged(body, camera, &fog);
    for (size_t i = 0; i < ofSky.color.size(); ++i)
        ASSERT_NEAR(ofSky.color[i], ofColor.color[i], 1e-4f * (1 + std::abs(ofColor.color[i])));
}

/// What a host shows that fogs its opaque scene by the same formula.
SceneBehind foggedByHost(const Camera& camera, SceneBehind behind, const FogDesc& fog) {
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const size_t i = size_t{y} * camera.width + x;
            if (behind.depth[i] == 0) continue;
            const glm::dvec4 p =
                inverse * glm::dvec4((x + 0.5) / camera.width * 2 - 1, (y + 0.5) / camera.height * 2 - 1,
                                     double{behind.depth[i]}, 1);
            const double passes = passesTo(fog, camera, x, y, glm::dvec3(p) / p.w);
            for (size_t c = 0; c < 3; ++c) {
                float& value = behind.color[i * 4 + c];
                const double color = double{fog.color[c]};
                value = static_cast<float>(color + passes * (double{value} - color));
            }
        }
    return behind;
}

// Where water thins out over a shore, both are equally foggy: no seam.
TEST_F(FogOverWater, IsNotPutOnWhatTheHostHasFogged) {
    const RefractionDesc clearWater = {{0.05f, 0.02f, 0.01f}, {0, 0, 0}, 1};
    desc_.refraction = &clearWater;
    Body* const body = makeBody(desc_);
    const Camera camera = overTheSea();
    for (const FogShape shape : shapes) {
        const FogDesc fog = misty(shape);
        const SceneBehind bed = planeBelow(camera, -0.01, 2);
        const WaterPicture clear = fogged(body, camera, nullptr, bed),
                           seen = fogged(body, camera, &fog, foggedByHost(camera, bed, fog));
        double refogged = 0;
        for (uint32_t y = 0; y < seen.height; ++y)
            for (uint32_t x = 0; x < seen.width; ++x) {
                const size_t i = size_t{y} * seen.width + x;
                if (!seen.covered(i) || seen.depth[i] < 3e-4f) continue;
                const double passes = passesTo(fog, camera, x, y, worldAt(camera, seen, x, y));
                for (size_t c = 0; c < 3; ++c) {
                    const double color = double{fog.color[c]};
                    const double expected = color + passes * (double{clear.color[i * 4 + c]} - color);
                    ASSERT_NEAR(double{seen.color[i * 4 + c]}, expected, 0.01 * expected)
                        << "shape " << static_cast<int>(shape) << " at " << x << ", " << y;
                    refogged = std::max(refogged, passes * (1 - passes) * std::abs(2 - color) / expected);
                }
            }
        EXPECT_GT(refogged, 0.1) << "the test shows what it is about";
    }
}

// A wall at the far end of the water, of which each pixel has its mirror image: as foggy as the wall.
TEST_F(FogOverWater, IsNotPutOnWhatIsMirroredOfThat) {
    ReflectionDesc reflection;
    reflection.edgeFade = 0;
    desc_.reflection = &reflection;
    Body* const body = makeBody(desc_);
    Camera camera = overTheSea();
    camera.target = {3, 3, -60};
    const double wall = -60;
    const SceneBehind scene = drawnOver(camera, nothingBehind(camera), 6, [&](const glm::dvec3& ray) {
        const double away = wall / ray.z;
        const double height = camera.eye.y + away * ray.y;
        return height > -0.2 && height < 9 ? away : 0;
    });
    FogDesc fog = misty(FogShape::exponential);
    const WaterPicture clear = fogged(body, camera, nullptr, scene),
                       seen = fogged(body, camera, &fog, foggedByHost(camera, scene, fog));
    size_t held = 0;
    for (uint32_t y = 0; y < seen.height; ++y)
        for (uint32_t x = 0; x < seen.width; ++x) {
            const size_t i = size_t{y} * seen.width + x;
            if (!seen.covered(i)) continue;
            const glm::dvec3 at = worldAt(camera, seen, x, y);
            if (at.z < wall || at.z > wall + 12) continue;
            ++held;
            const double along = glm::length(at - camera.eye);
            const double mirrored = along * (camera.eye.z - wall) / (camera.eye.z - at.z);
            const double passes = std::exp(-double{fog.density} * along);
            for (size_t c = 0; c < 3; ++c) {
                const double color = double{fog.color[c]}, f = reflectance(-rayThrough(camera, x, y).y);
                const double own = double{clear.color[i * 4 + c]} - f * 6;
                // As a ray that is followed has it, by the whole of its way.
                const double ofWall = color + std::exp(-double{fog.density} * mirrored) * (6 - color);
                const double expected = passes * own + f * ofWall + color * (1 - passes) * (1 - f);
                ASSERT_NEAR(double{seen.color[i * 4 + c]}, expected, 0.03 * expected) << x << ", " << y;
            }
        }
    EXPECT_GT(held, 150u);
}

TEST_F(FogOverWater, ThatIsNoneIsRefused) {
    Body* const body = makeBody(desc_);
    struct Bad {
        const char* field;
        void (*spoil)(FogDesc&);
    };
    const Bad bads[] = {
        {"shape", [](FogDesc& f) { f.shape = static_cast<FogShape>(0); }},
        {"shape", [](FogDesc& f) { f.shape = static_cast<FogShape>(5); }},
        {"density", [](FogDesc& f) { f.density = -1; }},
        {"density", [](FogDesc& f) { f.density = NAN; }},
        {"start", [](FogDesc& f) { f.shape = FogShape::linear, f.start = f.end; }},
        {"end", [](FogDesc& f) { f.shape = FogShape::linear, f.end = INFINITY; }},
        {"falloff", [](FogDesc& f) { f.shape = FogShape::height, f.falloff = 11; }},
        {"baseHeight", [](FogDesc& f) { f.shape = FogShape::height, f.baseHeight = NAN; }},
        {"color", [](FogDesc& f) { f.color[1] = -1; }},
        {"color", [](FogDesc& f) { f.color[2] = INFINITY; }},
        {"fromSky", [](FogDesc& f) { f.fromSky = 1.5f; }},
        {"most", [](FogDesc& f) { f.most = -0.5f; }},
    };
    for (const Bad& bad : bads) {
        FogDesc fog;
        bad.spoil(fog);
        lighting.fog = &fog;
        drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            EXPECT_EQ(draw(commands, target, &body, 1, &view, &lighting), Status::invalidArgument);
            EXPECT_NE(message().find("FogDesc." + std::string(bad.field)), std::string::npos) << message();
            return Status::ok;
        };
        picture({body}, overTheSea());
    }
}

} // namespace
