// A body as an object: what it creates, estimates and refuses, and how it goes.
#include <algorithm>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/sea_rig.h"
#include "water/body/body.h"
#include "water/foam/foam_part.h"
#include "water/reflection/reflection_part.h"
#include "water/waves/waves_part.h"

namespace {

using namespace seaglass;
using namespace tests;

class BodyOfWater : public SeaTest {};

TEST_F(BodyOfWater, AFeatureThatIsOffIsNotThere) {
    Body* flat = flatBody();
    EXPECT_FALSE(flat->sea);
    EXPECT_FALSE(flat->find<WavesPart>());
    EXPECT_FALSE(flat->find<FoamPart>());
    EXPECT_FALSE(flat->find<ReflectionPart>());

    SeaDesc calm = breeze();
    calm.windSpeed = 0;
    BodyDesc desc;
    desc.waves = &calm;
    desc.wavesBackend = fftwWaves();
    Body* still = makeBody(desc);
    EXPECT_FALSE(still->find<WavesPart>());
    EXPECT_EQ(sea(still), nullptr);

    const FoamDesc foam;
    desc.foam = &foam;
    Body* stillFoam = makeBody(desc);
    calm.windSpeed = 1;
    for (Body* unbroken : {stillFoam, makeBody(desc)}) {
        EXPECT_FALSE(unbroken->find<FoamPart>());
    }

    ReflectionDesc sky;
    sky.technique = ReflectionTechnique::sky;
    BodyDesc skyOnly;
    skyOnly.reflection = &sky;
    EXPECT_FALSE(makeBody(skyOnly)->find<ReflectionPart>());
}

TEST_F(BodyOfWater, AFlatPondCreatesAndRecordsNextToNothing) {
    // What a context makes once, each frame slot, and a body for the view.
    Body* pond = flatBody();
    for (int slot = 0; slot < 2; ++slot) picture({pond}, seaCamera());
    spiedCalls().clear();
    picture({pond}, seaCamera());
    EXPECT_EQ(countSpied("CreateImage"), 0u);
    EXPECT_EQ(countSpied("AllocateMemory"), 0u);
    EXPECT_EQ(countSpied("CreateComputePipelines"), 0u);
    EXPECT_EQ(countSpied("CmdCopyBufferToImage"), 0u);
    // It is found, its tiles are listed in three steps, shaded and placed.
    EXPECT_EQ(countSpied("CmdDrawIndexed"), 1u);
    EXPECT_EQ(countSpied("CmdDispatch"), 3u);
    EXPECT_EQ(countSpied("CmdDispatchIndirect"), 1u);
    EXPECT_EQ(countSpied("CmdDraw"), 1u);
    EXPECT_LE(countSpied("CmdPipelineBarrier2"), 9u);
}

TEST_F(BodyOfWater, TheEstimateIsWhatIsAllocated) {
    makeBody({}); // what all bodies share
    const SeaDesc waves = breeze();
    const FoamDesc foam;
    const ReflectionDesc reflection;
    BodyDesc desc;
    const auto agrees = [&](const char* what) {
        Estimate estimated;
        ASSERT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::ok) << message();
        spiedCalls().clear();
        makeBody(desc);
        EXPECT_EQ(bytesSpied(), estimated.bytes) << what;
    };
    agrees("flat");
    desc.waves = &waves;
    desc.wavesBackend = fftwWaves();
    desc.wavesOn = WavesOn::cpu;
    agrees("waves");
    desc.wavesOn = WavesOn::gpu;
    agrees("waves by compute shaders");
    desc.foam = &foam;
    makeBody(desc); // the pattern that all with foam share
    agrees("foam");

    Estimate estimated;
    desc.reflection = &reflection;
    ASSERT_EQ(estimate(context(), &desc, {320, 180}, &estimated), Status::ok) << message();
    EXPECT_GE(estimated.bytesPerView, 320u * 180 * 14);
    EXPECT_EQ(estimate(context(), &desc, {0, 180}, &estimated), Status::invalidArgument);
    EXPECT_NE(message().find("extent"), std::string::npos);
}

TEST_F(BodyOfWater, BadDescriptionsAreNamedAndLeaveNothing) {
    SeaDesc waves = breeze();
    FoamDesc foam;
    ReflectionDesc reflection;
    const auto refused = [&](auto&& spoil) {
        BodyDesc desc;
        spoil(desc);
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::invalidArgument);
        EXPECT_EQ(body, nullptr);
        return message();
    };
    const auto names = [](const std::string& text, const char* field) {
        return text.find(field) != std::string::npos;
    };
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.plane[1] = 0; }), "plane"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.plane[1] = -1; }), "plane"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) { d.foam = &foam; }), "foam"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          d.waves = &waves;
                          d.wavesOn = WavesOn::cpu;
                      }),
                      "wavesBackend"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.wavesOn = static_cast<WavesOn>(7); }), "wavesOn"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.mesh.cellSize = NAN; }), "cellSize"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.mesh.cellsPerLevel = 3; }), "cellsPerLevel"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.shading.waveShadowSteps = 1; }), "waveShadowSteps"));
    EXPECT_TRUE(names(refused([](BodyDesc& d) { d.shading.waveShadowSteps = 33; }), "waveShadowSteps"));
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          waves.samples = 100;
                          d.waves = &waves;
                          d.wavesBackend = fftwWaves();
                      }),
                      "samples"));
    for (const float bad : {-1.0f, NAN, INFINITY})
        for (int channel = 0; channel < 3; ++channel) {
            RefractionDesc refraction;
            refraction.absorption[channel] = bad;
            const auto useIt = [&](BodyDesc& d) { d.refraction = &refraction; };
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.absorption")) << bad << ' ' << channel;
            refraction = {};
            refraction.backscatter[channel] = bad;
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.backscatter")) << bad << ' ' << channel;
            refraction = {};
            refraction.scattering = bad;
            EXPECT_TRUE(names(refused(useIt), "RefractionDesc.scattering")) << bad;
        }
    EXPECT_TRUE(names(refused([&](BodyDesc& d) {
                          reflection.edgeFade = 2;
                          d.reflection = &reflection;
                      }),
                      "edgeFade"));
}

TEST_F(BodyOfWater, DrawingBeforeSimulatingIsAnError) {
    Body* body = wavyBody(breeze());
    Target* target = nullptr;
    const TargetDesc desc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
    ASSERT_EQ(createTarget(context(), &desc, &target), Status::ok);
    const demos::Image color = uploadFloats(4, 4, 4, std::vector<float>(64));
    const demos::Image depth = uploadFloats(4, 4, 1, std::vector<float>(16));
    Camera camera = seaCamera();
    camera.width = camera.height = 4;
    ViewDesc view = viewDesc(camera);
    view.sceneColor = asSeaglass(color);
    view.sceneDepth = asSeaglass(depth);
    frame([&](VkCommandBuffer commands) {
        EXPECT_MISUSE(draw(commands, target, &body, 1, &view, &lighting), "was never called", message());
        EXPECT_EQ(simulate(commands, &body, 1, NAN), Status::invalidArgument);
    });
    destroyTarget(target);
}

TEST_F(BodyOfWater, WithoutRefractionNeedsNoScene) {
    Body* opaque = wavyBody(breeze());
    const WaterPicture before = picture({opaque}, seaCamera());
    changeView = [](ViewDesc& view) { view.sceneColor = view.sceneDepth = {}; };
    EXPECT_EQ(picture({opaque}, seaCamera()).color, before.color);
}

/// A camera that cannot be drawn for, by a body without anything.
class BodyRefuses : public BodyOfWater {
  protected:
    void expectRefused(Camera camera, Status status, const char* words) {
        const demos::Image color = uploadFloats(4, 4, 4, std::vector<float>(64));
        const demos::Image depth = uploadFloats(4, 4, 1, std::vector<float>(16));
        camera.width = camera.height = 4;
        ViewDesc view = viewDesc(camera);
        view.sceneColor = asSeaglass(color);
        view.sceneDepth = asSeaglass(depth);
        Target* target = nullptr;
        const TargetDesc targetDesc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
        ASSERT_EQ(createTarget(context(), &targetDesc, &target), Status::ok);
        Body* body = makeBody({});
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(draw(commands, target, &body, 1, &view, &lighting), status);
            EXPECT_NE(message().find(words), std::string::npos) << message();
        });
        destroyTarget(target);
    }
};

TEST_F(BodyRefuses, DepthThatRunsAgainstTheTarget) {
    Camera camera = seaCamera();
    camera.reversed = false;
    camera.far = 100;
    expectRefused(camera, Status::invalidArgument, "expected TargetDesc.reversedDepth to be false");
}

TEST_F(BodyOfWater, BodiesMayGoWhileTheGpuUsesThem) {
    const SeaDesc waves = breeze();
    for (int i = 0; i < 4; ++i) {
        BodyDesc desc;
        desc.waves = &waves;
        desc.wavesBackend = fftwWaves();
        Body* body = nullptr;
        ASSERT_EQ(createBody(context(), &desc, &body), Status::ok) << message();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, i), Status::ok) << message();
            destroyBody(body); // recorded, not yet executed
        });
    }
}

} // namespace
