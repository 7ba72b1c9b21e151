// Hosts that hold colour as displays take it: what is drawn is the linear host's picture by the sRGB curve,
// and what is blended comes near it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <glm/gtc/packing.hpp>

#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// IEC 61966-2-1, going on above 1.
double encoded(double linear) {
    return linear > 0.0031308 ? 1.055 * std::pow(linear, 1 / 2.4) - 0.055 : 12.92 * std::max(linear, 0.0);
}

std::vector<float> encoded(const std::vector<float>& rgba) {
    std::vector<float> held = rgba;
    for (size_t i = 0; i < held.size(); ++i)
        if (i % 4 != 3) held[i] = static_cast<float>(encoded(double{rgba[i]}));
    return held;
}

class Encodings : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        for (float& channel : lighting.sunIrradiance) channel = 1.5f;
        for (float& channel : lighting.skyIrradiance) channel = 1;
        lighting.toSun[0] = 0.6;
        lighting.toSun[1] = 0.8;
        desc_.waves = &sea_;
        desc_.foam = &foam_;
        desc_.refraction = &refraction_;
        desc_.reflection = &reflection_;
        camera_.eye = {0, 1.5, 8};
        camera_.target = {0, 0, 0};
        camera_.width = 120;
        camera_.height = 80;
    }

    SceneBehind bedAndWall() const {
        const SceneBehind bed = planeBelow(camera_, -1, 0.4f * bright_);
        return drawnOver(camera_, bed, 0.8f * bright_,
                         [](const glm::dvec3& ray) { return ray.x > 0.1 ? 12 : -1; });
    }

    WaterPicture picture(Encoding encoding, SurfaceOutput output = SurfaceOutput::shaded) {
        useEncoding(encoding);
        SceneBehind behind = bedAndWall();
        if (encoding == Encoding::srgb) behind.color = encoded(behind.color);
        return WaterTest::picture({makeBody(desc_)}, camera_, 3, output, behind);
    }

    /// Of all pixels that water covers.
    void expectHeld(const WaterPicture& linear, const WaterPicture& held, double most) {
        ASSERT_EQ(linear.depth, held.depth);
        size_t covered = 0;
        double apart = 0;
        for (size_t i = 0; i < linear.color.size(); ++i) {
            if (i % 4 == 3 || !linear.covered(i / 4)) continue;
            ++covered;
            const double off = std::abs(encoded(double{linear.color[i]}) - double{held.color[i]});
            apart = off <= apart ? apart : off; // not a number wins
        }
        std::printf("%zu values, %.5f apart\n", covered, apart);
        EXPECT_GT(covered, linear.color.size() / 4);
        EXPECT_LE(apart, most);
    }

    void expectTheSame(double most = 2e-3) {
        const WaterPicture linear = picture(Encoding::linear);
        expectHeld(linear, picture(Encoding::srgb), most);
    }

    float bright_ = 1; ///< of bed and wall
    SeaDesc sea_ = breeze();
    FoamDesc foam_;
    RefractionDesc refraction_;
    ReflectionDesc reflection_;
    UnderwaterDesc underwater_;
    BedDesc bed_;
    CausticsDesc caustics_;
    BodyDesc desc_;
    Camera camera_;
};

TEST_F(Encodings, OfSceneAndTargetAreUndoneAndDone) {
    for (const ReflectionTechnique technique :
         {ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        reflection_.technique = technique;
        reflection_.edgeReach = technique == ReflectionTechnique::hybrid ? 0.3f : 0;
        reflection_.overhangSamples = technique == ReflectionTechnique::hybrid ? 4 : 0;
        expectTheSame();
    }
}

// Down to where the curve begins with a line.
TEST_F(Encodings, OfDarkScenesAreUndone) {
    for (float* const light : {lighting.sunIrradiance, lighting.skyIrradiance}) std::fill_n(light, 3, 0.0f);
    for (const float bright : {0.2f, 0.02f, 0.002f}) {
        bright_ = bright;
        expectTheSame();
    }
}

TEST_F(Encodings, AreUndoneAndDoneUnderWater) {
    desc_.underwater = &underwater_;
    camera_.eye.y = -0.5;
    camera_.target.y = -0.2;
    expectTheSame();
    // Beside the line at the lens, which is blended.
    camera_.eye.y = camera_.target.y = 0;
    expectTheSame(0.03);
}

TEST_F(Encodings, AreOfBedPictures) {
    desc_.bed = &bed_;
    for (const uint32_t downscale : {1u, 2u}) {
        desc_.shading.bedDownscale = downscale;
        std::unique_ptr<DrawnBuffers> buffers;
        const auto drawn = [&](Encoding encoding) {
            useEncoding(encoding);
            Body* const body = makeBody(desc_);
            ViewDesc view = viewDesc(camera_);
            PlanarView wanted;
            EXPECT_EQ(bedView(body, &view, &wanted), Status::ok) << message();
            Drawn bedDrawn;
            for (uint32_t i = 0; i < wanted.extent.width * wanted.extent.height; ++i) {
                const double light = 0.1 + 0.8 * (i % wanted.extent.width) / wanted.extent.width;
                const auto held = static_cast<float>(encoding == Encoding::srgb ? encoded(light) : light);
                bedDrawn.color.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(held), 1)));
                bedDrawn.depth.push_back(0.02f);
            }
            buffers = std::make_unique<DrawnBuffers>(bedDrawn);
            beforeReflection = [&buffers, wanted](VkCommandBuffer commands) {
                recordDrawing(commands, wanted, *buffers);
            };
            SceneBehind behind = bedAndWall();
            if (encoding == Encoding::srgb) behind.color = encoded(behind.color);
            return WaterTest::picture({body}, camera_, 3, SurfaceOutput::shaded, behind);
        };
        const WaterPicture linear = drawn(Encoding::linear);
        expectHeld(linear, drawn(Encoding::srgb), 3e-3);
    }
}

TEST_F(Encodings, AreOfColorsAlone) {
    const WaterPicture linear = picture(Encoding::linear, SurfaceOutput::normal);
    EXPECT_EQ(linear.color, picture(Encoding::srgb, SurfaceOutput::normal).color);
    const WaterPicture mirrored = picture(Encoding::linear, SurfaceOutput::reflection);
    expectHeld(mirrored, picture(Encoding::srgb, SurfaceOutput::reflection), 2e-3);
}

// What is held is multiplied, by what is right amid the curve.
TEST_F(Encodings, ComeNearCausticsOfLinearColor) {
    desc_.caustics = &caustics_;
    sea_.windSpeed = 5;
    sea_.fetch = 2e3f;
    sea_.largestPatch = 16;
    refraction_ = {{0, 0, 0}, {0, 0, 0}, 1};
    std::ranges::fill(lighting.skyIrradiance, 0.0f);
    camera_.eye = {3, 4, 7};
    camera_.target = {3, 0, 7};
    const auto factors = [&](Encoding encoding) {
        useEncoding(encoding);
        Body* const body = makeBody(desc_);
        drawCausticsOf(body);
        return WaterTest::picture({body}, camera_, 3, SurfaceOutput::shaded, planeBelow(camera_, -1, 0.4f))
            .color;
    };
    const std::vector<float> linear = factors(Encoding::linear), held = factors(Encoding::srgb);
    double worst = 0, brightest = 0;
    for (size_t i = 0; i < linear.size(); ++i) {
        ASSERT_NE(held[i], WaterPicture::untouched);
        const double factor = double{linear[i]} / double{WaterPicture::untouched};
        if (i % 4 == 3) {
            EXPECT_NEAR(double{held[i]}, std::min(factor / 5, 0.992),
                        1e-4); // as shaders/gpu/encoding.glsl
            continue;
        }
        const double growth = double{held[i]} / double{WaterPicture::untouched};
        brightest = std::max(brightest, factor);
        if (factor > 2 || factor < 0.3) continue;
        for (const double light : {0.02, 0.1, 0.2, 0.4})
            worst = std::max(worst, std::abs(std::min(encoded(light * factor), 1.0) -
                                             std::min(encoded(light) * growth, 1.0)));
    }
    std::printf("at most %.1f of 255 off, of light %.2f times\n", 255 * worst, brightest);
    EXPECT_GT(brightest, 1.3);
    EXPECT_LT(worst, 5.0 / 255);
}

// A told depth of light is read back where the scene is encoded: see litBelow().
TEST_F(Encodings, TellWhatCausticsGathered) {
    desc_.caustics = &caustics_;
    const auto lit = [&](Encoding encoding, float told) {
        useEncoding(encoding);
        SceneBehind behind = bedAndWall();
        if (encoding == Encoding::srgb) behind.color = encoded(behind.color);
        for (size_t i = 3; i < behind.color.size(); i += 4) behind.color[i] = told;
        return WaterTest::picture({makeBody(desc_)}, camera_, 3, SurfaceOutput::shaded, behind);
    };
    const WaterPicture linear = lit(Encoding::linear, 1.5f);
    expectHeld(linear, lit(Encoding::srgb, 0.3f), 2e-3);
    expectHeld(lit(Encoding::linear, 1), lit(Encoding::srgb, 1), 2e-3);
    EXPECT_NE(linear.color, lit(Encoding::linear, 1).color);
}

struct Heard {
    std::vector<std::string> lines;
};

class EncodingMessages : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        std::string unused;
        DeviceDesc desc = deviceDesc(&unused);
        desc.message = {
            [](void* user, const char* text) { static_cast<Heard*>(user)->lines.emplace_back(text); },
            &heard_};
        ASSERT_EQ(createContext(&desc, &own_), Status::ok);
    }
    void TearDown() override {
        destroyContext(own_);
        GpuTest::TearDown();
    }

    Status make(VkFormat format, Encoding encoding) {
        TargetDesc desc;
        desc.colorFormat = format;
        desc.depthFormat = VK_FORMAT_D32_SFLOAT;
        desc.encoding = encoding;
        Target* target = nullptr;
        const Status s = createTarget(own_, &desc, &target);
        destroyTarget(target);
        return s;
    }

    Heard heard_;
    Context* own_ = nullptr;
};

TEST_F(EncodingMessages, AreOneForEachTargetOfUnormWithoutAWord) {
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_UNORM, Encoding::unspecified), Status::ok);
    ASSERT_EQ(heard_.lines.size(), 1u);
    EXPECT_EQ(heard_.lines[0].find("TargetDesc.colorFormat is UNORM"), 0u) << heard_.lines[0];
    EXPECT_EQ(make(VK_FORMAT_R8G8B8A8_UNORM, Encoding::unspecified), Status::ok);
    EXPECT_EQ(heard_.lines.size(), 2u);
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_UNORM, Encoding::linear), Status::ok);
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_UNORM, Encoding::srgb), Status::ok);
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_SRGB, Encoding::unspecified), Status::ok);
    EXPECT_EQ(make(VK_FORMAT_R16G16B16A16_SFLOAT, Encoding::unspecified), Status::ok);
    EXPECT_EQ(heard_.lines.size(), 2u);
}

TEST_F(EncodingMessages, RefuseWhatIsEncodedTwice) {
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_SRGB, Encoding::srgb), Status::invalidArgument);
    EXPECT_EQ(heard_.lines.back(),
              "TargetDesc.encoding is srgb, which TargetDesc.colorFormat applies by itself");
    EXPECT_EQ(make(VK_FORMAT_B8G8R8A8_UNORM, static_cast<Encoding>(3)), Status::invalidArgument);
    EXPECT_EQ(heard_.lines.back(),
              "TargetDesc.encoding is out of range, expected 0 to 2: unspecified, linear or srgb");
}

} // namespace
