// Spray: from breaking crests alone, the same whatever was drawn before, never brighter than what lights it.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/light/encoded_light.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr float radiance = 0.5f;

class Spray : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        sea_.windSpeed = 24;
        sea_.fetch = 100e3f;
        sea_.samples = 64;
        sea_.cascades = 3;
        camera_.eye = {0, 7, 0};
        camera_.target = {10, 4, -20};
        lighting.skyCube = VK_NULL_HANDLE;
        for (int i = 0; i < 3; ++i) {
            lighting.skyZenith[i] = lighting.skyHorizon[i] = radiance;
            lighting.skyIrradiance[i] = radiance * 3.14159265f;
        }
    }

    BodyDesc described(bool sprays = true) const {
        BodyDesc desc;
        desc.waves = &sea_;
        desc.wavesBackend = fftwWaves();
        desc.foam = &foam_;
        if (sprays) desc.spray = &spray_;
        desc.plane[0] = lean_;
        desc.extent.planetRadius = planetRadius_;
        return desc;
    }
    WaterPicture drawn(bool sprays, double time, const Camera& camera) {
        return picture({makeBody(described(sprays))}, camera, time);
    }

    /// What spray changes.
    struct Spread {
        double cover = 0;     ///< share of the pixels, by more than 1 % of the sky's radiance
        double mean = 0;      ///< of all, in the sky's radiance
        double brightest = 0; ///< of those
    };
    Spread spread(double time, const Camera& camera) {
        const WaterPicture with = drawn(true, time, camera), without = drawn(false, time, camera);
        Spread sum;
        for (size_t i = 0; i < with.color.size(); i += 4) {
            const double apart = std::abs(double{with.color[i]} - double{without.color[i]});
            if (apart == 0 || !without.covered(i / 4)) continue;
            sum.cover += apart > 0.01 * double{radiance};
            sum.mean += apart / double{radiance};
            sum.brightest = std::max(sum.brightest, double{with.color[i]});
        }
        sum.cover /= static_cast<double>(with.color.size() / 4);
        sum.mean /= static_cast<double>(with.color.size() / 4);
        return sum;
    }

    /// What spray makes of each pixel's red.
    std::vector<double> changes(Body& with, Body& without, const Camera& camera, double time) {
        const WaterPicture sprayed = picture({&with}, camera, time), bare = picture({&without}, camera, time);
        std::vector<double> change(sprayed.color.size() / 4);
        for (size_t i = 0; i < change.size(); ++i)
            change[i] = std::abs(double{sprayed.color[4 * i]} - double{bare.color[4 * i]});
        return change;
    }
    /// Of each pixel, the share of the air behind it that spray hides from an eye 2 m up; 0 before water.
    std::vector<double> hiddenAir(Camera camera, double place) {
        camera.eye = {place, 2, 0};
        camera.target = {place, 3, -20};
        const WaterPicture p = drawn(true, 12, camera);
        std::vector<double> hidden(p.color.size() / 4);
        for (size_t i = 0; i < hidden.size(); ++i)
            if (p.color[4 * i] < 0) hidden[i] = 1 - double{p.color[4 * i]} / double{WaterPicture::untouched};
        return hidden;
    }

    Camera straightDown(double height) const {
        Camera camera = camera_;
        camera.eye = {0, height, 0};
        camera.target = {0, 0, 0};
        camera.width = camera.height = 192;
        return camera;
    }

    /// Of so small a part of the sea it takes many to know what spray does in the mean.
    static constexpr double times_[] = {5, 9, 14, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80};
    /// Of eyes before which there is spray.
    static constexpr double places_[] = {111, 333, 610, 777};
    SeaDesc sea_;
    FoamDesc foam_;
    SprayDesc spray_;
    double lean_ = 0, planetRadius_ = 0;
    Camera camera_;
};

TEST_F(Spray, IsTheSameWhateverWasDrawnBefore) {
    Body* const watched = makeBody(described());
    const Camera aside = straightDown(30);
    for (const double time : {11.0, 11.4, 200.0, 11.9}) picture({watched}, aside, time);
    const WaterPicture late = picture({watched}, camera_, 12), early = drawn(true, 12, camera_);
    EXPECT_TRUE(late.color == early.color);
    EXPECT_GT(spread(12, camera_).cover, 0.01);
}

TEST_F(Spray, MovesWithTheTime) {
    Body* const body = makeBody(described());
    EXPECT_FALSE(picture({body}, camera_, 12).color == picture({body}, camera_, 12.02).color);
}

// There is more foam upwind of spray than downwind of it, and more than anywhere.
TEST_F(Spray, BlowsOffBreakingCrests) {
    sea_.windSpeed = 18; // to the right
    const Camera camera = straightDown(60);
    Body *const with = makeBody(described()), *const without = makeBody(described(false));
    double all = 0, upwind = 0, downwind = 0, anywhere = 0, pixels = 0;
    for (const double time : times_) {
        const WaterPicture sprayed = picture({with}, camera, time), bare = picture({without}, camera, time),
                           foam = picture({without}, camera, time, SurfaceOutput::foam);
        const auto size = static_cast<size_t>(camera.width);
        constexpr size_t along = 40; // 12 m
        const auto meanFrom = [&](size_t y, size_t x) {
            double sum = 0;
            for (size_t i = 0; i < along; ++i) sum += double{foam.color[(y * size + x + i) * 4]} / along;
            return sum;
        };
        for (size_t y = 0; y < size; ++y)
            for (size_t x = along; x < size - along; ++x) {
                const size_t i = (y * size + x) * 4;
                const double change = std::abs(double{sprayed.color[i]} - double{bare.color[i]});
                if (change > 0) {
                    upwind += change * meanFrom(y, x - along);
                    downwind += change * meanFrom(y, x);
                }
                all += change;
                anywhere += double{foam.color[i]};
                pixels += 1;
            }
    }
    std::printf("foam upwind of spray %.4f, downwind %.4f, anywhere %.4f\n", upwind / all, downwind / all,
                anywhere / pixels);
    EXPECT_GT(upwind, 1.3 * downwind);
    EXPECT_GT(upwind / all, 1.5 * anywhere / pixels);
}

// As far from picture to picture as what is seen straight from above is most alike.
TEST_F(Spray, DriftsWithTheAir) {
    sea_.windSpeed = 18; // to the right
    const Camera camera = straightDown(60);
    const double metresPerPixel = 60 * 2 * std::tan(radians(camera.fovDegrees) / 2) / camera.height;
    Body *const with = makeBody(described()), *const without = makeBody(described(false));
    constexpr double step = 0.3;
    constexpr size_t farthest = 48; // pixels
    std::vector<double> alike(farthest);
    for (const double time : times_) {
        const std::vector<double> before = changes(*with, *without, camera, time),
                                  after = changes(*with, *without, camera, time + step);
        for (size_t shift = 0; shift < farthest; ++shift)
            for (size_t i = 0; i + shift < before.size(); ++i)
                if (i % camera.width + shift < camera.width) alike[shift] += before[i] * after[i + shift];
    }
    for (size_t shift = 0; shift < farthest; ++shift) // means of as many as there are
        alike[shift] /= static_cast<double>(camera.width - shift);
    const auto most = static_cast<size_t>(std::ranges::max_element(alike) - alike.begin());
    const double speed = static_cast<double>(most) * metresPerPixel / step;
    std::printf("%zu pixels, %.2f m/s\n", most, speed);
    EXPECT_NEAR(speed, 0.65 * double{sea_.windSpeed},
                1.3); // slower by what drops lag, and less high than 10 m
}

// By parallel lines of sight, which tell heights.
TEST_F(Spray, FliesOffCrestsAndFalls) {
    Camera aside = camera_;
    aside.eye = {0, 3, 60};
    aside.target = {0, 3, 0};
    aside.parallelHeight = 30;
    aside.far = 200;
    const auto heightOf = [&](size_t row) {
        return 3 + (0.5 - (static_cast<double>(row) + 0.5) / aside.height) * aside.parallelHeight;
    };
    double sum = 0, count = 0, highest = -100, crest = -100;
    for (const double time : {5.0, 9.0, 14.0}) {
        const WaterPicture with = drawn(true, time, aside), without = drawn(false, time, aside);
        for (size_t i = 0; i < with.color.size() / 4; ++i) {
            const double height = heightOf(i / aside.width);
            if (without.covered(i)) crest = std::max(crest, height);
            if (with.color[4 * i] == without.color[4 * i]) continue;
            sum += height;
            count += 1;
            highest = std::max(highest, height);
        }
    }
    std::printf("%.0f pixels, %.2f m high in the mean, %.2f at most, crests %.2f\n", count, sum / count,
                highest, crest);
    EXPECT_GT(count, 500);
    EXPECT_GT(sum / count, 0.4);
    EXPECT_LT(sum / count, 1.0);
    EXPECT_LT(highest, crest + 5);
}

// No whitecaps, no spray, however strong the wind.
TEST_F(Spray, IsNotThereWhereNothingBreaks) {
    foam_.bias = -0.35f;
    EXPECT_EQ(spread(12, camera_).cover, 0);
}

TEST_F(Spray, TakesAWindThatTearsDropsOff) {
    const auto drawsOf = [&](float wind) {
        sea_.windSpeed = wind;
        Body* const body = makeBody(described());
        spiedCalls().clear();
        picture({body}, camera_, 12);
        return countSpied("CmdDraw");
    };
    EXPECT_EQ(drawsOf(8.9f), 1u) << "of the surface, which is placed";
    EXPECT_EQ(drawsOf(9.5f), 2u);
    spray_.density = 0;
    EXPECT_EQ(drawsOf(24), 1u);
}

TEST_F(Spray, GrowsWithTheWind) {
    double before = 0;
    for (const float wind : {12.0f, 18.0f, 28.0f}) {
        sea_.windSpeed = wind;
        const double mean = spread(12, camera_).mean;
        std::printf("%.0f m/s: %.5f of the sky's light\n", double{wind}, mean);
        EXPECT_GT(mean, 1.5 * before);
        before = mean;
    }
    EXPECT_LT(before, 0.15) << "a veil over all";
}

// About as much of it, however the water lies and is looked at.
TEST_F(Spray, IsOnTiltedSeasOnGlobesAndBeforeParallelLines) {
    const double level = spread(12, camera_).mean;
    EXPECT_GT(level, 0.005);
    lean_ = 0.02;
    EXPECT_NEAR(spread(12, camera_).mean / level, 1, 0.5);
    lean_ = 0;
    planetRadius_ = 6.371e6;
    EXPECT_NEAR(spread(12, camera_).mean / level, 1, 0.05);
    planetRadius_ = 0;
    Camera steep = camera_;
    steep.eye = {0, 40, 0};
    steep.target = {10, 0, -20};
    steep.fovDegrees = 40;
    const double fromAnEye = spread(12, steep).mean;
    steep.parallelHeight = 0.73 * glm::length(steep.eye - steep.target);
    steep.far = 200;
    const double byParallelLines = spread(12, steep).mean;
    std::printf("level %.5f; from an eye %.5f, by parallel lines %.5f\n", level, fromAnEye, byParallelLines);
    EXPECT_GT(byParallelLines / fromAnEye, 0.5);
    EXPECT_LT(byParallelLines / fromAnEye, 2);
}

// Under an even sky no cloud shines brighter than that.
TEST_F(Spray, IsNoBrighterThanWhatLightsIt) {
    spray_.density = 4;
    foam_.albedo = 0;
    const Spread all = spread(12, camera_);
    EXPECT_GT(all.cover, 0.02);
    EXPECT_LE(all.brightest, double{radiance} * 1.001);
}

/// By how much a picture's values depart from their means over so many pixels to each side, of all of them.
double unevenness(const std::vector<double>& values, const Camera& camera, int64_t reach) {
    const auto width = static_cast<int64_t>(camera.width), height = static_cast<int64_t>(camera.height);
    const auto at = [&](int64_t x, int64_t y) { return values[static_cast<size_t>(y * width + x)]; };
    const auto pixels = static_cast<double>((2 * reach + 1) * (2 * reach + 1));
    double uneven = 0, all = 0;
    for (int64_t y = reach; y < height - reach; ++y)
        for (int64_t x = reach; x < width - reach; ++x) {
            double mean = 0;
            for (int64_t v = -reach; v <= reach; ++v)
                for (int64_t u = -reach; u <= reach; ++u) mean += at(x + u, y + v) / pixels;
            uneven += std::abs(at(x, y) - mean);
            all += at(x, y);
        }
    return all > 0 ? uneven / all : 0;
}

// Clouds overlap, so that none is a ball of cotton. Over dark foam: white foam hides what covers it, in
// patches of its own.
TEST_F(Spray, IsAVeil) {
    foam_.albedo = 0;
    Body *const with = makeBody(described()), *const without = makeBody(described(false));
    double sum = 0;
    for (const double time : {12.0, 20.0, 30.0})
        sum += unevenness(changes(*with, *without, camera_, time), camera_, 4) / 3;
    std::printf("uneven by %.3f\n", sum);
    EXPECT_LT(sum, 0.31); // 0.304 today, 0.327 where the densest are no wider
}

// Eddies tear all clouds alike that overlap. Of each torn by its own the sum is a soft blot. Seen from above,
// where no wave hides what is behind it.
TEST_F(Spray, IsTornWhereCloudsOverlap) {
    foam_.albedo = 0;
    const Camera camera = straightDown(25);
    Body *const with = makeBody(described()), *const without = makeBody(described(false));
    double sum = 0;
    for (const double time : {12.0, 14.0, 20.0, 30.0, 50.0, 60.0})
        sum += unevenness(changes(*with, *without, camera, time), camera, 4) / 6;
    std::printf("uneven by %.3f\n", sum);
    EXPECT_GT(sum, 0.307); // 0.321 today, 0.293 where each cloud has its own noise
}

// Eddies flow on where their pattern begins again: at 18 m/s every 170.67 s.
TEST_F(Spray, FlowsOnWhereEddiesRepeat) {
    Body* const body = makeBody(described());
    Camera camera = camera_;
    camera.eye.x = 777;
    camera.target.x = 787;
    // Wind blows along x.
    const double wraps = (777 + 3 * 3072) / 18.0;
    const auto changeAround = [&](double time) {
        const WaterPicture before = picture({body}, camera, time - 0.002);
        const WaterPicture after = picture({body}, camera, time + 0.002);
        double sum = 0;
        for (size_t i = 0; i < before.color.size(); i += 4)
            sum += std::abs(double{after.color[i]} - double{before.color[i]});
        return sum;
    };
    const double usual = changeAround(wraps - 0.01), there = changeAround(wraps);
    std::printf("changes by %.4f, where the pattern begins again by %.4f\n", usual, there);
    EXPECT_LT(there, 1.3 * usual);
}

// A cloud right before the eye would hide half of the picture. Elsewhere a metre of the way holds about as
// much as another.
TEST_F(Spray, IsNoCloudRightBeforeTheEye) {
    // Of what lies between, the share of the air that it hides.
    const auto hiddenBetween = [&](double near, double far) {
        Camera camera = camera_;
        camera.near = near;
        camera.far = far;
        double sum = 0;
        for (const double place : places_)
            for (const double hidden : hiddenAir(camera, place)) sum += hidden;
        return sum / (4.0 * camera.width * camera.height);
    };
    const double before = hiddenBetween(0.1, 4), beyond = hiddenBetween(9, 12);
    std::printf("%.5f of the picture up to 4 m, %.5f from 9 to 12 m\n", before, beyond);
    EXPECT_GT(beyond, 5e-4);
    EXPECT_LT(before, 0.4 * beyond);
}

// Blended as displays take colour, it sends nearly as much.
TEST_F(Spray, SendsAsMuchLightIntoEncodedColor) {
    const auto changeBy = [&](Encoding encoding) {
        useEncoding(encoding);
        double sum = 0;
        for (const double time : {5.0, 12.0})
            sum += lightAdded(drawn(true, time, camera_), drawn(false, time, camera_), encoding);
        return sum;
    };
    const double linear = changeBy(Encoding::linear), held = changeBy(Encoding::srgb);
    std::printf("light of spray in encoded colour is %.3f of that in linear\n", held / linear);
    EXPECT_NEAR(held / linear, 0.85, 0.25); // 0.35 where it hides as what sends no light
}

// Where nothing else is seen through it.
TEST_F(Spray, IsLostInThickFog) {
    const double clear = spread(12, camera_).mean;
    FogDesc fog;
    fog.density = 1;
    for (float& channel : fog.color) channel = 0.3f;
    lighting.fog = &fog;
    const double foggy = spread(12, camera_).mean;
    std::printf("%.5f of the sky's light, %.6f in fog\n", clear, foggy);
    EXPECT_GT(clear, 0.005);
    EXPECT_LT(foggy, 0.01 * clear);
}

TEST_F(Spray, IsHiddenByWhatIsNearer) {
    const auto hiding = [&](bool sprays) {
        Body* const other = makeBody(described(sprays));
        shadeBefore(other);
        drawing = [this, other](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            const VkClearAttachment nearest = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, {.depthStencil = {1, 0}}};
            const VkClearRect left = {{{0, 0}, {camera_.width / 2, camera_.height}}, 0, 1};
            vkCmdClearAttachments(commands, 1, &nearest, 1, &left);
            return draw(commands, target, &other, 1, &view, &lighting);
        };
        return picture({other}, camera_, 12);
    };
    const WaterPicture with = hiding(true), without = hiding(false);
    size_t behind = 0, beside = 0;
    for (size_t i = 0; i < with.color.size() / 4; ++i) {
        const bool isLeft = i % camera_.width < camera_.width / 2;
        (isLeft ? behind : beside) += with.color[4 * i] != without.color[4 * i];
    }
    EXPECT_EQ(behind, 0u);
    EXPECT_GT(beside, 50u);
    EXPECT_TRUE(with.depth == without.depth);
}

// Drops that a crest's run leaves below the surface are not seen through the water by an eye in it.
TEST_F(Spray, IsInTheAir) {
    const RefractionDesc refraction;
    const UnderwaterDesc underwater;
    const auto diving = [&](bool sprays) {
        BodyDesc desc = described(sprays);
        desc.refraction = &refraction;
        desc.underwater = &underwater;
        return makeBody(desc);
    };
    Body *const with = diving(true), *const without = diving(false);
    // Pixels that spray changes, before an eye so high over the water.
    const auto changedFrom = [&](double time, double height) {
        const double at[2] = {places_[1], 0};
        HeightSample sample;
        sampleHeights(*seaglass::sea(with), time, at, 1, &sample);
        Camera camera = camera_;
        camera.eye = {at[0], double{sample.height} + height, at[1]};
        camera.target = camera.eye + glm::dvec3(0, 0.7, -20);
        return std::ranges::count_if(changes(*with, *without, camera, time),
                                     [](double change) { return change > 0; });
    };
    ptrdiff_t wet = 0, dry = 0;
    for (const double time : {12.0, 20.0}) {
        wet += changedFrom(time, -0.6);
        dry += changedFrom(time, 0.6);
    }
    std::printf("%td pixels before eyes in the water, %td before others\n", wet, dry);
    EXPECT_EQ(wet, 0);
    EXPECT_GT(dry, 50);
}

TEST_F(Spray, IsRefusedWhereItWouldBeWrong) {
    const auto refused = [&](const BodyDesc& desc, const char* why) {
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
        EXPECT_NE(message().find(why), std::string::npos) << message();
    };
    BodyDesc desc = described();
    desc.foam = nullptr;
    refused(desc, "BodyDesc.spray needs BodyDesc.foam");
    desc = described();
    desc.extent.shape = ExtentShape::rectangle;
    desc.extent.size[0] = desc.extent.size[1] = 50;
    refused(desc, "expected BodyDesc.extent to be unbounded");
    spray_.density = 5;
    refused(described(), "SprayDesc.density");
    spray_.density = 1;
    leaveDepth();
    Body* const body = makeBody(described());
    shadeBefore(body);
    drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
        EXPECT_EQ(draw(commands, target, &body, 1, &view, &lighting), Status::invalidArgument);
        EXPECT_NE(message().find("expected TargetDesc.depthWrite to be true"), std::string::npos)
            << message();
        return Status::ok;
    };
    picture({body}, camera_, 12);
}

} // namespace
