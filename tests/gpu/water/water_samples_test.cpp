// Water over multisampled scenes, and drawn into multisampled targets.
#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/multisampled_scene.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr VkSampleCountFlagBits many = VK_SAMPLE_COUNT_4_BIT;

Camera aboveTheBed() {
    Camera camera;
    camera.width = 240;
    camera.height = 136;
    camera.eye = {-1, 5, 9};
    camera.target = {-1, 0, -2};
    return camera;
}

std::vector<Box> harbourOnABed() {
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back({{-60, -3.5, -100}, {60, -3, 40}});
    boxes.push_back({{-4, -3, -1}, {2, -1, 2}});
    return boxes;
}

class WaterSamples : public WaterTest {
  protected:
    void SetUp() override {
        WaterTest::SetUp();
        if (!canMultisample(many)) GTEST_SKIP() << "the device has no " << many << " samples";
    }
    /// Clear water, so that a picture's red and green tell where the bed was looked up.
    BodyDesc clearBody() const {
        BodyDesc desc;
        desc.refraction = &clear;
        return desc;
    }
    void seeThrough(const MultisampledScene& scene, bool resolved) {
        changeView = [&scene, resolved](ViewDesc& view) {
            view.sceneDepth = asSeaglass(scene.depth);
            view.sceneDepth.layout = VK_IMAGE_LAYOUT_GENERAL;
            view.sceneDepth.samples = many;
            view.sceneColor = asSeaglass(resolved ? scene.resolved : scene.color);
            if (resolved) return;
            view.sceneColor.layout = VK_IMAGE_LAYOUT_GENERAL;
            view.sceneColor.samples = many;
        };
    }
    const RefractionDesc clear = {{0, 0, 0}, {0, 0, 0}, 1};
};

TEST_F(WaterSamples, RefractionSeesAMultisampledSceneAsASingleSampledOne) {
    const Camera camera = aboveTheBed();
    const TracedView traced = Tracer(camera, harbourOnABed()).run();
    const MultisampledScene scene = drawMultisampled(camera, harbourOnABed(), many);
    ReflectionDesc reflection;
    reflection.undersideLight = 1; // colours are places
    for (const bool reflects : {false, true})
        for (const bool resolved : {false, true}) {
            BodyDesc desc = clearBody();
            if (reflects) desc.reflection = &reflection;
            const std::vector<Body*> body = {makeBody(desc)};
            changeView = nullptr;
            const WaterPicture single =
                picture(body, camera, 0, SurfaceOutput::shaded, {traced.color, traced.depth});
            seeThrough(scene, resolved);
            const WaterPicture seen = picture(body, camera);
            size_t compared = 0, apart = 0;
            glm::dvec2 shift(0);
            for (size_t i = 0; i < single.color.size() / 4; ++i) {
                // Nobody sees water where something stands before it.
                if (!single.covered(i) || single.depth[i] < traced.depth[i]) continue;
                ++compared;
                const glm::dvec2 pixels = glm::dvec2(seen.color[i * 4] - single.color[i * 4],
                                                     seen.color[i * 4 + 1] - single.color[i * 4 + 1]) *
                                          glm::dvec2(camera.width, camera.height);
                if (glm::length(pixels) > 1.6)
                    ++apart; // at edges
                else
                    shift += pixels;
            }
            shift /= static_cast<double>(compared);
            std::printf("%zu compared, %zu apart, the rest by %.3f, %.3f pixels\n", compared, apart, shift.x,
                        shift.y);
            EXPECT_GT(compared, 15000u);
            EXPECT_LE(apart, compared / (reflects ? 27 : 62));
            // A mean of samples lies around the pixel's middle, off which depth is looked up.
            EXPECT_LE(glm::length(shift), resolved ? 0.4 : 0.1);
        }
}

// Neither what lies behind a thing and was mixed into its edge, nor the thing itself where it covers sample 0
// of a pixel.
TEST_F(WaterSamples, NothingThatStandsBeforeWaterIsOutlined) {
    const Camera camera = aboveTheBed();
    std::vector<Box> boxes = harbourOfBoxes();
    for (Box& box : boxes) box.low.y = std::max(box.low.y, 0.0); // what lies in the water is seen through it
    const BodyDesc desc = clearBody();
    const std::vector<Body*> body = {makeBody(desc)};
    for (const Radiances& radiances : {Radiances{0, 50}, Radiances{50, 0}}) {
        const MultisampledScene scene = drawMultisampled(camera, boxes, many, &radiances);
        for (const bool resolved : {true, false}) {
            seeThrough(scene, resolved);
            const WaterPicture seen = picture(body, camera);
            size_t edges = 0, outlined = 0;
            for (size_t i = 0; i < scene.things.size(); ++i) {
                if (!seen.covered(i) || scene.things[i] == 0 || scene.things[i] == many) continue;
                ++edges;
                outlined += seen.color[i * 4] > 5; // of a sky of 1
            }
            std::printf("%zu of %zu edges are outlined\n", outlined, edges);
            EXPECT_GT(edges, 200u);
            EXPECT_LE(outlined, edges / 50);
        }
    }
}

/// Dispatches that list a surface's tiles.
constexpr size_t listing = 3;

TEST_F(WaterSamples, OnlyViewsThatHaveManyMakeImages) {
    const Camera camera = aboveTheBed();
    const MultisampledScene scene = drawMultisampled(camera, harbourOnABed(), many);
    const BodyDesc desc = clearBody();
    Estimate estimated;
    ASSERT_EQ(estimate(context(), &desc, {camera.width, camera.height}, &estimated), Status::ok) << message();
    EXPECT_EQ(estimated.bytesPerSharedView, 0u);
    EXPECT_EQ(estimated.dispatchesPerSharedView, 0u);
    const std::vector<Body*> bodies = {makeBody(desc), makeBody(desc)};
    for (int slot = 0; slot < 2; ++slot) picture(bodies, camera); // makes uniform blocks
    spiedCalls().clear();
    picture(bodies, camera);
    EXPECT_EQ(countSpied("CreateImage"), 0u);
    EXPECT_EQ(countSpied("CmdDispatch"), bodies.size() * listing);
    for (const bool resolved : {true, false}) {
        const SceneSamples samples = {many, resolved ? VK_SAMPLE_COUNT_1_BIT : many};
        ASSERT_EQ(estimate(context(), &desc, {camera.width, camera.height}, &estimated, samples), Status::ok)
            << message();
        seeThrough(scene, resolved);
        spiedCalls().clear();
        picture(bodies, camera);
        EXPECT_EQ(countSpied("CreateImage"), 2u);
        EXPECT_EQ(bytesSpied(), estimated.bytesPerSharedView);
        EXPECT_EQ(countSpied("CmdDispatch"), estimated.dispatchesPerSharedView + bodies.size() * listing);
        spiedCalls().clear();
        picture(bodies, camera);
        EXPECT_EQ(countSpied("CreateImage"), 0u);
        // Let go by a frame without, and so made anew.
        changeView = nullptr;
        picture(bodies, camera);
        spiedCalls().clear();
        seeThrough(scene, resolved);
        picture(bodies, camera);
        EXPECT_EQ(countSpied("CreateImage"), 2u);
        changeView = nullptr;
        picture(bodies, camera);
    }
    EXPECT_EQ(estimate(context(), &desc, {camera.width, camera.height}, &estimated,
                       {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_64_BIT}),
              Status::invalidArgument);
    EXPECT_NE(message().find("SceneSamples"), std::string::npos) << message();
}

TEST_F(WaterSamples, ViewsThatDoNotSeeTheWaterTakeNone) {
    Camera camera = aboveTheBed();
    const MultisampledScene scene = drawMultisampled(camera, harbourOnABed(), many);
    seeThrough(scene, false);
    BodyDesc desc = clearBody();
    Body* endless = makeBody(desc);
    desc.extent.shape = ExtentShape::rectangle;
    desc.extent.center[0] = camera.target.x;
    desc.extent.size[0] = desc.extent.size[1] = 4;
    Body* pool = makeBody(desc);
    const auto dispatches = [&](Body* body) {
        spiedCalls().clear();
        picture({body}, camera);
        return countSpied("CmdDispatch");
    };
    EXPECT_EQ(dispatches(endless), 2u + listing);
    EXPECT_EQ(dispatches(pool), 2u + listing);
    camera.target = camera.eye + glm::dvec3(0, 1, -1); // the sky
    EXPECT_EQ(dispatches(endless), 0u);
    EXPECT_EQ(dispatches(pool), 0u);
    camera.target = camera.eye + glm::dvec3(0, -0.3, 1); // the sea behind
    EXPECT_EQ(dispatches(endless), 2u + listing);
    EXPECT_EQ(dispatches(pool), 0u);
    EXPECT_EQ(countSpied("CmdDrawIndexed"), 0u);
}

TEST_F(WaterSamples, TheEstimateOfABodyHasThoseOfItsReflection) {
    ReflectionDesc reflection;
    reflection.blurLevels = 0; // of which still water has none
    BodyDesc desc;
    desc.reflection = &reflection;
    Estimate body, reflector, surface;
    ASSERT_EQ(estimate(context(), &desc, {320, 180}, &body, {many, many}), Status::ok) << message();
    ASSERT_EQ(estimate(context(), &reflection, {320, 180}, &reflector, {many, many}), Status::ok);
    const BodyDesc plain;
    ASSERT_EQ(estimate(context(), &plain, {320, 180}, &surface), Status::ok);
    EXPECT_EQ(body.bytesPerView, reflector.bytesPerView + surface.bytesPerView);
    EXPECT_GE(body.bytesPerSharedView, VkDeviceSize{320} * 180 * 12);
    EXPECT_EQ(body.bytesPerSharedView, reflector.bytesPerSharedView);
    EXPECT_EQ(body.dispatchesPerSharedView, 2u);
    // Refraction reads the same.
    desc.refraction = &clear;
    ASSERT_EQ(estimate(context(), &desc, {320, 180}, &body, {many, many}), Status::ok) << message();
    EXPECT_EQ(body.bytesPerSharedView, reflector.bytesPerSharedView);
    EXPECT_EQ(body.dispatchesPerSharedView, 2u);
}

TEST_F(WaterSamples, DrawingBeforeReflectIsRefused) {
    const Camera camera = aboveTheBed();
    const MultisampledScene scene = drawMultisampled(camera, harbourOnABed(), many);
    Body* body = makeBody(clearBody());
    seeThrough(scene, true);
    ViewDesc view = viewDesc(camera);
    changeView(view);
    Target* target = nullptr;
    const TargetDesc targetDesc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
    ASSERT_EQ(createTarget(context(), &targetDesc, &target), Status::ok);
    const auto expectRefused = [&] {
        frame([&](VkCommandBuffer commands) {
            spiedCalls().clear();
            EXPECT_MISUSE(draw(commands, target, &body, 1, &view, &lighting), "ViewDesc.sceneDepth.samples",
                          message());
            EXPECT_EQ(countSpied("CmdDrawIndexed") + countSpied("CmdDraw"), 0u);
        });
    };
    expectRefused();
    picture({body}, camera);
    view.viewIndex = 3; // another view's
    expectRefused();
    destroyTarget(target);
}

TEST_F(WaterSamples, AMultisampledTargetShowsTheSamePicture) {
    SeaDesc waves;
    waves.windSpeed = 4;
    waves.seed = 3;
    const FoamDesc foam;
    const ReflectionDesc reflection;
    BodyDesc desc = clearBody();
    desc.waves = &waves;
    desc.wavesBackend = fftwWaves();
    desc.foam = &foam;
    desc.reflection = &reflection;
    const std::vector<Body*> body = {makeBody(desc)};
    const Camera camera = aboveTheBed();
    const TracedView traced = Tracer(camera, harbourOnABed()).run();
    const SceneBehind behind = {traced.color, traced.depth};
    const WaterPicture one = picture(body, camera, 5, SurfaceOutput::shaded, behind);
    useSamples(many);
    const WaterPicture four = picture(body, camera, 5, SurfaceOutput::shaded, behind);
    size_t compared = 0, apart = 0;
    for (size_t i = 0; i < one.color.size() / 4; ++i) {
        if (!one.covered(i)) continue;
        ++compared;
        for (size_t c = 0; c < 3; ++c)
            if (std::abs(one.color[i * 4 + c] - four.color[i * 4 + c]) > 0.02f) {
                ++apart;
                break;
            }
    }
    std::printf("%zu compared, %zu apart\n", compared, apart);
    EXPECT_GT(compared, 15000u);
    EXPECT_LE(apart, compared / 20); // where triangles meet, and where the bent ray passes an edge
}

} // namespace
