// Refraction without the scene's images: endlessly deep water of its coefficients' colour.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class DeepWater : public WaterTest {
  protected:
    DeepWater() {
        camera_.eye = {3, 4, 7};
        camera_.target = {3, 2, -3};
        lighting.toSun[0] = 0.6;
        lighting.toSun[1] = 0.8;
        for (float& channel : lighting.skyIrradiance) channel = 2;
        for (float& channel : lighting.sunIrradiance) channel = 5;
        refraction_.backscatter[1] = 0.02f;
        refraction_.scattering = 0.1f;
    }

    Body* body(const SeaDesc* sea, const FoamDesc* foam = nullptr) {
        BodyDesc desc;
        desc.waves = sea;
        desc.wavesBackend = fftwWaves();
        desc.foam = foam;
        desc.refraction = &refraction_;
        return makeBody(desc);
    }

    /// Of both pictures' channels, over the pixels that water covers: no pixel of one alone.
    void expectAlike(const WaterPicture& a, const WaterPicture& b) {
        size_t covered = 0;
        double worst = 0, brightest = 0;
        for (size_t i = 0; i < a.color.size(); ++i) {
            ASSERT_EQ(a.covered(i / 4), b.covered(i / 4));
            if (!a.covered(i / 4)) continue;
            ++covered;
            worst = std::max(worst, std::abs(double{a.color[i]} - double{b.color[i]}));
            if (i % 4 != 3) brightest = std::max(brightest, double{a.color[i]});
        }
        EXPECT_GT(covered, 50000u);
        EXPECT_GT(brightest, 0.1);
        EXPECT_LT(worst, 1e-4 * brightest);
    }

    static void takeScene(ViewDesc& view) { view.sceneColor = view.sceneDepth = {}; }

    Camera camera_;
    RefractionDesc refraction_;
};

// What it stands for: a scene that is nowhere nearer than the far plane.
TEST_F(DeepWater, IsThatOverASceneAtTheFarPlane) {
    const SeaDesc sea = breeze();
    const FoamDesc foam{.bias = 0.2f};
    for (Body* const water : {body(nullptr), body(&sea), body(&sea, &foam)}) {
        changeView = nullptr;
        const WaterPicture far = picture({water}, camera_, 3);
        changeView = takeScene;
        expectAlike(picture({water}, camera_, 3), far);
    }
}

TEST_F(DeepWater, HasItsCoefficientsColour) {
    changeView = takeScene;
    const WaterPicture greenish = picture({body(nullptr)}, camera_);
    refraction_.backscatter[1] = 0;
    const WaterPicture without = picture({body(nullptr)}, camera_);
    // E / pi x 0.33 b / (a + b) x 0.98 / n^2, less what Fresnel mirrors.
    const double light = 2 * 0.934 + 5 * 0.8 * 0.97, k = 0.0622 + 0.02;
    const double glow = light / std::numbers::pi * 0.33 * 0.02 / k * 0.98 / (1.333 * 1.333);
    const size_t lowest = (size_t{camera_.height - 1} * camera_.width + camera_.width / 2) * 4;
    ASSERT_TRUE(greenish.covered(lowest / 4));
    const double more = double{greenish.color[lowest + 1]} - double{without.color[lowest + 1]};
    EXPECT_NEAR(more, glow * 0.95, 0.04 * glow);
    EXPECT_EQ(greenish.color[lowest], without.color[lowest]);
}

TEST_F(DeepWater, WantsBothImagesOrNone) {
    Body* const water = body(nullptr);
    const auto expectRefused = [&](void (*change)(ViewDesc&), const char* words) {
        changeView = change;
        drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            EXPECT_EQ(draw(commands, target, &water, 1, &view, &lighting), Status::invalidArgument);
            EXPECT_NE(message().find(words), std::string::npos) << message();
            return Status::ok;
        };
        picture({water}, camera_);
    };
    expectRefused([](ViewDesc& view) { view.sceneDepth = {}; }, "ViewDesc.sceneDepth.view is null");
    expectRefused([](ViewDesc& view) { view.sceneColor = {}; }, "ViewDesc.sceneColor.view is null");
}

// What looks for something in the scene says so.
TEST_F(DeepWater, PartsThatReadTheSceneRefuseToDoWithout) {
    const SeaDesc sea = breeze();
    const UnderwaterDesc underwater;
    const BedDesc bed;
    const CausticsDesc caustics;
    const auto expectRefused = [&](const char* words, const auto& change) {
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        desc.refraction = &refraction_;
        change(desc);
        Body* const water = makeBody(desc);
        changeView = takeScene;
        drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
            EXPECT_EQ(desc.caustics ? drawCaustics(commands, target, &water, 1, &view, &lighting)
                                    : draw(commands, target, &water, 1, &view, &lighting),
                      Status::invalidArgument);
            EXPECT_NE(message().find(words), std::string::npos) << message();
            return Status::ok;
        };
        picture({water}, camera_);
    };
    expectRefused("BodyDesc.underwater", [&](BodyDesc& desc) { desc.underwater = &underwater; });
    expectRefused("BodyDesc.bed", [&](BodyDesc& desc) { desc.bed = &bed; });
    expectRefused("BodyDesc.caustics", [&](BodyDesc& desc) { desc.caustics = &caustics; });
}

TEST_F(DeepWater, MirrorsTheSkyUnlessTheSceneIsThere) {
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::ssr,
                                                ReflectionTechnique::hybrid, ReflectionTechnique::sky}) {
        ReflectionDesc reflection;
        reflection.technique = technique;
        BodyDesc desc;
        desc.refraction = &refraction_;
        desc.reflection = &reflection;
        Body* const water = makeBody(desc);
        ViewDesc view = viewDesc(camera_);
        frame([&](VkCommandBuffer commands) {
            const bool reads = technique != ReflectionTechnique::sky;
            EXPECT_EQ(reflect(commands, &water, 1, &view), reads ? Status::invalidArgument : Status::ok);
            if (reads) {
                EXPECT_NE(message().find("ViewDesc.sceneDepth.view is null"), std::string::npos);
            }
        });
    }
}

} // namespace
