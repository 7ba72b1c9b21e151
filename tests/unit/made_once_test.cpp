#include "gpu/made_once.h"

#include <atomic>
#include <latch>
#include <new>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace {

using seaglass::Status;
using seaglass::gpu::MadeOnce;

struct Thing {
    int number = 0;
};

TEST(MadeOnce, IsMadeByOneOfManyThreads) {
    MadeOnce<int, Thing> things;
    std::atomic<int> made{0}, wrong{0};
    std::vector<std::thread> threads;
    std::latch together(4);
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            together.arrive_and_wait();
            for (int key = 0; key < 200; ++key) {
                const Thing* thing = nullptr;
                const Status status = things.get(
                    key,
                    [&](Thing& fresh) {
                        std::this_thread::yield(); // the others come meanwhile
                        fresh.number = key + 1;
                        ++made;
                        return Status::ok;
                    },
                    thing);
                wrong += status != Status::ok || thing->number != key + 1;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(made, 200);
    EXPECT_EQ(wrong, 0);
}

TEST(MadeOnce, WhatThrewIsMadeAnew) {
    MadeOnce<int, Thing> things;
    const Thing* thing = nullptr;
    const auto throws = [](Thing& fresh) -> Status {
        fresh.number = 1; // a part of it
        throw std::bad_alloc();
    };
    EXPECT_THROW((void)things.get(1, throws, thing), std::bad_alloc);
    EXPECT_EQ(thing, nullptr);
    const auto counts = [](Thing& fresh) {
        ++fresh.number;
        return Status::ok;
    };
    EXPECT_EQ(things.get(1, counts, thing), Status::ok);
    ASSERT_NE(thing, nullptr);
    EXPECT_EQ(thing->number, 1) << "of a fresh one";
}

// One that takes long keeps nobody from another.
TEST(MadeOnce, OthersDoNotWait) {
    MadeOnce<int, Thing> things;
    std::atomic<bool> begun{false}, release{false};
    std::thread slow([&] {
        const Thing* thing = nullptr;
        EXPECT_EQ(things.get(
                      1,
                      [&](Thing&) {
                          begun = true;
                          while (!release) std::this_thread::yield();
                          return Status::ok;
                      },
                      thing),
                  Status::ok);
    });
    while (!begun) std::this_thread::yield();
    const Thing* thing = nullptr;
    EXPECT_EQ(things.get(
                  2, [](Thing&) { return Status::ok; }, thing),
              Status::ok);
    EXPECT_NE(thing, nullptr);
    release = true;
    slow.join();
}

TEST(MadeOnce, WhatFailedIsMadeAnew) {
    MadeOnce<int, Thing> things;
    const Thing* thing = nullptr;
    const auto fails = [](Thing& half) {
        half.number = 7;
        return Status::outOfDeviceMemory;
    };
    EXPECT_EQ(things.get(1, fails, thing), Status::outOfDeviceMemory);
    EXPECT_EQ(thing, nullptr);
    int count = 0;
    things.forEach([&](const Thing&) { ++count; });
    EXPECT_EQ(count, 0);
    const auto works = [](Thing& fresh) {
        EXPECT_EQ(fresh.number, 0);
        return Status::ok;
    };
    EXPECT_EQ(things.get(1, works, thing), Status::ok);
    EXPECT_NE(thing, nullptr);
}

} // namespace
