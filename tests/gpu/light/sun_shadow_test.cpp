// The host's shadow map on the water: what it hides from the sun is as dark as without one, all else as
// bright.
#include <algorithm>
#include <numbers>
#include <string>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/scene_images.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr uint32_t mapSize = 128;
constexpr float nothing = 1; ///< depth of what the sun's rays end in

class SunShadows : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        sea_.windSpeed = 14;
        sea_.samples = 128;
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        desc_.foam = &foam_;
        desc_.refraction = &refraction_;
        const double low = 25 * std::numbers::pi / 180;
        shineFrom({0, std::sin(low), -std::cos(low)}, 5);
        for (float& channel : lighting.skyIrradiance) channel = 0.5f;
    }

    static Camera overTheSea() {
        Camera camera;
        camera.eye = {0, 12, 20};
        camera.target = {0, 0, 0};
        camera.width = 160;
        camera.height = 120;
        return camera;
    }

    /// A map of these depths, column by column, which hold for all of z.
    void setMap(const std::function<float(double)>& depthAtU) {
        std::vector<float> depths(size_t{mapSize} * mapSize);
        for (size_t i = 0; i < depths.size(); ++i)
            depths[i] = depthAtU((static_cast<double>(i % mapSize) + 0.5) / mapSize);
        map_ = uploadDepth(VK_FORMAT_D32_SFLOAT, {mapSize, mapSize}, depths);
        demos::Error error;
        ASSERT_TRUE(demos::createArrayView(device(), map_, view_, error)) << error.text;
        shadow_.map = {view_.get(), map_.format, map_.extent, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    }

    /// Cascade `i` holds x from -half to half, between u `from` and `to`, and all of z that is seen. Depth
    /// falls from 1 at y = -40 to 0 at y = 40.
    void setCascade(uint32_t i, double half, double from = 0, double to = 1) {
        glm::dmat4 m(0);
        m[0] = {(to - from) / (2 * half), 0, 0, 0};
        m[1] = {0, 0, -1 / 80.0, 0};
        m[2] = {0, 1 / 400.0, 0, 0};
        m[3] = {(from + to) / 2, 0.5, 0.5, 1};
        std::copy_n(&m[0][0], 16, shadow_.textureFromWorld[i]);
        const float bounds[] = {static_cast<float>(from), 0, static_cast<float>(to), 1};
        std::copy_n(bounds, 4, shadow_.bounds[i]);
        shadow_.layers[i] = 0;
    }

    WaterPicture shaded(bool sun, bool shadow) { return shaded(sun, shadow, overTheSea()); }

    WaterPicture shaded(bool sun, bool shadow, const Camera& camera) {
        Body* const body = makeBody(desc_);
        LightingDesc given = lighting;
        if (!sun) std::fill_n(lighting.sunIrradiance, 3, 0.0f);
        lighting.shadow = shadow ? &shadow_ : nullptr;
        WaterPicture p = picture({body}, camera, 40);
        lighting = given;
        return p;
    }

    /// Where `side` of x is below 0 the picture is that of no sun, where above that of no shadow; at 0
    /// anything may be.
    void expectDarkWhere(const std::function<int(double)>& side) {
        const WaterPicture lit = shaded(true, false), dark = shaded(false, false), got = shaded(true, true);
        size_t darker = 0, asBright = 0;
        for (uint32_t y = 0; y < got.height; ++y)
            for (uint32_t x = 0; x < got.width; ++x) {
                const size_t pixel = size_t{y} * got.width + x;
                if (!got.covered(pixel)) continue;
                const glm::dvec3 point = worldAt(overTheSea(), got, x, y);
                const int which = isNear(point) ? side(point.x) : 0;
                if (which == 0) continue;
                const WaterPicture& expected = which > 0 ? lit : dark;
                const float value = got.color[pixel * 4];
                ASSERT_FLOAT_EQ(value, expected.color[pixel * 4]) << x << ", " << y;
                if (which < 0 && value < lit.color[pixel * 4] - 0.01f) ++darker;
                if (which > 0 && value > dark.color[pixel * 4] + 0.01f) ++asBright;
            }
        EXPECT_GT(darker, 300u);
        EXPECT_GT(asBright, 500u);
    }

    /// Within all maps, and where a pixel is no wider than what the tests leave out.
    static bool isNear(const glm::dvec3& point) { return std::abs(point.x) < 38 && point.z > -40; }

    SeaDesc sea_;
    FoamDesc foam_;
    RefractionDesc refraction_{{0.3f, 0.1f, 0.05f}, {0, 0, 0}, 1, 0.1f};
    BodyDesc desc_;
    SunShadow shadow_;

  private:
    demos::Image map_;
    demos::UniqueImageView view_;
};

/// -1 left of x = 0, 1 right of it, 0 near it.
int leftIsDark(double x) {
    return std::abs(x) < 2 ? 0 : x < 0 ? -1 : 1;
}

constexpr float above = 0.02f; ///< depth of something over all waves: water lies near 0.5

TEST_F(SunShadows, LieWhereTheMapHasThem) {
    setMap([](double u) { return u < 0.5 ? above : nothing; });
    setCascade(0, 40);
    expectDarkWhere(leftIsDark);
}

// As wide as a texel of the map, and half lit where the map's texels meet.
TEST_F(SunShadows, EndWhereTexelsMeet) {
    constexpr double half = 160, texel = 2 * half / mapSize; // [m]
    setMap([](double u) { return u < 0.5 ? above : nothing; });
    setCascade(0, half);
    const WaterPicture lit = shaded(true, false), dark = shaded(false, false), got = shaded(true, true);
    size_t compared = 0;
    for (uint32_t y = 0; y < got.height; ++y)
        for (uint32_t x = 0; x < got.width; ++x) {
            const size_t at = (size_t{y} * got.width + x) * 4;
            const float range = lit.color[at] - dark.color[at];
            if (!got.covered(at / 4) || range < 0.05f) continue;
            const glm::dvec3 point = worldAt(overTheSea(), got, x, y);
            const double expected = std::clamp(0.5 + point.x / texel, 0.0, 1.0);
            if (!isNear(point) || expected == 0 || expected == 1) continue;
            ++compared;
            ASSERT_NEAR((got.color[at] - dark.color[at]) / range, expected, 0.02) << x << ", " << y;
        }
    EXPECT_GT(compared, 200u);
}

// Shadows are looked up there alone.
TEST_F(SunShadows, LieOnTheDiscThatStillWaterMirrors) {
    desc_.waves = nullptr;
    desc_.foam = nullptr;
    desc_.refraction = nullptr;
    const double low = 25 * std::numbers::pi / 180;
    Camera camera = overTheSea();
    camera.target = camera.eye + glm::dvec3(0, -std::sin(low), -std::cos(low));
    camera.fovDegrees = 1.5;
    setMap([](double u) { return u < 0.5 ? above : nothing; });
    setCascade(0, 2);
    const WaterPicture lit = shaded(true, false, camera), dark = shaded(false, false, camera),
                       got = shaded(true, true, camera);
    size_t darker = 0, asBright = 0;
    for (uint32_t y = 0; y < got.height; ++y)
        for (uint32_t x = 0; x < got.width; ++x) {
            const size_t at = (size_t{y} * got.width + x) * 4;
            const double aside = worldAt(camera, got, x, y).x;
            if (std::abs(aside) < 0.05) continue; // the map's texels
            ASSERT_EQ(got.color[at], (aside < 0 ? dark : lit).color[at]) << x << ", " << y;
            if (lit.color[at] > dark.color[at]) ++(aside < 0 ? darker : asBright);
        }
    EXPECT_GT(darker, 200u);
    EXPECT_GT(asBright, 200u);
}

/// Steep, so that its own axes have the shadow's edge metres away from where the world's have it.
TEST_F(SunShadows, LieThereOnATiltedBody) {
    const double plane[] = {0.5, 1, 0.05, -4};
    std::ranges::copy(plane, desc_.plane);
    setMap([](double u) { return u < 0.4 ? above : nothing; });
    setCascade(0, 40);
    expectDarkWhere([](double x) { return leftIsDark(x + 8); });
}

TEST_F(SunShadows, OfReversedDepthAreTheSame) {
    setMap([](double u) { return u < 0.5 ? 1 - above : 1 - nothing; });
    setCascade(0, 40);
    for (int i = 0; i < 4; ++i) shadow_.textureFromWorld[0][4 * i + 2] *= -1;
    shadow_.textureFromWorld[0][14] += 1;
    shadow_.reversedDepth = true;
    expectDarkWhere(leftIsDark);
}

TEST_F(SunShadows, ThrowNothingDownOnWhatStandsHigher) {
    setMap([](double) { return 0.7f; }); // all of it below the water
    setCascade(0, 40);
    const WaterPicture lit = shaded(true, false), got = shaded(true, true);
    EXPECT_EQ(got.color, lit.color);
}

/// Within 5 m the first cascade counts, which is lit; farther out the second, which is dark; none beyond 14
/// m.
TEST_F(SunShadows, AreThoseOfTheFirstCascadeThatHoldsAPoint) {
    setMap([](double u) { return u < 0.5 ? nothing : above; });
    shadow_.cascadeCount = 2;
    setCascade(0, 5, 0, 0.5);
    setCascade(1, 14, 0.5, 1);
    expectDarkWhere([](double x) {
        const double away = std::abs(x);
        if (std::abs(away - 5) < 1 || std::abs(away - 14) < 1) return 0;
        return away > 5 && away < 14 ? -1 : 1;
    });
}

/// Nothing is drawn deeper than a map's far end, which stands for all beyond.
TEST_F(SunShadows, NeedNoMapAsDeepAsTheWater) {
    setMap([](double) { return nothing; });
    setCascade(0, 40);
    for (int i = 0; i < 4; ++i) shadow_.textureFromWorld[0][4 * i + 2] *= 4; // 1 at y = 20
    const WaterPicture lit = shaded(true, false), got = shaded(true, true);
    EXPECT_EQ(got.color, lit.color);
}

TEST_F(SunShadows, LeaveNoCaustics) {
    CausticsDesc caustics;
    desc_.caustics = &caustics;
    desc_.foam = nullptr;
    Body* const body = makeBody(desc_);
    const Camera camera = overTheSea();
    const SceneBehind bed = planeBelow(camera, -2, 1);
    const auto factors = [&](bool shadow) {
        LightingDesc given = lighting;
        given.shadow = shadow ? &shadow_ : nullptr;
        drawCausticsOf(body, given);
        const WaterPicture p = picture({body}, camera, 40, SurfaceOutput::shaded, bed);
        beforeDrawing = nullptr;
        drawing = nullptr;
        return p;
    };
    setMap([](double u) { return u < 0.5 ? above : nothing; });
    setCascade(0, 40);
    const WaterPicture lit = factors(false), got = factors(true);
    size_t differ = 0;
    for (uint32_t y = 0; y < got.height; ++y)
        for (uint32_t x = 0; x < got.width; ++x) {
            const size_t at = (size_t{y} * got.width + x) * 4;
            const glm::dvec3 ray = rayThrough(camera, x, y);
            const glm::dvec3 point = camera.eye + (-2 - camera.eye.y) / ray.y * ray;
            if (!isNear(point)) continue;
            if (leftIsDark(point.x) > 0) {
                ASSERT_EQ(got.color[at], lit.color[at]);
            }
            if (leftIsDark(point.x) < 0) {
                ASSERT_EQ(got.color[at], WaterPicture::untouched);
                differ += lit.color[at] != WaterPicture::untouched;
            }
        }
    EXPECT_GT(differ, 500u);
}

/// Where the next pixel shows the sky, no step to it is finite.
TEST_F(SunShadows, AreReadBesideTheSky) {
    CausticsDesc caustics;
    desc_.caustics = &caustics;
    Body* const body = makeBody(desc_);
    SceneBehind bed = planeBelow(overTheSea(), -2, 1);
    for (size_t pixel = 0; pixel < bed.depth.size(); pixel += 7) bed.depth[pixel] = 0;
    setMap([](double u) { return u < 0.5 ? above : nothing; });
    setCascade(0, 40);
    lighting.shadow = &shadow_;
    drawCausticsOf(body);
    const WaterPicture p = picture({body}, overTheSea(), 40, SurfaceOutput::shaded, bed);
    EXPECT_TRUE(std::ranges::all_of(p.color, [](float value) { return std::isfinite(value); }));
}

TEST_F(SunShadows, ThatCannotBeReadAreNamed) {
    setMap([](double) { return nothing; });
    setCascade(0, 40);
    Body* const body = makeBody(desc_);
    const SunShadow good = shadow_;
    const auto named = [&](const char* field) {
        Status status = Status::ok;
        lighting.shadow = &shadow_;
        drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            status = draw(commands, target, &body, 1, &view, &lighting, SurfaceOutput::shaded);
            return Status::ok;
        };
        picture({body}, overTheSea(), 40);
        shadow_ = good;
        EXPECT_EQ(status, Status::invalidArgument) << field;
        return message().find(std::string("SunShadow.") + field) != std::string::npos;
    };
    shadow_.map.view = VK_NULL_HANDLE;
    EXPECT_TRUE(named("map.view")) << message();
    shadow_.map.format = VK_FORMAT_R8G8B8A8_UNORM;
    EXPECT_TRUE(named("map.format holds no depth that can be read, expected D16_UNORM, ")) << message();
    shadow_.map.layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    EXPECT_TRUE(named("map.layout")) << message();
    shadow_.map.samples = VK_SAMPLE_COUNT_4_BIT;
    EXPECT_TRUE(named("map.samples")) << message();
    for (const uint32_t count : {0u, 5u}) {
        shadow_.cascadeCount = count;
        EXPECT_TRUE(named("cascadeCount")) << message();
    }
    shadow_.textureFromWorld[0][5] = std::nan("");
    EXPECT_TRUE(named("textureFromWorld")) << message();
    shadow_.bounds[0][2] = 0;
    EXPECT_TRUE(named("bounds")) << message();
}

} // namespace
