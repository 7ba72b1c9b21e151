// prepare() makes what drawing would make, ahead and on any thread.
#include <algorithm>
#include <atomic>
#include <thread>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// Above the surface, in it and below it.
std::vector<Camera> everyPlace() {
    std::vector<Camera> cameras(3);
    const double heights[] = {30, 0, -30};
    for (size_t i = 0; i < cameras.size(); ++i) {
        Camera& camera = cameras[i];
        camera.eye = {0, heights[i], 8};
        camera.target = {0, heights[i] - 0.5, 0};
        camera.width = 48;
        camera.height = 32;
    }
    return cameras;
}

class Prepared : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        useOwnContext();
        sea_ = breeze();
        desc_.waves = &sea_;
        desc_.wavesOn = WavesOn::gpu;
        desc_.refraction = &refraction_;
        desc_.reflection = &reflection_;
        desc_.underwater = &underwater_;
        desc_.caustics = &caustics_;
        lighting.toSun[1] = 1;
        std::ranges::fill(lighting.sunIrradiance, 1.0f);
    }

    void useShadow() {
        map_ = uploadFloats(8, 8, 1, std::vector<float>(64, 1.0f));
        demos::Error error;
        ASSERT_TRUE(demos::createArrayView(device(), map_, mapView_, error)) << error.text;
        shadow_.map = asSeaglass(map_);
        shadow_.map.view = mapView_.get();
        for (const size_t i : {12u, 13u, 14u, 15u}) shadow_.textureFromWorld[0][i] = i == 15 ? 1 : 0.5;
        lighting.shadow = &shadow_;
    }

    /// Of all that a frame makes, drawing and caustics too.
    size_t pipelinesMadeByFrames(Body* body) {
        spiedCalls().clear();
        for (const Camera& camera : everyPlace()) {
            const SceneBehind behind = planeBelow(camera, -50, 1);
            beforeDrawing = nullptr;
            drawing = nullptr;
            picture({body}, camera, time_ += 0.1, output_, behind);
            if (output_ != SurfaceOutput::shaded) continue;
            drawCausticsOf(body);
            picture({body}, camera, time_ += 0.1, output_, behind);
        }
        beforeDrawing = nullptr;
        drawing = nullptr;
        return countSpied("CreateGraphicsPipelines") + countSpied("CreateComputePipelines");
    }

    /// In a frame, where the tests' target is at hand.
    void prepareFor(Body* body, const LightingDesc* lights, const Camera& seenBy = everyPlace().front()) {
        drawing = [this, body, lights](VkCommandBuffer, Target* target, const ViewDesc& view) {
            return prepare(target, body, &view, lights, output_);
        };
        picture({body}, seenBy, time_ += 0.1);
        drawing = nullptr;
    }

    SeaDesc sea_;
    const RefractionDesc refraction_;
    const ReflectionDesc reflection_;
    const UnderwaterDesc underwater_;
    const CausticsDesc caustics_;
    BodyDesc desc_;
    SurfaceOutput output_ = SurfaceOutput::shaded;
    double time_ = 10;
    demos::Image map_;
    demos::UniqueImageView mapView_;
    SunShadow shadow_;
};

TEST_F(Prepared, TheFirstFramesMakeNoPipeline) {
    useShadow();
    Body* const body = makeBody(desc_);
    spiedCalls().clear();
    prepareFor(body, &lighting);
    // The surface found and placed; the water before the scene, whole and cut, and its line; light.
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 6u);
    // Listing in three steps, sorted from above alone; shading by four lists from above, by one from below
    // and from both; light in shadow.
    EXPECT_EQ(countSpied("CreateComputePipelines"), 13u);
    spiedCalls().clear();
    prepareFor(body, &lighting);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u) << "they were made twice";
    EXPECT_EQ(pipelinesMadeByFrames(body), 0u);
}

TEST_F(Prepared, StillWaterThatMirrorsInFewerPixels) {
    ReflectionDesc smaller;
    smaller.downscale = 2;
    smaller.blurLevels = 0;
    desc_ = {};
    desc_.reflection = &smaller;
    Body* const body = makeBody(desc_);
    prepareFor(body, &lighting);
    spiedCalls().clear();
    const Camera camera = everyPlace().front();
    picture({body}, camera, time_ += 0.1, output_, planeBelow(camera, -50, 1));
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 0u);
}

// Tiles of small views are not sorted on CPU devices.
TEST_F(Prepared, ForViewsOfAnySize) {
    desc_.underwater = nullptr;
    Body* const body = makeBody(desc_);
    Camera large = everyPlace().front();
    large.width = 256;
    large.height = 144;
    prepareFor(body, &lighting, large);
    spiedCalls().clear();
    const Camera small = everyPlace().front();
    picture({body}, small, time_ += 0.1, output_, planeBelow(small, -50, 1));
    EXPECT_EQ(countSpied("CreateGraphicsPipelines") + countSpied("CreateComputePipelines"), 0u);
}

// The context keeps what bodies that are gone were drawn by.
TEST_F(Prepared, ABodyMadeAnewMakesNoPipeline) {
    desc_.wavesBackend = fftwWaves();
    for (const bool anew : {false, true}) {
        Body* body = nullptr;
        spiedCalls().clear();
        ASSERT_EQ(createBody(context(), &desc_, &body), Status::ok) << message();
        const size_t atFirst = countSpied("CreateComputePipelines");
        const size_t later = pipelinesMadeByFrames(body);
        EXPECT_EQ(atFirst > 0, !anew);
        EXPECT_EQ(later > 0, !anew);
        destroyBody(body);
        frame([](VkCommandBuffer) {});
        frame([](VkCommandBuffer) {});
    }
}

TEST_F(Prepared, SprayToo) {
    sea_.windSpeed = 25;
    const FoamDesc foam;
    const SprayDesc spray;
    desc_ = {};
    desc_.waves = &sea_;
    desc_.wavesOn = WavesOn::gpu;
    desc_.foam = &foam;
    desc_.spray = &spray;
    Body* const body = makeBody(desc_);
    spiedCalls().clear();
    prepareFor(body, &lighting);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 3u) << "found, placed, and spray";
    EXPECT_EQ(pipelinesMadeByFrames(body), 0u);
}

TEST_F(Prepared, OfOtherOutputsToo) {
    desc_.motion = true;
    for (const SurfaceOutput output : {SurfaceOutput::normal, SurfaceOutput::motion}) {
        output_ = output;
        useSamples(VK_SAMPLE_COUNT_1_BIT);
        Body* const body = makeBody(desc_);
        prepareFor(body, nullptr);
        EXPECT_EQ(pipelinesMadeByFrames(body), 0u);
    }
}

// What has fewer features makes fewer.
TEST_F(Prepared, NothingIsMadeInVain) {
    BodyDesc plain;
    plain.shading.pixelsPerShading = 4; // which pays where shading is dear
    Body* const body = makeBody(plain);
    spiedCalls().clear();
    prepareFor(body, nullptr);
    EXPECT_EQ(countSpied("CreateGraphicsPipelines"), 2u) << "found and placed";
    EXPECT_EQ(countSpied("CreateComputePipelines"), 4u) << "listed in three steps, and shaded";
}

TEST_F(Prepared, OnAnotherThreadWhileOthersDraw) {
    useShadow();
    BodyDesc plain = desc_;
    plain.underwater = nullptr;
    plain.caustics = nullptr;
    Body *first = makeBody(plain), *const next = makeBody(desc_);
    const Camera camera = everyPlace().front();
    std::thread other;
    std::atomic<Status> prepared{Status::vulkanError};
    std::atomic<bool> done{false};
    shadeBefore(first);
    drawing = [&](VkCommandBuffer commands, Target* target, const ViewDesc& view) {
        if (!other.joinable())
            other = std::thread([&, target, view] {
                prepared.store(prepare(target, next, &view, &lighting));
                done = true;
            });
        return draw(commands, target, &first, 1, &view, &lighting);
    };
    int frames = 0;
    do {
        picture({first, next}, camera, time_ += 0.1, SurfaceOutput::shaded, planeBelow(camera, -50, 1));
    } while (++frames < 1000 && !done);
    other.join();
    EXPECT_EQ(prepared.load(), Status::ok) << message();
    drawing = nullptr;
    EXPECT_EQ(pipelinesMadeByFrames(next), 0u);
}

TEST_F(Prepared, NullsAreNamed) {
    Body* const body = makeBody(desc_);
    EXPECT_EQ(prepare(nullptr, body), Status::invalidArgument);
    EXPECT_EQ(message(), "prepare: target is null");
    EXPECT_EQ(prepare(nullptr, nullptr), Status::invalidArgument);
}

} // namespace
