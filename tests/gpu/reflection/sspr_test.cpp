// SSPR against a traced truth: what it finds, where it errs, and that nothing about the host's conventions
// matters.
#include <algorithm>
#include <bit>
#include <map>
#include <string_view>

#include "reflection/core/reflector.h"
#include "reflection/sspr/sspr.h"
#include "seaglass/reflection.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/mirrored_depths.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Sspr : public ReflectionTest {};

TEST_F(Sspr, AgreesWithTheTracedTruth) {
    // Grazing, and at the edges of what is mirrored larger, holes are closed from their edges.
    const std::map<std::string_view, double> coverage = {
        {"level", 0.9945}, {"roll35", 0.989}, {"roll90", 0.9945}, {"steep", 0.986}, {"grazing", 0.993}};
    for (const Pose& pose : poses())
        for (const bool reversed : {true, false}) {
            Camera camera = pose.camera;
            camera.reversed = reversed;
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            const Score s = score(traced, reflectScene(camera, traced));
            print(pose.name, s);
            EXPECT_GE(s.coverage, coverage.at(pose.name)) << pose.name;
            EXPECT_LE(s.medianPixels, 0.15) << pose.name;
            EXPECT_LE(s.p95Pixels, 0.6) << pose.name;
            EXPECT_LE(s.p90Distance, 0.02) << pose.name;
            // The pier's deck hides the upper edge of the island, which is thought to go on.
            EXPECT_LE(s.falseOnSky, pose.name == std::string("grazing") ? 0.008 : 0.004) << pose.name;
            EXPECT_LE(s.skyOnGeometry, 0.01) << pose.name;
        }
}

// A house's wall behind a footbridge, which hides a strip of it.
TEST_F(Sspr, WhatShowsBesideGoesOnOutOfSight) {
    const Camera camera = testCamera();
    const Box deck{{-8, 1.4, -5}, {8, 1.7, -4.6}}, house{{-7, -1, -14}, {7, 7, -11}};
    const TracedView traced = Tracer(camera, {deck, house}).run();
    const TracedView withoutDeck = Tracer(camera, {house}).run();
    const Reflected result = reflectScene(camera, traced);
    size_t hidden = 0, found = 0;
    for (size_t i = 0; i < result.info.size(); ++i) {
        const double distance = traced.distance[i];
        if (traced.truth[i] != Truth::lost || distance != withoutDeck.distance[i]) continue;
        ++hidden;
        found += std::abs(double{result.info[i]} - distance) < 0.02 * distance;
    }
    std::printf("%zu of %zu found\n", found, hidden);
    EXPECT_GT(hidden, 1000u);
    EXPECT_GE(found, hidden * 4 / 5);
}

// Sky shows between the footbridge and the roof of a shed: the shed ends there.
TEST_F(Sspr, WhatIsSeenToEndDoesNotGoOn) {
    const Camera camera = testCamera();
    const Box deck{{-8, 1.4, -5}, {8, 1.7, -4.6}}, shed{{-7, -1, -6.1}, {7, 1.22, -6}};
    const TracedView traced = Tracer(camera, {deck, shed}).run();
    const Score s = score(traced, reflectScene(camera, traced));
    print("shed", s);
    EXPECT_LE(s.falseOnSky, 0.004);
}

// The railings of a footbridge: what shows of the farther one beside the nearer ends out of sight.
TEST_F(Sspr, RailsDoNotGoOnOutOfSight) {
    const Camera camera = testCamera();
    std::vector<Box> railings;
    for (const double low : {0.6, 0.9, 1.2, 1.5, 1.8})
        for (const double z : {-1.0, -2.0}) railings.push_back({{-5, low, z}, {4, low + 0.08, z + 0.08}});
    const TracedView traced = Tracer(camera, railings).run();
    const Score s = score(traced, reflectScene(camera, traced));
    print("railings", s);
    EXPECT_LE(s.falseOnSky, 0.008);
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

// A clinker boat, each plank a step before the one below, with its inside over the rail.
TEST_F(Sspr, NothingShowsThroughTheStepsOfAHull) {
    Camera camera = testCamera();
    camera.eye = {0, 2.3, 18};
    camera.target = {0, 0.1, 0};
    camera.fovDegrees = 6;
    std::vector<Box> boat;
    for (int plank = 0; plank < 5; ++plank)
        boat.push_back({{-3, 0.1 * plank - 0.1, -0.1}, {3, 0.1 * plank, 0.02 * plank}});
    const TracedView side = Tracer(camera, boat).run();
    boat.push_back({{-3, -0.2, -1.3}, {3, 0.62, -1.2}});
    const TracedView traced = Tracer(camera, boat).run();
    const Reflected result = reflectScene(camera, traced);
    size_t outside = 0, inside = 0;
    for (size_t i = 0; i < traced.truth.size(); ++i) {
        if (std::isinf(side.distance[i]) || side.distance[i] != traced.distance[i]) continue;
        ++outside;
        inside += double{result.info[i]} > traced.distance[i] + 0.6;
    }
    std::printf("%zu of %zu pixels that mirror the outside show the inside\n", inside, outside);
    EXPECT_GT(outside, 2000u);
    EXPECT_EQ(inside, 0u);
}

TEST_F(Sspr, KeysAreTheNearestMirroredDepths) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    const ReflectorDesc desc;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
    });
    const std::vector<uint32_t> keys =
        downloadWords(reflector->views[0].scratchOf<SsprScratch>().keys.handle(), traced.depth.size());

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
            size_t hits = 0, elsewhere = 0;
            for (size_t i = 0; i < traced.truth.size(); ++i) {
                if (!(result.info[i] > 0 && reference.info[i] > 0)) continue;
                elsewhere += std::abs(result.info[i] / reference.info[i] - 1) > 0.05f;
                ++hits;
            }
            EXPECT_LE(elsewhere, hits / 50) << "reversed " << reversed << " far " << far;
        }
}

TEST_F(Sspr, AnEmptySceneMirrorsOnlySky) {
    size_t sky = 0;
    for (const Pose& pose : poses()) {
        const TracedView traced = Tracer(pose.camera, {}).run();
        const Reflected result = reflectScene(pose.camera, traced);
        size_t aboveTheHorizon = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            ASSERT_NE(reflectionClass(result.info[i]), ReflectionClass::hit) << pose.name;
            ASSERT_EQ(result.color[i * 4 + 3], 0.0f) << pose.name;
            if (reflectionClass(result.info[i]) == ReflectionClass::sky)
                ++(traced.truth[i] == Truth::none ? aboveTheHorizon : sky);
        }
        EXPECT_EQ(aboveTheHorizon, 0u) << pose.name;
    }
    EXPECT_GT(sky, 100000u);
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
    for (const Level& level : {Level{1, true, 0.975, 0.7}, Level{2, false, 0.97, 0.9},
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
            EXPECT_LE(s.medianPixels, 0.15) << pose.name;
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

TEST_F(Sspr, PlanesOfOneFrameDoNotDisturbEachOther) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ReflectorDesc water, wall;
    water.reflection.distortion = 0;
    wall.plane[0] = -1; // x = 6, facing -x
    wall.plane[1] = 0;
    wall.plane[3] = 6;
    const std::vector<Reflected> together =
        reflectTogether(traced, viewDesc(camera), std::vector{water, wall});
    size_t hits = 0;
    for (const float info : together[1].info) hits += info > 0;
    EXPECT_GT(hits, 500u);
    for (size_t i = 0; i < 2; ++i) {
        const Reflected alone = reflectScene(camera, traced, i == 0 ? water : wall);
        EXPECT_EQ(together[i].color, alone.color);
        EXPECT_EQ(together[i].info, alone.info);
    }
}

// Of the same mirror's left half.
TEST_F(Sspr, IsResolvedWhereItsBoundsMayShow) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ReflectorDesc desc;
    desc.reflection.distortion = 0;
    desc.reflection.blurLevels = 0;
    const Reflected all = reflectScene(camera, traced, desc);
    const double low[3] = {-40, 0, -40}, high[3] = {-1, 0, 4};
    std::ranges::copy(low, desc.boundsLow);
    std::ranges::copy(high, desc.boundsHigh);
    const Reflected part = reflectScene(camera, traced, desc);
    size_t within = 0, left = 0;
    const glm::dmat4 clip = projectionMatrix(camera) * viewMatrix(camera);
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const size_t i = size_t{y} * camera.width + x;
            if (traced.truth[i] == Truth::none) continue;
            const glm::dvec4 p = glm::inverse(clip) * glm::dvec4((x + 0.5) / camera.width * 2 - 1,
                                                                 (y + 0.5) / camera.height * 2 - 1, 0.5, 1);
            const glm::dvec3 ray = glm::dvec3(p) / p.w - camera.eye;
            const glm::dvec3 on = camera.eye - ray * (camera.eye.y / ray.y);
            const bool inside = on.x >= low[0] && on.x <= high[0] && on.z >= low[2] && on.z <= high[2];
            if (inside) {
                ++within;
                EXPECT_EQ(part.info[i], all.info[i]);
                EXPECT_EQ(part.color[4 * i], all.color[4 * i]);
            } else {
                left += part.info[i] == 0 && all.info[i] != 0;
            }
        }
    EXPECT_GT(within, 3000u);
    EXPECT_GT(left, 3000u);
}

TEST_F(Sspr, WhatTheViewDoesNotSeeCostsNothing) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    struct Place {
        const char* name;
        double low[3], high[3];
        bool seen;
    };
    for (const Place& place :
         {Place{"behind", {-1, 0, 12}, {1, 0, 20}, false}, Place{"left", {-90, 0, -1}, {-80, 0, 1}, false},
          Place{"right", {80, 0, -1}, {90, 0, 1}, false},
          Place{"left, and reaching behind", {-30, 2, 5}, {-25, 2.4, 20}, false},
          Place{"right, and reaching behind", {25, 2, 5}, {30, 2.4, 20}, false},
          Place{"above, and reaching behind", {-1, 40, 5}, {1, 41, 20}, false},
          Place{"below, and reaching behind", {-1, -41, 5}, {1, -40, 20}, false},
          Place{"above", {-1, 40, -1}, {1, 41, 1}, false}, Place{"below", {-1, -40, 0}, {1, -39, 1}, false},
          Place{"around the eye", {-50, -1, -50}, {50, 5, 50}, true},
          Place{"ahead", {-1, 0, -1}, {1, 0, 1}, true}}) {
        ReflectorDesc desc;
        std::ranges::copy(place.low, desc.boundsLow);
        std::ranges::copy(place.high, desc.boundsHigh);
        Reflector* reflector = nullptr;
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        spiedCalls().clear();
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
        });
        EXPECT_EQ(countSpied("CmdDispatch") > 0, place.seen) << place.name;
        EXPECT_EQ(countSpied("CreateImage") > 0, place.seen) << place.name;
        destroyReflector(reflector);

        desc.reflection.technique = ReflectionTechnique::planar;
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        PlanarView planar;
        EXPECT_EQ(planarView(reflector, &view, &planar), Status::ok) << message();
        EXPECT_EQ(planar.visible, place.seen) << place.name;
        EXPECT_EQ(planar.color != VK_NULL_HANDLE, place.seen) << place.name;
        if (!place.seen)
            frame([&](VkCommandBuffer commands) {
                EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << message();
            });
        destroyReflector(reflector);
    }
}

TEST_F(Sspr, TooManyReflectorsAreRefusedBeforeAnyIsRecorded) {
    const ReflectorDesc desc;
    std::vector<Reflector*> many(maxReflectors + 1);
    for (Reflector*& reflector : many)
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    const ViewDesc view = viewDesc(testCamera());
    spiedCalls().clear();
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(reflect(commands, many.data(), maxReflectors + 1, &view), Status::invalidArgument);
    });
    EXPECT_NE(message().find("count is 17, expected 16 at most"), std::string::npos) << message();
    EXPECT_EQ(countSpied("CmdDispatch"), 0u);
    std::ranges::for_each(many, destroyReflector);
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
    for (const float light : {-0.01f, 1.01f, NAN})
        EXPECT_NE(refused([=](ReflectorDesc& d) {
                      d.reflection.undersideLight = light;
                  }).find("undersideLight is out of range, expected 0 to 1"),
                  std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) {
                  d.reflection.overhangSamples = 9;
              }).find("overhangSamples is out of range, expected 0 to 8"),
              std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.reflection.distortion = NAN; }).find("distortion"),
              std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.boundsLow[1] = 0; }).find("boundsLow"), std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) {
                  std::ranges::fill(d.boundsLow, 0);
                  std::ranges::fill(d.boundsHigh, -1);
              }).find("boundsHigh"),
              std::string::npos);
    EXPECT_NE(refused([](ReflectorDesc& d) { d.boundsHigh[2] = NAN; }).find("boundsHigh"), std::string::npos);
    EXPECT_EQ(createReflector(nullptr, nullptr, nullptr), Status::invalidArgument);
}

} // namespace
