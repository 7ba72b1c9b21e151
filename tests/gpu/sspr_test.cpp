// SSPR against a traced truth: what it finds, where it errs, and that nothing about the host's conventions
// matters.
#include <algorithm>
#include <bit>
#include <map>
#include <string_view>

#include "reflection/reflector.h"
#include "seaglass/reflection.h"
#include "tests/gpu/mirrored_depths.h"
#include "tests/gpu/poses.h"
#include "tests/gpu/reflection_rig.h"
#include "tests/gpu/spy.h"

namespace {

using namespace seaglass;
using namespace tests;

class Sspr : public ReflectionTest {};

TEST_F(Sspr, AgreesWithTheTracedTruth) {
    // Grazing, and at the edges of what is mirrored larger, holes are closed from their edges.
    const std::map<std::string_view, double> coverage = {
        {"level", 0.9945}, {"roll35", 0.988}, {"roll90", 0.9945}, {"steep", 0.984}, {"grazing", 0.992}};
    for (const Pose& pose : poses())
        for (const bool reversed : {true, false}) {
            Camera camera = pose.camera;
            camera.reversed = reversed;
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            const Score s = score(traced, reflectScene(camera, traced));
            print(pose.name, s);
            EXPECT_GE(s.coverage, coverage.at(pose.name)) << pose.name;
            EXPECT_LE(s.medianPixels, 0.45) << pose.name;
            EXPECT_LE(s.p95Pixels, 0.75) << pose.name;
            EXPECT_LE(s.falseOnSky, 0.004) << pose.name;
            EXPECT_LE(s.skyOnGeometry, 0.01) << pose.name;
        }
}

// A flaring hull is seen foreshortened and mirrored at about three times that height: between its keys those
// of the wall behind it show, which are as true to the screen.
TEST_F(Sspr, NothingShowsThroughTheHolesOfWhatIsMirroredLarger) {
    Camera camera = testCamera();
    camera.eye = {0, 1.6, 4};
    camera.target = {0, 0.9, 0};
    camera.fovDegrees = 70;
    const Box hull{{-6, -1, -2}, {6, 0.7, 0}, 1.2};
    const TracedView traced = Tracer(camera, {hull, {{-9, -1, -12}, {9, 9, -11}}}).run();
    const Score s = score(traced, reflectScene(camera, traced));
    print("holes", s);
    std::printf("         misplaced %.5f\n", s.misplaced);
    EXPECT_GE(s.coverage, 0.99);
    EXPECT_LE(s.misplaced, 0.002);
}

TEST_F(Sspr, KeysAreTheNearestMirroredDepths) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    const demos::Image depth = uploadFloats(traced.width, traced.height, 1, traced.depth);
    const demos::Image color = uploadFloats(traced.width, traced.height, 4, traced.color);
    ViewDesc view = viewDesc(camera);
    view.sceneDepth = asSeaglass(depth);
    view.sceneColor = asSeaglass(color);
    const ReflectorDesc desc;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
    });
    const std::vector<uint32_t> keys =
        downloadWords(reflector->views[0].sspr.keys.handle(), traced.depth.size());

    const std::vector<MirroredDepth> expected = mirroredDepths(camera, traced);
    size_t filled = 0, wrong = 0;
    for (size_t i = 0; i < keys.size(); ++i) {
        filled += expected[i].sure && expected[i].nearest > 0;
        wrong += expected[i].differsFrom(std::bit_cast<float>(keys[i]));
    }
    EXPECT_GT(filled, 5000u);
    EXPECT_EQ(wrong, 0u);
    destroyReflector(reflector);
}

TEST_F(Sspr, EachPassWaitsForTheOneBefore) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    spiedCalls().clear();
    reflectScene(testCamera(), traced);
    const std::vector<SpiedCall> calls = spiedCalls();
    const auto next = [&](auto from, const char* name) {
        return std::ranges::find(from, calls.end(), name, &SpiedCall::name);
    };
    const auto fill = next(calls.begin(), "CmdFillBuffer");
    const auto scatter = next(fill, "CmdDispatch");
    ASSERT_NE(scatter, calls.end());
    const auto tiles = next(scatter + 1, "CmdDispatch");
    ASSERT_NE(tiles, calls.end());
    const auto resolve = next(tiles, "CmdDispatchIndirect");
    ASSERT_NE(resolve, calls.end());
    const auto waits = [](auto from, auto to, VkAccessFlags2 source, VkAccessFlags2 target) {
        return std::any_of(from, to, [&](const SpiedCall& call) {
            return (call.source & source) == source && (call.target & target) == target;
        });
    };
    constexpr VkAccessFlags2 written = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    EXPECT_TRUE(waits(fill, scatter, VK_ACCESS_2_TRANSFER_WRITE_BIT, written));
    EXPECT_TRUE(waits(scatter, tiles, written, VK_ACCESS_2_SHADER_STORAGE_READ_BIT));
    EXPECT_TRUE(waits(tiles, resolve, written,
                      VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT));
    EXPECT_TRUE(waits(resolve, calls.end(), written, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT));
}

TEST_F(Sspr, DepthConventionsGiveTheSameClasses) {
    const TracedView traced = Tracer(testCamera(), harbourOfBoxes()).run();
    const Reflected reference = reflectScene(testCamera(), traced);
    for (const bool reversed : {true, false})
        for (const double far : {0.0, 1000.0}) {
            Camera camera = testCamera();
            camera.reversed = reversed;
            camera.far = far;
            const TracedView other = Tracer(camera, harbourOfBoxes()).run();
            const Reflected result = reflectScene(camera, other);
            size_t differing = 0;
            for (size_t i = 0; i < traced.truth.size(); ++i)
                differing += reflectionClass(result.info[i]) != reflectionClass(reference.info[i]);
            // Depth rounds differently, so that single pixels at edges may go the other way.
            EXPECT_LE(differing, traced.truth.size() / 500) << "reversed " << reversed << " far " << far;
        }
}

TEST_F(Sspr, AnEmptySceneMirrorsOnlySky) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, {}).run();
    const Reflected result = reflectScene(camera, traced);
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        EXPECT_NE(reflectionClass(result.info[i]), ReflectionClass::hit);
        EXPECT_EQ(result.color[i * 4 + 3], 0.0f);
    }
}

TEST_F(Sspr, StaysFiniteAtTheExtremes) {
    for (const Camera& camera : extremeCameras()) {
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        const Reflected result = reflectScene(camera, traced);
        EXPECT_TRUE(std::ranges::all_of(result.color, [](float v) { return std::isfinite(v); }))
            << camera.eye.y;
        EXPECT_TRUE(std::ranges::all_of(result.info, [](float v) { return std::isfinite(v); }))
            << camera.eye.y;
    }
}

TEST_F(Sspr, SizeMayChangeEveryFrame) {
    const ReflectorDesc desc;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    std::vector<demos::Image> kept;
    for (const uint32_t width : {64u, 200u, 1u, 131u}) {
        Camera camera = testCamera();
        camera.width = width;
        camera.height = 40;
        const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
        ViewDesc view = viewDesc(camera);
        view.sceneDepth = asSeaglass(kept.emplace_back(uploadFloats(width, 40, 1, traced.depth)));
        view.sceneColor = asSeaglass(kept.emplace_back(uploadFloats(width, 40, 4, traced.color)));
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        EXPECT_EQ(reflectionImages(reflector, 0).extent.width, width);
    }
    destroyReflector(reflector);
}

TEST_F(Sspr, LowerResolutionsFindWhatTheyCanHold) {
    struct Level {
        uint32_t downscale;
        bool coarseKeys;
        double coverage;  // at least
        double p95Pixels; // at most: looking steeply, walls that keys missed show the tops behind them
    };
    for (const Level& level : {Level{1, true, 0.975, 1.2}, Level{2, false, 0.97, 1.8},
                               Level{4, false, 0.95, 0.3}, Level{8, false, 0.9, 0.3}})
        for (const Pose& pose : poses()) {
            const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
            ReflectorDesc desc;
            desc.reflection.downscale = level.downscale;
            desc.reflection.coarseKeys = level.coarseKeys;
            const Reflected result = reflectScene(pose.camera, traced, desc);
            // Pixels of a smaller picture lie in the middle of the blocks that the reflection holds.
            Camera small = pose.camera;
            small.width /= level.downscale;
            small.height /= level.downscale;
            const TracedView truth = Tracer(small, harbourOfBoxes()).run();
            const Score s = score(truth, result);
            std::printf("1/%u%s ", level.downscale, level.coarseKeys ? " coarse" : "");
            print(pose.name, s);
            EXPECT_GE(s.coverage, level.coverage) << pose.name;
            EXPECT_LE(s.medianPixels, 0.5) << pose.name;
            EXPECT_LE(s.p95Pixels, level.p95Pixels) << pose.name;
            EXPECT_LE(s.falseOnSky, 0.02) << pose.name;
        }
}

TEST_F(Sspr, TheEstimateIsWhatIsAllocatedAndDispatched) {
    for (const uint32_t blurLevels : {0u, 4u}) {
        ReflectorDesc desc;
        desc.reflection.blurLevels = blurLevels;
        const Estimate estimated = expectEstimateHolds(desc, {640, 360});
        if (blurLevels == 0) {
            EXPECT_LE(estimated.bytesPerView, 16u * 640 * 360);
        }
    }
}

TEST_F(Sspr, TheSkyTechniqueHoldsNothing) {
    ReflectorDesc desc;
    desc.reflection.technique = ReflectionTechnique::sky;
    spiedCalls().clear();
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    EXPECT_EQ(reflectionImages(reflector, 0).color, VkImageView(VK_NULL_HANDLE));
    EXPECT_EQ(countSpied("CreateComputePipelines"), 0u);
    destroyReflector(reflector);
}

TEST_F(Sspr, BadDescriptionsAreNamedAndLeaveNothing) {
    const auto refused = [&](auto&& spoil) {
        ReflectorDesc desc;
        spoil(desc);
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        EXPECT_EQ(reflector, nullptr);
        return message();
    };
    EXPECT_NE(refused([](ReflectorDesc& d) { d.plane[1] = 0; }).find("plane"), std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.plane[3] = NAN; }).find("plane"), std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.reflection.edgeFade = -1; }).find("edgeFade"),
              std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.reflection.distortion = NAN; }).find("distortion"),
              std::string::npos);
    EXPECT_EQ(createReflector(nullptr, nullptr, nullptr), Status::invalidArgument);
}

} // namespace
