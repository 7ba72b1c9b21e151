// Sunlight that waves gather: that none of it is lost, where it falls, and how it fades.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/water_rig.h"
#include "tests/unit/sea/statistics.h"

namespace {

using namespace seaglass;
using namespace tests;

class Caustics : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        sea_.windSpeed = 5;
        sea_.fetch = 2e3f;
        sea_.samples = 128;
        sea_.cascades = 3;
        sea_.largestPatch = 16;
        sea_.warp = 0; // pictures hold a whole tile
        desc_.waves = &sea_;
        desc_.wavesBackend = fftwWaves();
        desc_.refraction = &refraction_;
        desc_.caustics = &caustics_;
        lighting.toSun[0] = 0.48;
        lighting.toSun[1] = 0.8;
        lighting.toSun[2] = 0.36;
        for (float& channel : lighting.sunIrradiance) channel = 5;
        for (float& channel : lighting.skyIrradiance) channel = 0;
    }

    /// From straight above, 16 m of the bed from side to side, or more by as many more pixels.
    static Camera above(double bed, uint32_t wider = 1) {
        Camera camera;
        camera.eye = {3, 40 + bed, 7};
        camera.target = {3, 0, 7};
        camera.fovDegrees = 2 * std::atan(8.0 * wider / 40) * 180 / std::numbers::pi;
        camera.width = camera.height = 256 * wider;
        return camera;
    }

    /// What the light on a level bed is multiplied by.
    std::vector<double> factors(Body* body, double bed, double time = 2, uint32_t wider = 1) {
        return factors(body, above(bed, wider), bed, time);
    }
    std::vector<double> factors(Body* body, const Camera& camera, double bed, double time = 2) {
        return factors(body, camera, planeBelow(camera, bed, 1), time);
    }
    std::vector<double> factors(Body* body, const Camera& camera, const SceneBehind& behind,
                                double time = 2) {
        drawCausticsOf(body);
        const WaterPicture p = picture({body}, camera, time, SurfaceOutput::shaded, behind);
        beforeDrawing = nullptr;
        drawing = nullptr;
        std::vector<double> seen;
        for (size_t i = 1; i < p.color.size(); i += 4)
            seen.push_back(double{p.color[i]} / double{WaterPicture::untouched});
        return seen;
    }

    SeaDesc sea_;
    RefractionDesc refraction_{{0, 0, 0}, {0, 0, 0}, 1};
    CausticsDesc caustics_;
    BodyDesc desc_;
};

TEST_F(Caustics, TakeAsMuchLightAsTheyGive) {
    Body* body = makeBody(desc_);
    for (const double depth : {0.3, 1.0, 3.0, 10.0}) {
        const std::vector<double> light = factors(body, -depth);
        std::printf("%4.1f m: mean %.4f, deviation %.3f\n", depth, meanOf(light), deviationOf(light));
        EXPECT_NEAR(meanOf(light), 1, 0.03) << depth;
        EXPECT_GT(deviationOf(light), 0.1) << depth;
        EXPECT_GE(*std::ranges::min_element(light), 0) << depth;
    }
    EXPECT_NEAR(meanOf(factors(body, 0.5)), 1, 0) << "nothing stands above the water";
}

TEST_F(Caustics, FallWhereTheWavesSendTheLight) {
    for (const double rises : {0.8, 0.4}) {
        const double depth = rises < 0.5 ? 0.5 : 1.5;
        lighting.toSun[0] = 0.8 * std::sqrt(1 - rises * rises);
        lighting.toSun[1] = rises;
        lighting.toSun[2] = 0.6 * std::sqrt(1 - rises * rises);
        Body* body = makeBody(desc_);
        const std::vector<double> light = factors(body, -depth);
        // Photons through the surface on a net, each refracted at the normal there, and as many as it takes
        // of the sun.
        constexpr int cells = 32, net = 600;
        constexpr double side = 16, reach = 20;
        const std::unique_ptr<HeightGrid, void (*)(HeightGrid*)> grid(createHeightGrid(*sea(body), 2),
                                                                      destroyHeightGrid);
        std::vector<double> points;
        for (int j = 0; j < net; ++j)
            for (int i = 0; i < net; ++i)
                points.insert(points.end(), {3 + (i + 0.5) * reach / net - reach / 2,
                                             7 + (j + 0.5) * reach / net - reach / 2});
        std::vector<HeightSample> samples(points.size() / 2);
        sampleHeights(*grid, points.data(), samples.size(), samples.data());
        const glm::dvec3 down(-lighting.toSun[0], -lighting.toSun[1], -lighting.toSun[2]);
        std::vector<double> fallen(cells * cells);
        for (size_t i = 0; i < samples.size(); ++i) {
            const glm::dvec3 normal(samples[i].normal[0], samples[i].normal[1], samples[i].normal[2]);
            const double cosine = -glm::dot(down, normal), ratio = 1 / 1.333;
            const glm::dvec3 ray =
                down * ratio +
                normal * (ratio * cosine - std::sqrt(1 - ratio * ratio * (1 - cosine * cosine)));
            const double t = (depth + double{samples[i].height}) / -ray.y;
            const double x = (points[2 * i] + ray.x * t - 3) / side + 0.5,
                         z = (points[2 * i + 1] + ray.z * t - 7) / side + 0.5;
            if (x < 0 || z < 0 || x >= 1 || z >= 1) continue;
            fallen[static_cast<size_t>(z * cells) * cells + static_cast<size_t>(x * cells)] +=
                cosine / normal.y;
        }
        // Of all that is drawn, or of the picture moved by so many pixels.
        const auto drawnBy = [&](int right, int down) {
            std::vector<double> drawn(cells * cells);
            for (int y = 0; y < 256; ++y)
                for (int x = 0; x < 256; ++x) {
                    const int fromX = std::clamp(x - right, 0, 255), fromY = std::clamp(y - down, 0, 255);
                    drawn[static_cast<size_t>(y * cells / 256 * cells + x * cells / 256)] +=
                        light[static_cast<size_t>(fromY * 256 + fromX)];
                }
            return drawn;
        };
        const std::vector<double> drawn = drawnBy(0, 0);
        const double correlation = correlationOf(fallen, drawn);
        // By the parabola through three correlations [pixel].
        const auto offBy = [&](int right, int down) {
            const double more = correlationOf(fallen, drawnBy(right, down)),
                         less = correlationOf(fallen, drawnBy(-right, -down));
            return (right + down) * (less - more) / (2 * (2 * correlation - more - less));
        };
        const double offX = offBy(4, 0), offY = offBy(0, 4);
        const double contrast = deviationOf(drawn) / meanOf(drawn) / (deviationOf(fallen) / meanOf(fallen));
        std::printf("correlation with photons %.3f, off by %.2f %.2f pixels, contrast %.3f of theirs\n",
                    correlation, offX, offY, contrast);
        EXPECT_GT(correlation, 0.93);
        EXPECT_NEAR(offX, 0, 0.25);
        EXPECT_NEAR(offY, 0, 0.25);
        EXPECT_NEAR(contrast, 1, 0.2);
    }
}

// Where little of the water's bend is left to waves that rays see, under a low sun: light that waves bend
// strays farther along its way than across. They run at half a right angle to it, so that they make no such
// difference themselves.
TEST_F(Caustics, AreBlurredAlongTheSunMoreThanAcross) {
    sea_.samples = 32;
    sea_.windDirection = static_cast<float>(std::numbers::pi / 4);
    lighting.toSun[0] = 0.96;
    lighting.toSun[1] = 0.28;
    lighting.toSun[2] = 0;
    Body* const body = makeBody(desc_);
    const std::vector<double> light = factors(body, -6);
    constexpr size_t lag = 8; // [pixel]
    double along = 0, across = 0;
    for (size_t y = 0; y + lag < 256; ++y)
        for (size_t x = 0; x + lag < 256; ++x) {
            const double here = light[y * 256 + x];
            along += std::pow(light[y * 256 + x + lag] - here, 2);
            across += std::pow(light[(y + lag) * 256 + x] - here, 2);
        }
    std::printf("light changes along the sun by %.3f of what it does across\n", std::sqrt(along / across));
    EXPECT_LT(std::sqrt(along / across), 1);
}

// As a bed's picture is, which is larger than the view's.
TEST_F(Caustics, AreTheSameInALargerPicture) {
    Body* const body = makeBody(desc_);
    const std::vector<double> small = factors(body, -1.5), large = factors(body, -1.5, 2, 2);
    ASSERT_EQ(large.size(), 4 * small.size());
    constexpr size_t border = 8; // where means take what lies beyond the picture for what lies within
    for (size_t y = border; y < 256 - border; ++y)
        for (size_t x = border; x < 256 - border; ++x)
            ASSERT_NEAR(small[y * 256 + x], large[(y + 128) * 512 + x + 128], 0.01) << x << ' ' << y;
}

// Waves send as much light over a border of the picture as comes in over it.
// As bright at its last pixels as amid it, beside which nothing takes light.
TEST_F(Caustics, OfAlmostStillWaterLeaveABedsEndAsItIs) {
    sea_.amplitude = 0.001f;
    Body* const body = makeBody(desc_);
    const Camera camera = above(-8);
    SceneBehind half = planeBelow(camera, -8, 1);
    for (size_t i = 0; i < half.depth.size(); ++i)
        if (i % camera.width >= camera.width / 2) half.depth[i] = 0;
    const std::vector<double> light = factors(body, camera, half);
    double least = 2, most = 0;
    for (size_t i = 0; i < light.size(); ++i) {
        const size_t x = i % camera.width, y = i / camera.width;
        if (x >= camera.width / 2 || x < 40 || y < 40 || y + 40 > camera.height) continue;
        least = std::min(least, light[i]);
        most = std::max(most, light[i]);
    }
    std::printf("%.3f to %.3f of what calm water lets through\n", least, most);
    EXPECT_GT(least, 0.95);
    EXPECT_LT(most, 1.05);
}

TEST_F(Caustics, LoseNoLightOverThePicturesBorders) {
    Body* const body = makeBody(desc_);
    constexpr size_t side = 256, strip = 3; // [pixel]
    double sums[4] = {};
    constexpr int times = 6;
    for (int time = 0; time < times; ++time) {
        const std::vector<double> light = factors(body, -8, 3.0 * time);
        for (size_t a = 0; a < strip; ++a)
            for (size_t b = 0; b < side; ++b) {
                sums[0] += light[b * side + a];
                sums[1] += light[b * side + side - 1 - a];
                sums[2] += light[a * side + b];
                sums[3] += light[(side - 1 - a) * side + b];
            }
    }
    for (double& sum : sums) sum /= times * strip * side;
    std::printf("left %.3f, right %.3f, top %.3f, bottom %.3f\n", sums[0], sums[1], sums[2], sums[3]);
    for (const double sum : sums) EXPECT_NEAR(sum, 1, 0.07);
}

// A rope between the surface and a bed far below: which rays go past it the picture does not tell, so that it
// keeps its own.
TEST_F(Caustics, WhatIsThinKeepsItsOwnLight) {
    const Camera camera = above(-12);
    SceneBehind behind = planeBelow(camera, -12, 1);
    const SceneBehind rope = planeBelow(camera, -3, 1);
    constexpr uint32_t row = 100, rows = 2;
    for (uint32_t y = row; y < row + rows; ++y)
        std::copy_n(&rope.depth[size_t{y} * camera.width], camera.width,
                    &behind.depth[size_t{y} * camera.width]);
    Body* const body = makeBody(desc_);
    double sum = 0;
    for (int time = 0; time < 4; ++time) {
        const std::vector<double> light = factors(body, camera, behind, 3.0 * time);
        for (uint32_t y = row; y < row + rows; ++y)
            for (uint32_t x = 0; x < camera.width; ++x) sum += light[size_t{y} * camera.width + x];
    }
    sum /= 4.0 * rows * camera.width;
    std::printf("the rope has %.3f of its light\n", sum);
    EXPECT_NEAR(sum, 1, 0.15);
}

/// A GPU stores light to images and halves them by a kernel; on CPU devices it is copied and blitted.
class CausticsOnBothDevices : public Caustics {
  protected:
    void TearDown() override {
        Caustics::TearDown();
        pretendDeviceType(VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM);
    }
    /// On a context of its own, view after view.
    std::vector<std::vector<double>> factorsOn(VkPhysicalDeviceType type,
                                               const std::vector<Camera>& cameras) {
        Caustics::TearDown();
        Caustics::SetUp();
        pretendDeviceType(type);
        useOwnContext();
        Body* const body = makeBody(desc_);
        spiedCalls().clear();
        std::vector<std::vector<double>> seen;
        for (const Camera& camera : cameras) seen.push_back(factors(body, camera, -1.5));
        return seen;
    }
};

// Of pictures that halve without rest: a GPU's are rounded up to such, a CPU device's are not.
TEST_F(CausticsOnBothDevices, AreTheSame) {
    Camera aslant;
    aslant.eye = {3, 4, 7};
    aslant.target = {5, 0, 3};
    aslant.width = 256;
    aslant.height = 192;
    aslant.rollDegrees = 20;
    Camera smaller = aslant; // in the larger one's picture
    smaller.width = 150;
    smaller.height = 75;
    for (const uint32_t step : {1u, 2u}) {
        desc_.shading.causticStep = step;
        const auto copied = factorsOn(VK_PHYSICAL_DEVICE_TYPE_CPU, {aslant, smaller});
        const size_t copies = countSpied("CmdCopyBufferToImage");
        EXPECT_GT(countSpied("CmdBlitImage"), 0u);
        const auto stored = factorsOn(VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, {aslant, smaller});
        EXPECT_EQ(countSpied("CmdCopyBufferToImage") + 2, copies) << "one a view";
        EXPECT_EQ(countSpied("CmdBlitImage"), 0u);
        for (size_t view = 0; view < copied.size(); ++view) {
            ASSERT_EQ(copied[view].size(), stored[view].size());
            double most = 0; // of the brighter one
            for (size_t i = 0; i < copied[view].size(); ++i) {
                const double off = std::abs(copied[view][i] - stored[view][i]);
                most = std::max(most, off / std::max({copied[view][i], stored[view][i], 1.0}));
            }
            std::printf("step %u, view %zu: apart by %.1e, deviation %.2f\n", step, view, most,
                        deviationOf(copied[view]));
            EXPECT_GT(deviationOf(copied[view]), 0.1);
            EXPECT_LT(most, 2e-3) << "four roundings to halves";
        }
    }
}

// The pass leaves out what lines of sight show that do not point down.
TEST_F(Caustics, ReachAsFarAsTheBedIsSeenHoweverTheCameraIsTurned) {
    Body* const body = makeBody(desc_);
    Camera camera;
    camera.eye = {3, 2, 7};
    camera.width = 160;
    camera.height = 96;
    int pictures = 0;
    for (const double pitch : {-90.0, -60.0, -25.0, 0.0, 20.0})
        for (const double roll : {0.0, 35.0, 90.0, 180.0, -125.0})
            for (const glm::dvec2 offCentre : {glm::dvec2(0), glm::dvec2(0.3, -0.4)}) {
                const double turned = pitch * std::numbers::pi / 180;
                camera.target = camera.eye + glm::dvec3(0.01, std::sin(turned), std::cos(turned));
                camera.rollDegrees = roll;
                camera.offCentre = offCentre;
                camera.reversed = offCentre.x == 0;
                const std::vector<double> light = factors(body, camera, -1);
                size_t near = 0, left = 0;
                for (uint32_t y = 0; y < camera.height; ++y)
                    for (uint32_t x = 0; x < camera.width; ++x) {
                        const bool shows = angleBelowHorizon(camera, x, y) > 0.03;
                        near += shows;
                        left += shows && light[size_t{y} * camera.width + x] == 1;
                    }
                // An H200 rounds faint light to none in up to 2.3 % of them.
                EXPECT_LE(static_cast<double>(left), static_cast<double>(near) * limitOnDriver(0.005, 0.03))
                    << pitch << ' ' << roll << ' ' << offCentre.x << ": of " << near;
                pictures += near > 500;
            }
    EXPECT_GE(pictures, 48);
}

TEST_F(Caustics, LieAboveAnEyeBelowTheSurfaceToo) {
    Camera camera;
    camera.eye = {3, -3, 7};
    camera.target = {3, -3, 0};
    camera.width = 160;
    camera.height = 96;
    const SceneBehind wall = {
        std::vector<float>(size_t{160} * 96 * 4, 1),
        std::vector<float>(size_t{160} * 96, depthOf(camera, camera.eye - glm::dvec3(0, 0, 3)))};
    const std::vector<double> light = factors(makeBody(desc_), camera, wall);
    EXPECT_LT(std::ranges::count(light, 1.0), 160 * 96 / 200);
}

TEST_F(Caustics, FadeAsTheWaterScattersTheBeam) {
    const double depth = 3;
    const double path = depth / std::sqrt(1 - (1 - 0.8 * 0.8) / (1.333 * 1.333)); // of the bent ray
    const std::vector<double> clear = factors(makeBody(desc_), -depth);
    // No more than its molecules, which scatter as much forwards; then with particles besides.
    for (float& channel : refraction_.backscatter) channel = 0.0009f;
    const std::vector<double> pure = factors(makeBody(desc_), -depth);
    for (float& channel : refraction_.backscatter) channel = 0.0061f;
    const std::vector<double> murky = factors(makeBody(desc_), -depth);
    refraction_.backscatter[1] = 0;
    caustics_.strength = 0.25f;
    const std::vector<double> weak = factors(makeBody(desc_), -depth);
    for (size_t i = 0; i < clear.size(); i += 97) {
        EXPECT_NEAR(pure[i] - 1, (clear[i] - 1) * std::exp(-2 * 0.0009 * path), 2e-3);
        const double scattered = 2 * 0.00095 + (0.0061 - 0.00095) / 0.0183; // in green
        EXPECT_NEAR(murky[i] - 1, (clear[i] - 1) * std::exp(-scattered * path), 2e-3);
        EXPECT_NEAR(weak[i] - 1, 0.25 * (clear[i] - 1), 2e-3);
    }
}

TEST_F(Caustics, CostNothingWhereTheyAreNotAskedForOrNotSeen) {
    Body* asked = makeBody(desc_);
    desc_.caustics = nullptr;
    Body* unasked = makeBody(desc_);
    desc_.caustics = &caustics_;
    sea_.windSpeed = 0;
    Body* flat = makeBody(desc_);
    const auto draws = [&](Body* body) {
        spiedCalls().clear();
        factors(body, -2);
        return countSpied("CmdDraw") + countSpied("CmdDispatch") + countSpied("CmdDrawIndexed");
    };
    EXPECT_EQ(draws(unasked), wavesMips());
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
    EXPECT_EQ(draws(flat), 0u);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
    // Rays, what they leave, its mips, its blur, and the pass over the scene.
    const size_t all = 4 + onGpus(1) + wavesMips();
    EXPECT_EQ(draws(asked), all);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 1u);
    EXPECT_EQ(draws(asked), all);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
    EXPECT_EQ(countSpied("CmdDispatch"), all - 1);
    lighting.toSun[1] = -0.8;
    EXPECT_EQ(draws(asked), wavesMips()) << "the sun is down";
}

// As a bed's picture and the view it is for follow on each other, frame after frame.
TEST_F(Caustics, KeepThePictureOfTheLargestView) {
    Body* const body = makeBody(desc_);
    const std::vector<double> large = factors(body, -1.5, 2, 2);
    const std::vector<double> small = factors(body, -1.5);
    spiedCalls().clear();
    EXPECT_EQ(factors(body, -1.5, 2, 2), large);
    EXPECT_EQ(factors(body, -1.5), small);
    EXPECT_EQ(countSpied("CreateBuffer"), 0u);
    // The rest of a larger picture counts for nothing, but for how light ends at the border.
    const std::vector<double> alone = factors(makeBody(desc_), -1.5);
    constexpr size_t border = 8;
    for (size_t y = border; y < 256 - border; ++y)
        for (size_t x = border; x < 256 - border; ++x)
            ASSERT_NEAR(small[y * 256 + x], alone[y * 256 + x], 0.005) << x << ' ' << y;
}

TEST_F(Caustics, AreNotDrawnThatWereNotCast) {
    Body* body = makeBody(desc_);
    const auto refused = [&](const auto& cast) {
        Status status = Status::ok;
        drawCausticsOf(body);
        const auto castRight = beforeDrawing;
        beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& view) {
            return cast(castRight, commands, view);
        };
        const auto draws = drawing;
        drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            status = draws(commands, target, view);
            return Status::ok;
        };
        picture({body}, above(-1.5), 2, SurfaceOutput::shaded, planeBelow(above(-1.5), -1.5, 1));
        beforeDrawing = nullptr;
        drawing = nullptr;
        return status != Status::ok && message().find("castCaustics() was not called") != std::string::npos;
    };
    EXPECT_FALSE(refused(
        [](const auto& right, auto commands, const ViewDesc& view) { return right(commands, view); }));
    EXPECT_TRUE(refused([](const auto&, auto, const ViewDesc&) { return Status::ok; })) << "in this frame";
    EXPECT_TRUE(refused([](const auto& right, auto commands, ViewDesc other) {
        other.viewport.width /= 2;
        return right(commands, other);
    })) << "of this view";
}

TEST_F(Caustics, BadFieldsAreNamed) {
    const auto expectRefused = [&](const char* field) {
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc_, &body), Status::invalidArgument) << field;
        EXPECT_NE(message().find(field), std::string::npos) << message();
    };
    for (const float strength : {-0.1f, 1.1f, NAN}) {
        caustics_.strength = strength;
        expectRefused("CausticsDesc.strength");
    }
    caustics_.strength = 1;
    desc_.refraction = nullptr;
    expectRefused("BodyDesc.caustics needs");
    desc_.refraction = &refraction_;
    desc_.waves = nullptr;
    expectRefused("BodyDesc.caustics needs");
}

} // namespace
