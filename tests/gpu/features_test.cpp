// A scene pays for what it uses: each feature that is off takes its memory, pipelines, dispatches and texture
// reads with it, and estimate() says what is left to pay.
#include <limits>

#include "tests/gpu/host_shape.h"
#include "tests/gpu/rig.h"
#include "tests/gpu/spy.h"

namespace {

using namespace seaglass;
using namespace tests;

/// A body with everything, and switches.
struct Water {
    Water() {
        sea.windSpeed = 7;
        sea.samples = 64;
        reflection.temporal = 0.9f;
        reflection.edgeStretch = 0.5f;
        reflection.edgeReach = 0.2f;
        extent.shape = ExtentShape::rectangle;
        extent.size[0] = extent.size[1] = 60;
        desc.waves = &sea;
        desc.wavesOn = WavesOn::gpu;
        desc.foam = &foam;
        desc.refraction = &refraction;
        desc.reflection = &reflection;
        desc.underwater = &underwater;
        desc.caustics = &caustics;
        desc.bed = &bed;
        desc.extent = extent;
    }
    Water(const Water&) = delete;
    Water& operator=(const Water&) = delete;

    SeaDesc sea;
    FoamDesc foam;
    RefractionDesc refraction;
    ReflectionDesc reflection;
    UnderwaterDesc underwater;
    CausticsDesc caustics;
    BedDesc bed;
    ExtentDesc extent;
    BodyDesc desc;
};

/// What a first frame asks of Vulkan.
struct Cost {
    VkDeviceSize bytes = 0;
    size_t allocations = 0, images = 0, computePipelines = 0, drawPipelines = 0, dispatches = 0, draws = 0;
    size_t sampled = 0; ///< images, by all pipelines together
};

class Features : public testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().validationMessages(); }
    void TearDown() override { EXPECT_EQ(device().validationMessages(), messagesBefore_); }

    /// At the waterline, so that a body which is seen from within is.
    static Camera atTheWaterline() {
        Camera camera = shoreCamera();
        camera.eye.y = 0.02;
        return camera;
    }

    Cost costOf(const BodyDesc& body, bool sunShadow = true) {
        HostShape shape;
        shape.sunShadow = sunShadow;
        spiedCalls().clear();
        ShapedHost host(device(), shape, true, {}, [&](BodyDesc& desc) { desc = body; });
        host.picture(atTheWaterline());
        Cost cost;
        cost.bytes = bytesSpied();
        cost.allocations = countSpied("AllocateMemory");
        cost.images = countSpied("CreateImage");
        cost.computePipelines = countSpied("CreateComputePipelines");
        cost.drawPipelines = countSpied("CreateGraphicsPipelines");
        cost.dispatches = countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect");
        cost.draws = countSpied("CmdDraw") + countSpied("CmdDrawIndexed");
        for (const SpiedCall& call : spiedCalls()) cost.sampled += call.sampled;
        const Camera camera = atTheWaterline();
        EXPECT_EQ(estimate(host.context(), &body, {camera.width, camera.height}, &estimated_), Status::ok)
            << host.message();
        return cost;
    }
    const Estimate& estimated() const { return estimated_; }

  private:
    uint32_t messagesBefore_ = 0;
    Estimate estimated_;
};

TEST_F(Features, ThatAreOffAreGone) {
    const Cost all = [&] {
        const Water water;
        return costOf(water.desc);
    }();
    struct Switch {
        const char* name;
        void (*off)(Water&);
        bool memory, computes, dispatches, draws, samples; ///< what must become less
        bool sunShadow = true;
    };
    const Switch switches[] = {
        {"waves",
         [](Water& w) {
             w.desc.waves = nullptr;
             w.desc.foam = nullptr;
             w.desc.caustics = nullptr;
         },
         true, true, true, true, true},
        {"foam", [](Water& w) { w.desc.foam = nullptr; }, true, true, true, false, true},
        {"refraction",
         [](Water& w) {
             w.desc.refraction = nullptr;
             w.desc.bed = nullptr;
             w.desc.underwater = nullptr;
             w.desc.caustics = nullptr;
         },
         true, false, false, true, true},
        {"reflection", [](Water& w) { w.desc.reflection = nullptr; }, true, true, true, false, true},
        {"temporal", [](Water& w) { w.reflection.temporal = 0; }, true, true, true, false, true},
        {"edge reach", [](Water& w) { w.reflection.edgeReach = 0; }, false, true, true, false, true},
        {"edge stretch", [](Water& w) { w.reflection.edgeStretch = 0; }, false, true, true, false, false},
        {"blur", [](Water& w) { w.reflection.blurLevels = 0; }, true, true, true, false, false},
        {"underwater", [](Water& w) { w.desc.underwater = nullptr; }, false, false, false, true, true},
        {"caustics", [](Water& w) { w.desc.caustics = nullptr; }, true, true, true, true, true},
        // Its shader's places for the bed's images hold the scene's, and are not read.
        {"bed", [](Water& w) { w.desc.bed = nullptr; }, true, false, false, false, false},
        {"sun shadow", [](Water&) {}, false, false, false, false, true, false},
    };
    for (const Switch& feature : switches) {
        SCOPED_TRACE(feature.name);
        Water water;
        feature.off(water);
        const Cost cost = costOf(water.desc, feature.sunShadow);
        std::printf(
            "%-12s %8zu KiB of %zu, %zu of %zu compute pipelines, %zu of %zu dispatches, %zu of %zu draws, "
            "%zu of %zu images sampled\n",
            feature.name, static_cast<size_t>(cost.bytes >> 10), static_cast<size_t>(all.bytes >> 10),
            cost.computePipelines, all.computePipelines, cost.dispatches, all.dispatches, cost.draws,
            all.draws, cost.sampled, all.sampled);
        const auto compare = [](bool less, size_t with, size_t without, const char* what) {
            EXPECT_LE(without, with) << what;
            if (less) {
                EXPECT_LT(without, with) << what;
            }
        };
        compare(feature.memory, all.bytes, cost.bytes, "bytes");
        compare(false, all.images + all.allocations, cost.images + cost.allocations, "objects");
        compare(feature.computes, all.computePipelines, cost.computePipelines, "compute pipelines");
        compare(feature.dispatches, all.dispatches, cost.dispatches, "dispatches");
        compare(feature.draws, all.drawPipelines, cost.drawPipelines, "pipelines that draw");
        compare(feature.draws, all.draws, cost.draws, "draws");
        compare(feature.samples, all.sampled, cost.sampled, "sampled images");
    }
}

TEST_F(Features, EachAddsWhatTheEstimateSays) {
    // What every body costs, and its frame slot.
    const Cost none = costOf({});
    EXPECT_EQ(estimated().bytes + estimated().bytesPerView, 0u);
    EXPECT_EQ(none.dispatches + none.computePipelines + none.images, 0u);
    const auto holds = [&](const char* name, const Water& water) {
        SCOPED_TRACE(name);
        const Cost cost = costOf(water.desc);
        const VkDeviceSize expected = none.bytes + estimated().bytes + estimated().bytesPerView;
        std::printf("%-12s estimated %zu KiB, allocated %zu KiB\n", name, static_cast<size_t>(expected >> 10),
                    static_cast<size_t>(cost.bytes >> 10));
        EXPECT_GE(cost.bytes, expected);
        EXPECT_LE(cost.bytes, expected + (4u << 10) * cost.allocations);
        if (!water.desc.waves) {
            EXPECT_EQ(cost.dispatches, estimated().dispatchesPerView);
        }
    };
    Water water;
    holds("all", water);
    water.reflection.temporal = 0;
    holds("no temporal", water);
    for (const ReflectionTechnique technique :
         {ReflectionTechnique::sky, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        water.reflection.technique = technique;
        holds("technique", water);
    }
    water.desc.reflection = nullptr;
    holds("no mirror", water);
    water.desc.underwater = nullptr;
    water.desc.caustics = nullptr;
    holds("from above", water);
    water.desc.bed = nullptr;
    holds("no bed", water);
    water.desc.extent = {};
    holds("endless", water);
    water.desc.foam = nullptr;
    holds("no foam", water);
}

TEST_F(Features, AMirrorPondHasNothingOfASea) {
    const Cost none = costOf({});
    Water water;
    water.desc.waves = nullptr;
    water.desc.foam = nullptr;
    water.desc.caustics = nullptr;
    water.desc.underwater = nullptr;
    const Cost pond = costOf(water.desc);
    EXPECT_EQ(estimated().bytes, 0u) << "of waves";
    EXPECT_EQ(pond.dispatches, estimated().dispatchesPerView);
    EXPECT_EQ(countSpied("CmdBlitImage") + countSpied("CmdCopyBufferToImage"), 0u);
    // All of it is the reflection's, as a reflector alone has it.
    EXPECT_LE(pond.bytes, none.bytes + estimated().bytesPerView + (4u << 10) * pond.allocations);
    const size_t ofPond = pond.computePipelines;
    spiedCalls().clear();
    std::string text;
    const DeviceDesc deviceSaid = deviceDesc(&text);
    Context* context = nullptr;
    ASSERT_EQ(createContext(&deviceSaid, &context), Status::ok) << text;
    ReflectorDesc reflectorDesc;
    reflectorDesc.reflection = water.reflection;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context, &reflectorDesc, &reflector), Status::ok) << text;
    EXPECT_EQ(countSpied("CreateComputePipelines"), ofPond);
    destroyReflector(reflector);
    destroyContext(context);
}

} // namespace
