// Lists of tiles hold no more than there are, and nobody reads beyond them, whatever their header held.
#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <span>

#include "gpu/context.h"
#include "gpu/pipeline/kernel.h"
#include "reflection/sspr/tiles.h"
#include "spirv/tile_lists.comp.h"
#include "spirv/tile_lists_columns.comp.h"
#include "spirv/tile_lists_keys.comp.h"
#include "spirv/tile_lists_tiles.comp.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

// Of shaders/tile_lists.comp.
constexpr uint32_t width = 80, height = 44, across = 10, down = 6, count = across * down;
constexpr uint32_t guards = 64, untouched = 0xabcdef01;

/// As shaders/reflection/sspr/tiles.glsl lays it out, and something behind it.
struct Tiles {
    TileHeader header{};
    std::array<uint32_t, count> flags{};
    std::array<uint32_t, count> lists{};
    std::array<uint32_t, guards> behind{};
};

class TileLists : public GpuTest {
  protected:
    /// What is left of `tiles`, and of what was visited.
    Tiles after(std::span<const uint32_t> shader, const Tiles& tiles, uint32_t groups) {
        constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        const gpu::Device& device = context()->device;
        gpu::Kernel kernel;
        gpu::Buffer buffer, visits;
        EXPECT_EQ(kernel.create(device, shader, "tile lists"), Status::ok) << message();
        EXPECT_EQ(buffer.createMapped(device, sizeof tiles, usage, "tiles"), Status::ok) << message();
        EXPECT_EQ(visits.createMapped(device, sizeof visited_, usage, "visits"), Status::ok) << message();
        std::memcpy(buffer.mapped(), &tiles, sizeof tiles);
        std::memset(visits.mapped(), 0, sizeof visited_);
        frame([&](VkCommandBuffer commands) {
            const gpu::Bound resources[] = {
                {0, gpu::storageBuffer(buffer.handle())},
                {1, gpu::storageBuffer(visits.handle())},
            };
            VkDescriptorSet set = VK_NULL_HANDLE;
            EXPECT_EQ(context()->frame().allocateSet(kernel.layout(), resources, set), Status::ok);
            kernel.dispatch(commands, set, groups, 1);
            gpu::recordBarrier(device, commands,
                               {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                               {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
        });
        Tiles left;
        std::memcpy(&left, buffer.mapped(), sizeof left);
        std::memcpy(&visited_, visits.mapped(), sizeof visited_);
        return left;
    }

    void expectAllVisitedOnce() {
        EXPECT_TRUE(std::all_of(visited_.begin(), visited_.end() - 1, [](uint32_t n) { return n == 1; }));
        EXPECT_EQ(visitedBeside(), 0u);
    }

    uint32_t visitedBeside() const { return visited_.back(); }

  private:
    std::array<uint32_t, width * height + 1> visited_{};
};

Tiles listed() {
    Tiles tiles;
    for (uint32_t i = 0; i < count; ++i) tiles.lists[i] = i % across | i / across << 16;
    tiles.header.resolveGroups.w = tiles.header.columnGroups.w = ~0u;
    return tiles; // a reader that goes on beyond meets the first tile again
}

TEST_F(TileLists, EndWhereTheyMeet) {
    Tiles tiles;
    tiles.flags.fill(untouched);
    tiles.behind.fill(untouched);
    for (const uint32_t held : {0u, 7u, count - 1, count, ~0u - 200}) {
        tiles.header.resolveGroups.w = tiles.header.columnGroups.w = held;
        const Tiles left = after(tile_lists_comp, tiles, 1); // 64 invocations, more than there are tiles
        EXPECT_EQ(left.flags, tiles.flags) << held;
        EXPECT_EQ(left.behind, tiles.behind) << held;
        const uint32_t most = held < count ? count : 0;
        EXPECT_EQ(left.header.resolveGroups.x, most) << held;
        EXPECT_EQ(left.header.columnGroups.x, (most + 7) / 8) << held;
        EXPECT_LE(left.header.resolveGroups.y, 1u) << held;
        EXPECT_LE(left.header.columnGroups.y, 1u) << held;
    }
}

// Of tiles without keys those beside one that has some are resolved with it, on all of its sides.
TEST_F(TileLists, HoldTheTilesAroundKeys) {
    for (const uint32_t keys : {0u, across - 1, 2 * across + 4, 3 * across, count - 1}) {
        Tiles tiles;
        tiles.flags[keys] = tileHasKeys;
        const Tiles left = after(tile_lists_keys_comp, tiles, 1);
        std::set<uint32_t> expected;
        for (uint32_t tile = 0; tile < count; ++tile) {
            const auto apart = [&](uint32_t a, uint32_t b) { return a > b ? a - b : b - a; };
            if (apart(tile % across, keys % across) <= 1 && apart(tile / across, keys / across) <= 1)
                expected.insert(tile % across | tile / across << 16);
        }
        const uint32_t* const first = left.lists.data();
        EXPECT_EQ(std::set<uint32_t>(first, first + left.header.resolveGroups.w), expected) << keys;
    }
}

TEST_F(TileLists, AreReadToTheirEnds) {
    after(tile_lists_tiles_comp, listed(), count + guards);
    expectAllVisitedOnce();
    after(tile_lists_columns_comp, listed(), count / 8 + guards / 8 + 1);
    expectAllVisitedOnce();
}

TEST_F(TileLists, TilesBesideThePictureAreNotVisited) {
    Tiles tiles = listed();
    const std::array beside = {0xffffffffu, 0x00ff0000u, 0x000000ffu, down << 16, across};
    for (const uint32_t tile : beside) {
        tiles.lists.front() = tile;
        for (const std::span<const uint32_t> shader : {std::span<const uint32_t>(tile_lists_tiles_comp),
                                                       std::span<const uint32_t>(tile_lists_columns_comp)}) {
            after(shader, tiles, count);
            EXPECT_EQ(visitedBeside(), 0u) << std::hex << tile;
        }
    }
}

} // namespace
