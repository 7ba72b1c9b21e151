// A scene pays for what it uses: each feature that is off takes its memory, pipelines, dispatches and texture
// reads with it, and estimate() says what is left to pay.
#include <algorithm>
#include <limits>

#include "tests/body_parts.h"
#include "tests/gpu/host/host_shape.h"
#include "tests/gpu/host/shader_work.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// A body with everything, and switches.
struct Water : BodyParts {
    Water() {
        addAll();
        desc.spray = nullptr; // wants more wind
        sea.windSpeed = 7;
        sea.samples = 64;
        reflection.temporal = 0.9f;
        reflection.edgeStretch = 0.5f;
        reflection.edgeReach = 0.2f;
        reflection.overhangSamples = 3;
        refraction.scattering = 0.25f;
        underwater.shafts = 1;
        underwater.snow = 1;
        desc.wavesOn = WavesOn::gpu;
        desc.extent.shape = ExtentShape::rectangle;
        desc.extent.size[0] = desc.extent.size[1] = 60;
        desc.motion = true;
        desc.shading.slopeSamples = 2;
        desc.shading.waveShadowSteps = 8;
        desc.shading.parallax = true;
        shape.sunShadow = true;
        shape.fog = true;
        // 3 m around (20, -20), where the eye is not.
        volumes = {{{{1, 0, 0, -23}, {-1, 0, 0, 17}, {0, 0, 1, 17}, {0, 0, -1, -23}, {0, -1, 0, -2}}}};
    }

    std::vector<ExclusionVolume> volumes;
    HostShape shape;
};

/// What a first frame asks of Vulkan.
struct Cost {
    VkDeviceSize bytes = 0;
    size_t allocations = 0, images = 0, computePipelines = 0, drawPipelines = 0, dispatches = 0, draws = 0;
    size_t sampled = 0; ///< images that layouts name, by all pipelines together
    ShaderWork work;    ///< likewise
    size_t depthWriters = 0;
};

struct Part {
    const char* name;
    size_t (*of)(const Cost&);
};

constexpr Part memory{"KiB", [](const Cost& c) { return static_cast<size_t>(c.bytes >> 10); }};
constexpr Part objects{"images and allocations", [](const Cost& c) { return c.images + c.allocations; }};
constexpr Part computes{"compute pipelines", [](const Cost& c) { return c.computePipelines; }};
constexpr Part dispatches{"dispatches", [](const Cost& c) { return c.dispatches; }};
constexpr Part pipelines{"pipelines that draw", [](const Cost& c) { return c.drawPipelines; }};
constexpr Part draws{"draws", [](const Cost& c) { return c.draws; }};
constexpr Part bound{"images bound", [](const Cost& c) { return c.sampled; }};
constexpr Part reads{"reads of images", [](const Cost& c) { return c.work.reads; }};
constexpr Part code{"instructions", [](const Cost& c) { return c.work.instructions; }};
constexpr Part depthWriters{"pipelines that write depth", [](const Cost& c) { return c.depthWriters; }};
constexpr const Part* parts[] = {&memory, &objects, &computes, &dispatches, &pipelines,
                                 &draws,  &bound,   &reads,    &code,       &depthWriters};

class Features : public testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().validationMessages(); }
    void TearDown() override { EXPECT_EQ(device().validationMessages(), messagesBefore_); }

    /// At the waterline, so that a body which is seen from within is. What is counted asks for few pixels.
    static Camera atTheWaterline() {
        Camera camera = shoreCamera();
        camera.eye.y = 0.02;
        camera.width = 64;
        camera.height = 36;
        return camera;
    }

    Cost costOf(const BodyDesc& body, const HostShape& shape = {},
                const std::vector<ExclusionVolume>& volumes = {}) {
        spiedCalls().clear();
        ShapedHost host(device(), shape, true, {}, [&](BodyDesc& desc) { desc = body; });
        EXPECT_EQ(setExclusionVolumes(host.body(), volumes.data(), static_cast<uint32_t>(volumes.size())),
                  Status::ok);
        host.picture(atTheWaterline());
        Cost cost;
        cost.bytes = bytesSpied();
        cost.allocations = countSpied("AllocateMemory");
        cost.images = countSpied("CreateImage");
        cost.computePipelines = countSpied("CreateComputePipelines");
        cost.drawPipelines = countSpied("CreateGraphicsPipelines");
        cost.dispatches = countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect");
        cost.draws = countSpied("CmdDraw") + countSpied("CmdDrawIndexed");
        for (const SpiedCall& call : spiedCalls()) {
            cost.sampled += call.sampled;
            cost.depthWriters += call.writesDepth;
        }
        const Camera camera = atTheWaterline();
        EXPECT_EQ(estimate(host.context(), &body, {camera.width, camera.height}, &estimated_), Status::ok)
            << host.message();
        return cost;
    }
    Cost costOf(const Water& water) { return costOf(water.desc, water.shape, water.volumes); }
    /// And what is left of its shaders, which takes as long again to find.
    Cost costAndWorkOf(const Water& water) {
        Cost cost = costOf(water);
        for (const SpiedCall& call : spiedCalls())
            for (const SpiedStage& stage : call.stages) {
                const ShaderWork work = workOf(stage.spirv, stage.constants);
                cost.work.reads += work.reads;
                cost.work.instructions += work.instructions;
            }
        return cost;
    }
    const Estimate& estimated() const { return estimated_; }

  private:
    uint32_t messagesBefore_ = 0;
    Estimate estimated_;
};

/// Takes a feature away.
using Switch = void (*)(Water&);

/// And what goes with it.
struct Feature {
    const char* name;
    Switch off;
    std::vector<const Part*> gone;        ///< what becomes less; nothing becomes more
    Switch on = nullptr;                  ///< what it takes beside all the rest
    std::vector<const Part*> traded = {}; ///< but these may, where something else is done in its place
};

/// Pointers of a body, and what their descriptions switch.
std::vector<Feature> featuresOfParts() {
    return {
        {"waves",
         [](Water& w) {
             w.desc.waves = nullptr;
             w.desc.foam = nullptr;
             w.desc.caustics = nullptr;
         },
         {&memory, &objects, &computes, &dispatches, &pipelines, &draws, &bound, &reads, &code}},
        {"foam",
         [](Water& w) { w.desc.foam = nullptr; },
         {&memory, &objects, &computes, &dispatches, &bound, &reads, &code}},
        {"refraction",
         [](Water& w) {
             w.desc.refraction = nullptr;
             w.desc.bed = nullptr;
             w.desc.underwater = nullptr;
             w.desc.caustics = nullptr;
         },
         {&memory, &objects, &pipelines, &draws, &bound, &reads, &code}},
        {"light through crests", [](Water& w) { w.refraction.scattering = 0; }, {&reads, &code}},
        {"reflection",
         [](Water& w) { w.desc.reflection = nullptr; },
         {&memory, &objects, &computes, &dispatches, &bound, &reads, &code}},
        {"overhangs", [](Water& w) { w.reflection.overhangSamples = 0; }, {&reads, &code}},
        {"temporal",
         [](Water& w) { w.reflection.temporal = 0; },
         {&memory, &objects, &computes, &dispatches, &bound, &reads, &code}},
        {"edge reach",
         [](Water& w) { w.reflection.edgeReach = 0; },
         {&computes, &dispatches, &bound, &reads, &code}},
        {"edge stretch", [](Water& w) { w.reflection.edgeStretch = 0; }, {&computes, &dispatches, &code}},
        {"blur",
         [](Water& w) { w.reflection.blurLevels = 0; },
         {&memory, &computes, &dispatches, &reads, &code}},
        {"underwater",
         [](Water& w) { w.desc.underwater = nullptr; },
         {&pipelines, &draws, &bound, &reads, &code}},
        {"meniscus",
         [](Water& w) { w.underwater.meniscus = 0; },
         {&pipelines, &draws, &bound, &reads, &code}},
        {"shafts", [](Water& w) { w.underwater.shafts = 0; }, {&pipelines, &draws, &bound, &reads, &code}},
        {"marine snow", [](Water& w) { w.underwater.snow = 0; }, {&pipelines, &draws, &code}},
        {"caustics",
         [](Water& w) { w.desc.caustics = nullptr; },
         {&memory, &objects, &computes, &dispatches, &pipelines, &draws, &bound, &reads, &code}},
        {"spray",
         [](Water& w) { w.desc.spray = nullptr; },
         {&pipelines, &draws, &bound, &reads, &code},
         [](Water& w) {
             w.desc.extent = {};
             w.sea.windSpeed = 20;
             w.desc.spray = &w.spray;
         }},
        // Its shader's places for the bed's images hold the scene's, and are not read. Bent rays are then
        // looked for in the scene's picture.
        // Without a picture of its own a bed is looked for in the scene's, step by step.
        {"bed",
         [](Water& w) { w.desc.bed = nullptr; },
         {&memory, &objects, &bound},
         nullptr,
         {&code, &reads}},
    };
}

/// What its light, shape and shading switch.
std::vector<Feature> featuresOfWater() {
    return {
        {"sun shadow", [](Water& w) { w.shape.sunShadow = false; }, {&bound, &reads, &code}},
        {"fog", [](Water& w) { w.shape.fog = false; }, {&reads, &code}},
        {"extent", [](Water& w) { w.desc.extent = {}; }, {&code}},
        {"globe",
         [](Water& w) { w.desc.extent.planetRadius = 0; },
         {&code},
         [](Water& w) {
             w.desc.extent = {};
             w.desc.extent.planetRadius = 6.371e6;
         }},
        {"shore",
         [](Water& w) { w.sea.shore = nullptr; },
         {&memory, &objects, &bound, &reads, &code},
         [](Water& w) {
             w.addShore();
             w.desc.shading.parallax = false; // which a shore has none of
         }},
        {"motion", [](Water& w) { w.desc.motion = false; }, {&memory, &objects}},
        {"exclusion volumes", [](Water& w) { w.volumes.clear(); }, {&code}},
        {"exclusion volumes, of the surface alone",
         [](Water& w) { w.volumes.clear(); },
         {&code},
         [](Water& w) { w.desc.caustics = nullptr; }},
        {"parallax", [](Water& w) { w.desc.shading.parallax = false; }, {&reads, &code}},
        // As often as it looks, its loop goes around: one of one round is none.
        {"looks at slopes", [](Water& w) { w.desc.shading.slopeSamples = 1; }, {&code}},
        {"waves' shadows", [](Water& w) { w.desc.shading.waveShadowSteps = 0; }, {&reads, &code}},
        {"tilt", [](Water& w) { w.desc.plane[0] = 0; }, {&code}, [](Water& w) { w.desc.plane[0] = 1e-3; }},
        {"depth write", [](Water& w) { w.shape.depthWrite = false; }, {&depthWriters}},
    };
}

/// Tries one of so many.
class FeaturesOneByOne : public Features, public testing::WithParamInterface<size_t> {};
INSTANTIATE_TEST_SUITE_P(, FeaturesOneByOne, testing::Values(size_t{1}, size_t{8}),
                         [](const auto& info) { return info.param == 1 ? "All" : "EveryEighth"; });

TEST_P(FeaturesOneByOne, ThatAreOffAreGone) {
    const Cost all = costAndWorkOf(Water());
    std::vector<Feature> features = featuresOfParts();
    std::ranges::move(featuresOfWater(), std::back_inserter(features));
    for (size_t i = 0; i < features.size(); i += GetParam()) {
        const Feature& feature = features[i];
        SCOPED_TRACE(feature.name);
        Water water;
        if (feature.on) feature.on(water);
        const Cost with = feature.on ? costAndWorkOf(water) : all;
        feature.off(water);
        const Cost without = costAndWorkOf(water);
        std::printf("%s:\n", feature.name);
        for (const Part* const part : parts) {
            const size_t before = part->of(with), after = part->of(without);
            if (after != before) std::printf("    %zu of %zu %s\n", after, before, part->name);
            if (std::ranges::find(feature.traded, part) == feature.traded.end()) {
                EXPECT_LE(after, before) << part->name;
            }
            if (std::ranges::find(feature.gone, part) != feature.gone.end()) {
                EXPECT_LT(after, before) << part->name;
            }
        }
    }
}

/// What this device wants, what a GPU does that wants more for all, and what it is told that it is.
struct Wants {
    const char* name;
    VkDeviceSize alignment;
    VkPhysicalDeviceType type;
};

class FeaturesOnEachDevice : public Features, public testing::WithParamInterface<Wants> {
  protected:
    void SetUp() override {
        pretendAlignment(GetParam().alignment);
        pretendDeviceType(GetParam().type);
        Features::SetUp();
    }
    void TearDown() override {
        Features::TearDown();
        pretendAlignment(0);
        pretendDeviceType(VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM);
    }

    /// What a view from above holds for what is mirrored: GPUs shade in steps. One that shows both sides is
    /// shaded at once, and an estimate does not know which will be drawn.
    VkDeviceSize ofMirroredApart(const Water& water) const {
        if (GetParam().type != VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU || !water.desc.underwater ||
            !water.desc.reflection || water.reflection.technique == ReflectionTechnique::sky)
            return 0;
        constexpr VkDeviceSize bytesOfTexel = 8;
        const Camera camera = atTheWaterline();
        const VkDeviceSize bytes = bytesOfTexel * camera.width * camera.height, unit = GetParam().alignment;
        return (bytes + unit - 1) / unit * unit;
    }

    /// What all bodies with foam of a context hold together, and no estimate counts: a pattern of 256 x 256
    /// texels with mips, and as much to upload it from.
    VkDeviceSize sharedByFoam(VkDeviceSize ofEach) {
        BodyParts water;
        water.desc.waves = &water.sea;
        water.desc.wavesOn = WavesOn::gpu;
        water.desc.foam = &water.foam;
        const VkDeviceSize bytes = costOf(water.desc).bytes;
        const VkDeviceSize shared = bytes - ofEach - estimated().bytes - estimated().bytesPerView;
        constexpr VkDeviceSize texels = 4 * (256 * 256 * 4 / 3);
        EXPECT_GE(shared, 2 * texels);
        EXPECT_LE(shared, 2 * (texels + std::max<VkDeviceSize>(GetParam().alignment, 4096)));
        return shared;
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, FeaturesOnEachDevice,
                         testing::Values(Wants{"This", 0, VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM},
                                         Wants{"Coarse", 64 << 10, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(FeaturesOnEachDevice, AddWhatTheEstimateSays) {
    // What every body costs, and its frame slot.
    const Cost none = costOf(BodyDesc());
    const VkDeviceSize ofSurface = estimated().bytesPerView;
    EXPECT_EQ(estimated().bytes, 0u);
    EXPECT_EQ(none.dispatches, 4u) << "that list the surface's tiles in three steps, and shade them";
    EXPECT_EQ(none.computePipelines, 4u);
    EXPECT_EQ(none.images, 3u) << "depth and place of the surface, and its colour";
    const VkDeviceSize ofFoam = sharedByFoam(none.bytes - ofSurface);
    const auto holds = [&](const char* name, const Water& water) {
        SCOPED_TRACE(name);
        const Cost cost = costOf(water);
        const VkDeviceSize expected = none.bytes + estimated().bytes + estimated().bytesPerView - ofSurface +
                                      (water.desc.foam ? ofFoam : 0);
        std::printf("%-12s estimated %zu KiB, allocated %zu KiB\n", name, static_cast<size_t>(expected >> 10),
                    static_cast<size_t>(cost.bytes >> 10));
        EXPECT_EQ(cost.bytes + ofMirroredApart(water), expected);
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
    const Cost none = costOf(BodyDesc());
    const VkDeviceSize ofSurface = estimated().bytesPerView;
    // Listed in three steps, and shaded by two lists; so small a view by one on CPU devices.
    const size_t forSurface = 4 + onGpus(1);
    Water water;
    water.desc.waves = nullptr;
    water.desc.foam = nullptr;
    water.desc.caustics = nullptr;
    water.desc.underwater = nullptr;
    water.volumes.clear();
    const Cost pond = costOf(water);
    EXPECT_EQ(estimated().bytes, 0u) << "of waves";
    EXPECT_EQ(pond.dispatches, estimated().dispatchesPerView + forSurface);
    EXPECT_EQ(countSpied("CmdBlitImage") + countSpied("CmdCopyBufferToImage"), 0u);
    // All else is the reflection's, as a reflector alone has it.
    EXPECT_EQ(pond.bytes, none.bytes + estimated().bytesPerView - ofSurface);
    const size_t ofPond = pond.computePipelines;
    spiedCalls().clear();
    std::string text;
    const DeviceDesc deviceSaid = deviceDesc(&text);
    Context* context = nullptr;
    ASSERT_EQ(createContext(&deviceSaid, &context), Status::ok) << text;
    ReflectorDesc reflectorDesc;
    reflectorDesc.reflection = water.reflection;
    reflectorDesc.reflection.blurLevels = 0; // nothing blurs what still water mirrors
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context, &reflectorDesc, &reflector), Status::ok) << text;
    EXPECT_EQ(countSpied("CreateComputePipelines") + forSurface, ofPond);
    destroyReflector(reflector);
    destroyContext(context);
}

} // namespace
