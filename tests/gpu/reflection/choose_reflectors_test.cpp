// Of many reflectors a few are renewed in a frame; the others keep what they have.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr uint32_t all = 40, few = 4;

/// Straight down, so that a square covers as its area says.
Camera overhead() {
    Camera camera;
    camera.eye = {0, 30, 0};
    camera.target = {0, 0, 0};
    camera.width = 320;
    camera.height = 180;
    return camera;
}

/// A box in the plane, in one of eight columns and five rows.
ReflectorDesc tileOf(uint32_t i, double half) {
    ReflectorDesc desc;
    desc.reflection.distortion = 0;
    desc.reflection.blurLevels = 0;
    const double x = 5.0 * (i % 8) - 17.5, z = 4.6 * (i / 8) - 9.2;
    const double low[] = {x - half, 0, z - half}, high[] = {x + half, 0, z + half};
    std::ranges::copy(low, desc.boundsLow);
    std::ranges::copy(high, desc.boundsHigh);
    return desc;
}

class ChooseReflectors : public ReflectionTest {
  protected:
    void TearDown() override {
        drop();
        ReflectionTest::TearDown();
    }

    void add(const ReflectorDesc& desc) {
        EXPECT_EQ(createReflector(context(), &desc, &reflectors_.emplace_back()), Status::ok) << message();
    }
    void drop() {
        for (Reflector* const reflector : reflectors_) destroyReflector(reflector);
        reflectors_.clear();
        frame([](VkCommandBuffer) {});
        frame([](VkCommandBuffer) {});
    }
    uint32_t count() const { return static_cast<uint32_t>(reflectors_.size()); }

    std::vector<uint32_t> choose(const ViewDesc& view, uint32_t most) {
        std::vector<uint32_t> chosen(most + 1, 777);
        uint32_t number = 777;
        EXPECT_EQ(chooseReflectors(reflectors_.data(), count(), &view, most, chosen.data(), &number),
                  Status::ok)
            << message();
        EXPECT_EQ(chosen.back(), 777u) << "beyond its room";
        chosen.resize(std::min(number, most));
        EXPECT_TRUE(std::ranges::is_sorted(chosen));
        return chosen;
    }

    /// A frame, with what was chosen in it.
    std::vector<uint32_t> renew(const ViewDesc& view, uint32_t most) {
        std::vector<uint32_t> chosen;
        frame([&](VkCommandBuffer commands) {
            chosen = choose(view, most);
            std::vector<Reflector*> some;
            for (const uint32_t i : chosen) some.push_back(reflectors_[i]);
            EXPECT_EQ(reflect(commands, some.data(), static_cast<uint32_t>(some.size()), &view), Status::ok)
                << message();
        });
        return chosen;
    }

    std::vector<float> infoOf(uint32_t i) const {
        const ReflectionImages images = reflectionImages(reflectors_[i], 0);
        return download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent);
    }
    uint32_t ageOf(uint32_t i) const { return reflectionImages(reflectors_[i], 0).age; }

    std::vector<Reflector*> reflectors_;
};

/// Half edges from 0.8 to 2.2 m, mixed.
double halfOf(uint32_t i) {
    return 0.8 + 1.4 * ((i * 17) % all) / (all - 1);
}

TEST_F(ChooseReflectors, OfFortyThoseThatCoverMostComeFirstAndEachInItsTurn) {
    const Camera camera = overhead();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(traced, view);
    std::vector<std::vector<uint32_t>> before;
    for (int run = 0; run < 2; ++run) {
        for (uint32_t i = 0; i < all; ++i) add(tileOf(i, halfOf(i)));
        std::vector<uint32_t> bySize(all), renewals(all), oldest(all);
        std::iota(bySize.begin(), bySize.end(), 0u);
        std::ranges::sort(bySize, std::greater(), halfOf);
        std::vector<std::vector<uint32_t>> sequence;
        for (uint32_t frame = 0; frame < 150; ++frame) {
            sequence.push_back(renew(view, few));
            ASSERT_EQ(sequence.back().size(), few);
            for (const uint32_t i : sequence.back()) {
                ++renewals[i];
                EXPECT_EQ(ageOf(i), 0u);
            }
            if (frame >= 10)
                for (uint32_t i = 0; i < all; ++i) oldest[i] = std::max(oldest[i], ageOf(i));
            // Those that have no picture yet, the largest first.
            if (frame < 10) {
                std::vector<uint32_t> largest(bySize.begin() + frame * few,
                                              bySize.begin() + (frame + 1) * few);
                std::ranges::sort(largest);
                EXPECT_EQ(sequence.back(), largest) << "frame " << frame;
            }
        }
        if (run == 0) before = sequence;
        EXPECT_EQ(sequence, before) << "the same calls choose the same";
        EXPECT_GE(*std::ranges::min_element(renewals), 2u) << "each gets its turn";
        EXPECT_GE(renewals[bySize.front()], 20u);
        EXPECT_GE(renewals[bySize.front()], 4 * renewals[bySize.back()]);
        EXPECT_LE(oldest[bySize.front()], 8u);
        for (uint32_t i = 0; i + 8 < all; i += 8)
            EXPECT_GE(renewals[bySize[i]], renewals[bySize[i + 8]]) << "by size, " << i;
        drop();
    }
}

TEST_F(ChooseReflectors, OfEqualsTheLowestIndexComesFirst) {
    for (uint32_t i = 0; i < 10; ++i) add(tileOf(12, 1));
    const Camera camera = overhead();
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(Tracer(camera, harbourOfBoxes()).run(), view);
    using Some = std::vector<uint32_t>;
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(renew(view, 4), (Some{0, 1, 2, 3}));
        EXPECT_EQ(renew(view, 4), (Some{4, 5, 6, 7}));
        EXPECT_EQ(renew(view, 2), (Some{8, 9}));
    }
}

TEST_F(ChooseReflectors, TheOthersKeepTheirPicturesAndTheCameraOfThem) {
    for (uint32_t i = 0; i < 8; ++i) add(tileOf(8 + i, i < 4 ? 2 : 0.5));
    Camera camera = overhead();
    camera.target = {0, 0, -3};
    std::vector<std::vector<float>> first(8);
    glm::dmat4 then(0);
    std::vector<SceneOnDevice> scenes;
    for (uint32_t frame = 0; frame < 3; ++frame) {
        camera.eye.x = 0.5 * frame;
        ViewDesc view = viewDesc(camera);
        scenes.push_back(upload(Tracer(camera, harbourOfBoxes()).run(), view));
        const std::vector<uint32_t> chosen = renew(view, 4);
        EXPECT_EQ(chosen,
                  frame == 1 ? (std::vector<uint32_t>{4, 5, 6, 7}) : (std::vector<uint32_t>{0, 1, 2, 3}));
        if (frame == 1) then = projectionMatrix(camera) * viewMatrix(camera);
        if (frame == 1)
            for (uint32_t i = 0; i < 8; ++i) first[i] = infoOf(i);
    }
    for (uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(ageOf(i), i < 4 ? 0u : 1u);
        if (i < 4) continue;
        EXPECT_EQ(infoOf(i), first[i]) << i;
        EXPECT_EQ(matrix(reflectionImages(reflectors_[i], 0).clipFromWorld), then);
    }
}

TEST_F(ChooseReflectors, WhatIsOutOfSightIsNotAndAnotherSizeIsAsNew) {
    add(tileOf(12, 1));
    add(tileOf(12, 1));
    ReflectorDesc away = tileOf(12, 1);
    away.boundsLow[0] += 1000;
    away.boundsHigh[0] += 1000;
    add(away);
    ReflectorDesc skyAlone = tileOf(12, 1);
    skyAlone.reflection.technique = ReflectionTechnique::sky;
    add(skyAlone);
    Camera camera = overhead();
    ViewDesc view = viewDesc(camera);
    const SceneOnDevice scene = upload(Tracer(camera, harbourOfBoxes()).run(), view);
    EXPECT_EQ(renew(view, 16), (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(renew(view, 1), (std::vector<uint32_t>{0}));
    camera.width = 160;
    camera.height = 90;
    ViewDesc smaller = viewDesc(camera);
    const SceneOnDevice small = upload(Tracer(camera, harbourOfBoxes()).run(), smaller);
    EXPECT_EQ(renew(smaller, 1), (std::vector<uint32_t>{0}))
        << "1 has waited longer, but neither is of this size";
    EXPECT_EQ(renew(smaller, 1), (std::vector<uint32_t>{1}));
}

// The host draws for those alone.
TEST_F(ChooseReflectors, PlanarOnesAreDrawnWhereChosen) {
    for (uint32_t i = 0; i < 6; ++i) {
        ReflectorDesc desc = tileOf(10 + i % 4, 1);
        desc.reflection.technique = ReflectionTechnique::planar;
        add(desc);
    }
    const ViewDesc view = viewDesc(overhead());
    for (int round = 0; round < 2; ++round)
        for (uint32_t half = 0; half < 2; ++half)
            frame([&](VkCommandBuffer commands) {
                const std::vector<uint32_t> chosen = choose(view, 3);
                EXPECT_EQ(chosen.size(), 3u);
                for (const uint32_t i : chosen) {
                    PlanarView drawn;
                    EXPECT_EQ(planarView(reflectors_[i], &view, &drawn), Status::ok) << message();
                    beginDrawing(context(), commands, drawn);
                    vkCmdEndRendering(commands);
                    EXPECT_EQ(reflect(commands, &reflectors_[i], 1, &view), Status::ok) << message();
                }
            });
}

TEST_F(ChooseReflectors, BadArgumentsAreNamed) {
    add(tileOf(3, 1));
    const ViewDesc view = viewDesc(overhead());
    uint32_t chosen[16], number = 5;
    frame([](VkCommandBuffer) {});
    for (const uint32_t most : {0u, 17u}) {
        EXPECT_EQ(chooseReflectors(reflectors_.data(), 1, &view, most, chosen, &number),
                  Status::invalidArgument);
        EXPECT_NE(message().find("most is " + std::to_string(most) + ", expected 1 to 16"), std::string::npos)
            << message();
        EXPECT_EQ(number, 0u);
    }
    EXPECT_EQ(chooseReflectors(reflectors_.data(), 1, nullptr, 4, chosen, &number), Status::invalidArgument);
    EXPECT_NE(message().find("view is null"), std::string::npos);
    Reflector* const withNull[] = {reflectors_[0], nullptr};
    EXPECT_EQ(chooseReflectors(withNull, 2, &view, 4, chosen, &number), Status::invalidArgument);
    EXPECT_NE(message().find("reflectors[1] is null"), std::string::npos) << message();
    ViewDesc broken = view;
    broken.projection[0] = NAN;
    EXPECT_EQ(chooseReflectors(reflectors_.data(), 1, &broken, 4, chosen, &number), Status::invalidArgument);
    EXPECT_EQ(chooseReflectors(nullptr, 0, &view, 4, chosen, &number), Status::ok);
    EXPECT_EQ(number, 0u);
}

class ReflectionHeight : public ReflectionTest {};

TEST_F(ReflectionHeight, IsThatOfTheNearestPowerOfTwoAndTakesThePlaceOfDownscale) {
    struct Case {
        uint32_t view, height, expected;
    };
    for (const Case& c :
         {Case{1080, 0, 540}, Case{1080, 540, 540}, Case{1080, 512, 540}, Case{1080, 720, 540},
          Case{1080, 800, 1080}, Case{2160, 540, 540}, Case{720, 540, 720}, Case{720, 128, 180},
          Case{360, 16384, 360}, Case{1080, 8, 135}}) {
        ReflectorDesc desc;
        desc.reflection.downscale = 2;
        desc.reflection.height = c.height;
        Estimate said, meant;
        const VkExtent2D extent = {c.view * 16 / 9, c.view};
        EXPECT_EQ(estimate(context(), &desc.reflection, extent, &said), Status::ok) << message();
        desc.reflection.height = 0;
        desc.reflection.downscale = c.view / c.expected;
        EXPECT_EQ(estimate(context(), &desc.reflection, extent, &meant), Status::ok) << message();
        EXPECT_EQ(said.bytesPerView, meant.bytesPerView) << c.height << " of " << c.view;
    }
}

TEST_F(ReflectionHeight, GivesTheSameBitsAsTheDownscaleItMeans) {
    const Camera camera = testCamera();
    const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
    for (const ReflectionTechnique technique :
         {ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        ReflectorDesc byHeight = with(technique), byScale = with(technique);
        byHeight.reflection.height = camera.height / 2 - 10;
        byScale.reflection.downscale = 2;
        const Reflected a = reflectScene(camera, traced, byHeight), b = reflectScene(camera, traced, byScale);
        EXPECT_TRUE(a.info == b.info) << static_cast<int>(technique);
        EXPECT_TRUE(a.color == b.color) << static_cast<int>(technique);
        EXPECT_EQ(a.info.size(), size_t{camera.width / 2} * camera.height / 2);
    }
}

TEST_F(ReflectionHeight, CostsWhatTheEstimateSaysAndIsRefusedOutOfRange) {
    for (const ReflectionTechnique technique : {ReflectionTechnique::sspr, ReflectionTechnique::hybrid}) {
        ReflectorDesc desc = with(technique);
        desc.reflection.height = 100;
        desc.reflection.temporal = 0.9f;
        expectEstimateHolds(desc, {640, 360});
    }
    for (const uint32_t height : {1u, 7u, 16385u}) {
        ReflectorDesc desc;
        desc.reflection.height = height;
        Reflector* reflector = nullptr;
        EXPECT_EQ(createReflector(context(), &desc, &reflector), Status::invalidArgument);
        EXPECT_NE(message().find("ReflectionDesc.height is out of range, expected 0 or 8 to 16384"),
                  std::string::npos)
            << message();
    }
}

TEST_F(ReflectionHeight, OfAHostsDrawingIsSaidWithTheImages) {
    ReflectorDesc desc;
    desc.reflection.technique = ReflectionTechnique::planar;
    desc.reflection.height = 64;
    Reflector* reflector = nullptr;
    ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
    const Camera camera = testCamera(); // 272 rows
    const ViewDesc view = viewDesc(camera);
    PlanarView drawn;
    frame([&](VkCommandBuffer) { EXPECT_EQ(planarView(reflector, &view, &drawn), Status::ok) << message(); });
    EXPECT_EQ(drawn.extent.height, 68u);
    EXPECT_EQ(drawn.extent.width, 120u);
    EXPECT_EQ(reflectionImages(reflector, 0).downscale, 4u);
    destroyReflector(reflector);
    frame([](VkCommandBuffer) {});
    frame([](VkCommandBuffer) {});
}

} // namespace
