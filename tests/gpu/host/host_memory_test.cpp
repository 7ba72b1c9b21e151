// Hosts that hand in their own allocator, device memory and pipeline cache: they are asked, get all of it
// back, and see the same picture.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>

#include "tests/gpu/host/host_shape.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class HostMemory : public testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().validationMessages(); }
    void TearDown() override { EXPECT_EQ(device().validationMessages(), messagesBefore_); }

    static const Picture& plainPicture() {
        static const Picture picture = ShapedHost(device()).picture(shoreCamera());
        return picture;
    }

  private:
    uint32_t messagesBefore_ = 0;
};

/// Counts what Vulkan asks of it. Drivers may ask from threads of their own.
struct CountingAllocator {
    std::mutex mutex;
    std::map<void*, size_t> held; ///< and how large
    size_t handedOut = 0;
    size_t unknown = 0; ///< given back, but none of ours

    static void* VKAPI_PTR allocate(void* user, size_t size, size_t alignment, VkSystemAllocationScope) {
        auto& self = *static_cast<CountingAllocator*>(user);
        const std::lock_guard lock(self.mutex);
        void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        self.held[memory] = size;
        ++self.handedOut;
        return memory;
    }
    static void* VKAPI_PTR reallocate(void* user, void* old, size_t size, size_t alignment,
                                      VkSystemAllocationScope scope) {
        if (size == 0) {
            release(user, old);
            return nullptr;
        }
        void* fresh = allocate(user, size, alignment, scope);
        if (old) std::memcpy(fresh, old, std::min(size, static_cast<CountingAllocator*>(user)->sizeOf(old)));
        release(user, old);
        return fresh;
    }
    static void VKAPI_PTR release(void* user, void* memory) {
        if (!memory) return;
        auto& self = *static_cast<CountingAllocator*>(user);
        const std::lock_guard lock(self.mutex);
        self.unknown += self.held.erase(memory) == 0;
        std::free(memory);
    }
    size_t sizeOf(void* memory) {
        const std::lock_guard lock(mutex);
        return held[memory];
    }
    VkAllocationCallbacks callbacks() { return {this, allocate, reallocate, release, nullptr, nullptr}; }
};

TEST_F(HostMemory, AllocatorsServeAllThatIsMadeAndGetItBack) {
    CountingAllocator allocator;
    {
        const VkAllocationCallbacks callbacks = allocator.callbacks();
        ShapedHost host(device(), {}, true, [&](DeviceDesc& desc) { desc.allocator = &callbacks; });
        EXPECT_EQ(host.picture(shoreCamera()), plainPicture());
        EXPECT_GT(allocator.handedOut, 50u);
        EXPECT_GT(allocator.held.size(), 50u);
    }
    EXPECT_EQ(allocator.held.size(), 0u);
    EXPECT_EQ(allocator.unknown, 0u);
}

/// Pieces of a few large blocks, one after another, images and buffers apart: much as engines do it.
class Arena {
  public:
    ~Arena() {
        for (const auto& [key, block] : blocks_) vkFreeMemory(device().handle(), block.memory, nullptr);
    }
    MemoryCallbacks callbacks() { return {allocate, release, this}; }

    size_t held = 0, handedOut = 0, unknown = 0;
    VkDeviceSize bytes = 0;
    size_t failAfter = ~size_t{0};

  private:
    static constexpr VkDeviceSize blockBytes = 64 << 20;
    struct Block {
        VkDeviceMemory memory = VK_NULL_HANDLE;
        char* mapped = nullptr;
        VkDeviceSize used = 256; ///< the first piece does not begin at 0 either
    };

    static VkResult allocate(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags wanted,
                             bool image, MemoryPiece* out) {
        auto& self = *static_cast<Arena*>(user);
        if (self.handedOut == self.failAfter) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        const uint32_t type = device().memoryType(needs->memoryTypeBits, wanted, 0);
        Block& block = self.blocks_[{type, image}];
        const bool visible = wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
        if (!block.memory) {
            VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
            info.allocationSize = blockBytes;
            info.memoryTypeIndex = type;
            if (const VkResult r = vkAllocateMemory(device().handle(), &info, nullptr, &block.memory); r)
                return r;
        }
        if (visible && !block.mapped) {
            void* mapped = nullptr;
            if (const VkResult r = vkMapMemory(device().handle(), block.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
                r)
                return r;
            block.mapped = static_cast<char*>(mapped);
        }
        const VkDeviceSize offset = (block.used + needs->alignment - 1) / needs->alignment * needs->alignment;
        if (offset + needs->size > blockBytes) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        block.used = offset + needs->size;
        self.bytes += needs->size;
        ++self.held;
        *out = {block.memory, offset, visible ? block.mapped + offset : nullptr,
                reinterpret_cast<void*>(++self.handedOut)};
        self.pieces_.insert(out->own);
        return VK_SUCCESS;
    }
    static void release(void* user, const MemoryPiece* piece) {
        auto& self = *static_cast<Arena*>(user);
        --self.held;
        self.unknown += self.pieces_.erase(piece->own) == 0;
    }

    std::map<std::pair<uint32_t, bool>, Block> blocks_;
    std::set<void*> pieces_;
};

TEST_F(HostMemory, CallbacksServeAllDeviceMemoryAndGetItBack) {
    Arena arena;
    const Picture& plain = plainPicture();
    {
        ShapedHost host(device(), {}, true, [&](DeviceDesc& desc) { desc.memory = arena.callbacks(); });
        spiedCalls().clear();
        EXPECT_EQ(host.picture(shoreCamera()), plain);
        EXPECT_EQ(countSpied("AllocateMemory"), 0u);
        EXPECT_GT(arena.held, 8u);
        Camera small = shoreCamera();
        small.width = 64;
        const Picture once = host.picture(small, 5, 1);
        EXPECT_EQ(once, ShapedHost(device()).picture(small));
    }
    EXPECT_EQ(arena.held, 0u);
    EXPECT_EQ(arena.unknown, 0u);
}

TEST_F(HostMemory, WhatCallbacksFailWithIsReportedAndNothingIsKept) {
    std::string text;
    Arena arena;
    DeviceDesc desc = deviceDesc(&text);
    desc.memory = arena.callbacks();
    Context* context = nullptr;
    ASSERT_EQ(createContext(&desc, &context), Status::ok) << text;
    SeaDesc sea;
    sea.samples = 64;
    BodyDesc bodyDesc;
    bodyDesc.waves = &sea;
    Body* body = nullptr;
    for (arena.failAfter = 0;; ++arena.failAfter) {
        arena.handedOut = 0;
        text.clear();
        const Status status = createBody(context, &bodyDesc, &body);
        if (status == Status::ok) break;
        EXPECT_EQ(status, Status::outOfDeviceMemory);
        EXPECT_NE(text.find("out of device memory"), std::string::npos) << text;
        EXPECT_EQ(body, nullptr);
        EXPECT_EQ(arena.held, 0u);
    }
    EXPECT_GT(arena.failAfter, 3u);
    destroyBody(body);
    destroyContext(context);
    EXPECT_EQ(arena.held, 0u);
}

TEST_F(HostMemory, CallbacksThatGiveNothingAreNamed) {
    std::string text;
    DeviceDesc desc = deviceDesc(&text);
    Context* context = nullptr;
    desc.memory.release = [](void*, const MemoryPiece*) {};
    EXPECT_EQ(createContext(&desc, &context), Status::invalidArgument);
    EXPECT_NE(text.find("DeviceDesc.memory"), std::string::npos) << text;
    desc.memory.allocate = [](void*, const VkMemoryRequirements*, VkMemoryPropertyFlags, bool, MemoryPiece*) {
        return VK_SUCCESS;
    };
    ASSERT_EQ(createContext(&desc, &context), Status::ok) << text;
    Body* body = nullptr;
    const BodyDesc bodyDesc;
    EXPECT_EQ(createBody(context, &bodyDesc, &body), Status::invalidArgument);
    EXPECT_NE(text.find("MemoryCallbacks.allocate"), std::string::npos) << text;
    destroyContext(context);
}

TEST_F(HostMemory, PipelinesComeFromTheHostsCache) {
    const VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    VkPipelineCache cache = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreatePipelineCache(device().handle(), &info, nullptr, &cache), VK_SUCCESS);
    const Picture& plain = plainPicture();
    for (int run = 0; run < 2; ++run) {
        spiedCalls().clear();
        ShapedHost host(device(), {}, true, [&](DeviceDesc& desc) { desc.pipelineCache = cache; });
        EXPECT_EQ(host.picture(shoreCamera()), plain) << run;
        size_t made = 0;
        for (const SpiedCall& call : spiedCalls())
            if (call.name == "CreateGraphicsPipelines" || call.name == "CreateComputePipelines") {
                ++made;
                EXPECT_EQ(call.cache, cache) << call.name;
            }
        EXPECT_GT(made, 5u);
    }
    vkDestroyPipelineCache(device().handle(), cache, nullptr);
}

} // namespace
