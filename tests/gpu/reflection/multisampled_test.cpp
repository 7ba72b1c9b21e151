// Multisampled scenes: depth and colour of one sample of each pixel, at the place where it lies.
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/multisampled_scene.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

Image multisampled(const demos::Image& image, VkSampleCountFlagBits samples) {
    Image handed = asSeaglass(image);
    handed.layout = VK_IMAGE_LAYOUT_GENERAL;
    handed.samples = samples;
    return handed;
}

/// Whether all around a pixel is of one class, and at one distance if it is something.
bool isAwayFromEdges(const Reflected& reflected, size_t width, size_t x, size_t y) {
    float least = reflected.info[y * width + x], most = least;
    for (size_t v = y - 1; v <= y + 1; ++v)
        for (size_t u = x - 1; u <= x + 1; ++u) {
            least = std::min(least, reflected.info[v * width + u]);
            most = std::max(most, reflected.info[v * width + u]);
        }
    return reflectionClass(least) == reflectionClass(most) && most - least <= 0.05f * std::abs(most);
}

class Multisampled : public ReflectionTest, public testing::WithParamInterface<VkSampleCountFlagBits> {
  protected:
    void SetUp() override {
        ReflectionTest::SetUp();
        if (!canMultisample(GetParam())) GTEST_SKIP() << "the device has no " << GetParam() << " samples";
    }
};

TEST_P(Multisampled, ScenesAreReflectedAsExactlyAsSingleSampledOnes) {
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const MultisampledScene scene = drawMultisampled(pose.camera, harbourOfBoxes(), GetParam());
        ViewDesc view = viewDesc(pose.camera);
        view.sceneDepth = multisampled(scene.depth, GetParam());
        for (const ReflectionTechnique technique :
             {ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
            const Score single = score(traced, reflectScene(pose.camera, traced, with(technique)));
            view.sceneColor = multisampled(scene.color, GetParam());
            const Reflected own = reflectImages(view, with(technique));
            const Score s = score(traced, own);
            print(pose.name, single);
            print("  many", s);
            // Samples lie beside the middles of mirrored pixels, which the truth is told of; keys are taken
            // from around, but a ray looks only at the pixels it crosses, and at edges comes out of tops.
            const bool rays = technique == ReflectionTechnique::ssr;
            EXPECT_GE(s.coverage, single.coverage - (rays ? 0.035 : 0.02)) << pose.name;
            // Colours, which tell places, are rounded to half floats once more.
            EXPECT_LE(s.medianPixels, single.medianPixels + 0.11) << pose.name;
            EXPECT_LE(s.p95Pixels, single.p95Pixels + (rays ? 0.6 : 0.15)) << pose.name;
            EXPECT_LE(s.misplaced, single.misplaced + 0.008) << pose.name;
            // Of two samples the first lies farther from the middle than any of four.
            EXPECT_LE(s.falseOnSky, single.falseOnSky + (GetParam() == VK_SAMPLE_COUNT_2_BIT ? 0.006 : 0.004))
                << pose.name;
            EXPECT_LE(s.skyOnGeometry, single.skyOnGeometry + 0.013) << pose.name;

            view.sceneColor = asSeaglass(scene.resolved);
            const Reflected resolved = reflectImages(view, with(technique));
            EXPECT_EQ(resolved.info, own.info);
            EXPECT_NE(resolved.color, own.color);
        }
    }
}

struct Differences {
    size_t compared = 0, ofClass = 0, ofDistance = 0, ofPlace = 0;

    bool within(double share) const {
        return static_cast<double>(std::max({ofClass, ofDistance, ofPlace})) <=
               share * static_cast<double>(compared);
    }
};

std::ostream& operator<<(std::ostream& out, const Differences& d) {
    return out << d.ofClass << " of class, " << d.ofDistance << " of distance, " << d.ofPlace
               << " of place of " << d.compared;
}

/// Away from edges, where the mirror shows what is `truth`.
Differences differencesOf(const TracedView& traced, const Reflected& single, const Reflected& many,
                          Truth truth) {
    const size_t width = traced.width;
    const float pixel[2] = {1.5f / static_cast<float>(traced.width),
                            1.5f / static_cast<float>(traced.height)};
    Differences out;
    for (size_t y = 1; y + 1 < traced.height; ++y)
        for (size_t x = 1; x + 1 < width; ++x) {
            const size_t i = y * width + x;
            if (traced.truth[i] != truth || !isAwayFromEdges(single, width, x, y)) continue;
            ++out.compared;
            out.ofClass += reflectionClass(single.info[i]) != reflectionClass(many.info[i]);
            out.ofDistance += std::abs(single.info[i] - many.info[i]) > 0.02f * std::abs(single.info[i]);
            out.ofPlace += std::abs(single.color[i * 4] - many.color[i * 4]) > pixel[0] ||
                           std::abs(single.color[i * 4 + 1] - many.color[i * 4 + 1]) > pixel[1];
        }
    return out;
}

TEST_P(Multisampled, PicturesDifferAtEdgesAlone) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const MultisampledScene scene = drawMultisampled(camera, harbourOfBoxes(), GetParam());
    ViewDesc view = viewDesc(camera);
    view.sceneDepth = multisampled(scene.depth, GetParam());
    view.sceneColor = multisampled(scene.color, GetParam());
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::hybrid}) {
        const Reflected single = reflectScene(camera, traced, with(technique));
        const Reflected many = reflectImages(view, with(technique));
        const Differences seen = differencesOf(traced, single, many, Truth::recoverable);
        const Differences sky = differencesOf(traced, single, many, Truth::sky);
        const Differences hidden = differencesOf(traced, single, many, Truth::lost);
        EXPECT_GT(seen.compared, 2000u);
        EXPECT_GT(sky.compared, 10000u);
        EXPECT_GT(hidden.compared, 500u);
        EXPECT_TRUE(seen.within(0.002)) << seen;
        EXPECT_TRUE(sky.within(0.001)) << sky;
        // What no picture shows is guessed by what stands before it, and how thick that is.
        EXPECT_TRUE(hidden.within(0.4)) << hidden;
    }
}

// A mean over an edge is of both sides; what is mirrored of a thing is the thing's, as with each sample's own
// colour.
TEST_P(Multisampled, ResolvedColorHasNoOutline) {
    const Camera camera = testCamera();
    const Radiances radiances = {1, 50};
    const MultisampledScene scene = drawMultisampled(camera, harbourOfBoxes(), GetParam(), &radiances);
    ViewDesc view = viewDesc(camera);
    view.sceneDepth = multisampled(scene.depth, GetParam());
    for (const ReflectionTechnique technique :
         {ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        size_t hits = 0;
        // Of hits, how many are brighter than what they hit.
        const auto outlined = [&](const Image& color) {
            view.sceneColor = color;
            const Reflected reflected = reflectImages(view, with(technique));
            size_t count = 0;
            hits = 0;
            for (size_t i = 0; i < reflected.info.size(); ++i) {
                const bool hit = reflectionClass(reflected.info[i]) == ReflectionClass::hit;
                hits += hit;
                count += hit && reflected.color[i * 4] > 2;
            }
            return count;
        };
        const size_t own = outlined(multisampled(scene.color, GetParam()));
        const size_t resolved = outlined(asSeaglass(scene.resolved));
        std::printf("of %zu hits %zu are outlined, %zu by samples' own colours\n", hits, resolved, own);
        EXPECT_GT(hits, 5000u);
        EXPECT_LE(resolved, own + hits / 500);
    }
}

TEST_P(Multisampled, OnlyTheyMakePipelinesAndImages) {
    useOwnContext();
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const MultisampledScene scene = drawMultisampled(camera, harbourOfBoxes(), GetParam());
    const demos::Image depth = uploadFloats(camera.width, camera.height, 1, traced.depth);
    ViewDesc view = viewDesc(camera);
    Reflector* reflector = nullptr;
    const ReflectorDesc desc;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    struct Made {
        size_t pipelines, images;
        bool operator==(const Made&) const = default;
    };
    const auto made = [&](const Image& sceneDepth, const Image& sceneColor) {
        view.sceneDepth = sceneDepth;
        view.sceneColor = sceneColor;
        spiedCalls().clear();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        return Made{countSpied("CreateComputePipelines"), countSpied("CreateImage")};
    };
    const Image many = multisampled(scene.depth, GetParam());
    EXPECT_EQ(made(asSeaglass(depth), asSeaglass(scene.resolved)), (Made{0, 2})); // the reflection itself
    EXPECT_EQ(made(asSeaglass(depth), asSeaglass(scene.resolved)), (Made{0, 0}));
    EXPECT_EQ(made(many, asSeaglass(scene.resolved)), (Made{2, 2}));
    EXPECT_EQ(made(many, asSeaglass(scene.resolved)), (Made{0, 0}));
    EXPECT_EQ(made(many, multisampled(scene.color, GetParam())), (Made{1, 0}));
    EXPECT_EQ(made(asSeaglass(depth), asSeaglass(scene.resolved)), (Made{0, 0}));
    destroyReflector(reflector);
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
}

TEST_P(Multisampled, ReflectorsOfOneCallShareTheScene) {
    useOwnContext();
    const Camera camera = testCamera();
    const MultisampledScene scene = drawMultisampled(camera, harbourOfBoxes(), GetParam());
    ViewDesc view = viewDesc(camera);
    view.sceneDepth = multisampled(scene.depth, GetParam());
    view.sceneColor = multisampled(scene.color, GetParam());
    std::vector<ReflectorDesc> descs(3, with(ReflectionTechnique::sspr));
    descs[1].plane[3] = -0.3;
    descs[2].reflection.technique = ReflectionTechnique::ssr;
    std::vector<Reflected> alone;
    for (const ReflectorDesc& desc : descs) alone.push_back(reflectImages(view, desc));

    uint32_t dispatches = 0;
    VkDeviceSize bytes = 0;
    Estimate estimated;
    for (const ReflectorDesc& desc : descs) {
        ASSERT_EQ(estimate(context(), &desc.reflection, {camera.width, camera.height}, &estimated,
                           {GetParam(), GetParam()}),
                  Status::ok);
        dispatches += estimated.dispatchesPerView;
        bytes += estimated.bytesPerView;
    }
    EXPECT_EQ(estimated.dispatchesPerSharedView, 2u);
    EXPECT_GE(estimated.bytesPerSharedView, VkDeviceSize{camera.width} * camera.height * 12);
    spiedCalls().clear();
    const std::vector<Reflected> together = reflectTogether(view, descs);
    EXPECT_EQ(countSpied("CmdDispatch") + countSpied("CmdDispatchIndirect"),
              dispatches + estimated.dispatchesPerSharedView);
    EXPECT_EQ(countSpied("CreateImage"), 2 * descs.size() + 2);
    EXPECT_EQ(bytesSpied(), bytes + estimated.bytesPerSharedView);
    for (size_t i = 0; i < descs.size(); ++i) {
        EXPECT_EQ(together[i].info, alone[i].info) << i;
        EXPECT_EQ(together[i].color, alone[i].color) << i;
    }
    EXPECT_EQ(estimate(context(), &descs[0].reflection, {camera.width, camera.height}, &estimated,
                       {VK_SAMPLE_COUNT_64_BIT, VK_SAMPLE_COUNT_1_BIT}),
              Status::invalidArgument);
    EXPECT_NE(message().find("SceneSamples"), std::string::npos) << message();
}

} // namespace

INSTANTIATE_TEST_SUITE_P(, Multisampled,
                         testing::Values(VK_SAMPLE_COUNT_2_BIT, VK_SAMPLE_COUNT_4_BIT, VK_SAMPLE_COUNT_8_BIT),
                         [](const auto& info) { return "Samples" + std::to_string(info.param); });
