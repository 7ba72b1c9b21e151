// A host that makes everything anew in each frame, and resizes, with three frames in flight, while other
// threads make pipelines: nothing piles up.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/faults/whole_scene.h"
#include "tests/unit/sea/starved.h"

namespace {

using namespace seaglass;
using namespace ::tests;

constexpr uint32_t slots = 3, sizes = 2, helpers = 3;
constexpr uint32_t period = slots * sizes; ///< frames after which all is as it was

struct Held {
    size_t objects = 0, bytes = 0, allocations = 0;
    bool operator==(const Held&) const = default;
};

class Host {
  public:
    Host() : scene_(device_, ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_1_BIT) {
        DeviceDesc desc = device_.desc();
        desc.framesInFlight = slots;
        EXPECT_EQ(createContext(&desc, &context_), Status::ok);
    }
    ~Host() {
        destroyContext(context_);
        EXPECT_EQ(device_.held(), 0u);
        EXPECT_EQ(device_.garbageDestroyed() + device_.garbageUsed(), 0u) << device_.complaint();
    }

    void frame(uint32_t number) {
        const VkExtent2D extent = {64 + 16 * (number % sizes), 48};
        EXPECT_EQ(beginFrame(context_, number % slots), Status::ok);
        Body* body = nullptr;
        ASSERT_EQ(createBody(context_, &scene_.bodyDesc(), &body), Status::ok);
        std::array<Target*, helpers> targets{};
        for (uint32_t i = 0; i < helpers; ++i) {
            TargetDesc desc;
            desc.colorFormat = i == 0 ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
            desc.depthFormat = VK_FORMAT_D32_SFLOAT;
            desc.depthWrite = i != 2;
            ASSERT_EQ(createTarget(context_, &desc, &targets[i]), Status::ok);
        }
        const ViewDesc& view = scene_.view(extent);
        std::array<std::thread, helpers> threads;
        for (uint32_t i = 0; i < helpers; ++i)
            threads[i] = std::thread([&, target = targets[i]] {
                EXPECT_EQ(prepare(target, body, &view, &scene_.lighting()), Status::ok);
            });
        EXPECT_EQ(simulate(device_.commands(), &body, 1, number), Status::ok);
        PlanarView bed;
        EXPECT_EQ(bedView(body, &view, &bed), Status::ok);
        EXPECT_EQ(reflect(device_.commands(), &body, 1, &view), Status::ok);
        EXPECT_EQ(shade(device_.commands(), &body, 1, &view, &scene_.lighting()), Status::ok);
        EXPECT_EQ(draw(device_.commands(), targets[0], &body, 1, &view, &scene_.lighting()), Status::ok);
        for (std::thread& thread : threads) thread.join();
        destroyBody(body);
        for (Target* const target : targets) destroyTarget(target);
    }

    Held held() const { return {device_.held(), device_.heldBytes(), tests::allocationsHeld()}; }

  private:
    FailingDevice device_;
    WholeScene scene_;
    Context* context_ = nullptr;
};

void endure(uint32_t frames) {
    Host host;
    uint32_t number = 0;
    // The first period fills pools.
    for (; number < 2 * period; ++number) host.frame(number);
    const Held before = host.held();
    for (; number < frames; ++number) host.frame(number);
    const Held after = host.held();
    std::printf("%u frames: %zu objects, %zu bytes of the device, %zu allocations\n", frames, after.objects,
                after.bytes, after.allocations);
    EXPECT_EQ(after.objects, before.objects);
    EXPECT_EQ(after.bytes, before.bytes);
    EXPECT_EQ(after.allocations, before.allocations);
}

// Of more sets than a pool of descriptors has room for.
TEST(Endurance, FramesOfManySets) {
    FailingDevice device;
    WholeScene scene(device, ReflectionTechnique::hybrid, VK_SAMPLE_COUNT_1_BIT);
    const DeviceDesc desc = device.desc();
    Context* context = nullptr;
    ASSERT_EQ(createContext(&desc, &context), Status::ok);
    std::array<Reflector*, maxReflectors> mirrors{};
    ReflectorDesc mirror;
    mirror.reflection.technique = ReflectionTechnique::hybrid;
    for (Reflector*& one : mirrors) ASSERT_EQ(createReflector(context, &mirror, &one), Status::ok);
    const ViewDesc& view = scene.view({64, 48});
    const auto pools = [&] {
        return std::ranges::count(device.calls(), std::string("descriptor pool"),
                                  [](const char* call) { return std::string(call); });
    };
    device.heal();
    size_t held = 0;
    for (uint32_t i = 0; i < 8; ++i) {
        ASSERT_EQ(beginFrame(context, i % 2), Status::ok);
        ASSERT_EQ(reflect(device.commands(), mirrors.data(), maxReflectors, &view), Status::ok);
        if (i == 3) {
            EXPECT_GT(pools(), 2) << "more than one to a frame";
            held = device.held();
        }
    }
    EXPECT_EQ(device.held(), held);
    for (Reflector* const one : mirrors) destroyReflector(one);
    destroyContext(context);
}

TEST(Endurance, ManyFrames) {
    endure(3 * period);
}

TEST(Endurance, AThousandFrames) {
    endure(168 * period);
}

} // namespace
