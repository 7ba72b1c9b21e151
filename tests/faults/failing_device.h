// A Vulkan device that does nothing, on which any call can be made to fail as drivers fail: with an error,
// and with garbage in what the call should have filled. It knows every handle that it gave, and counts what
// comes back wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <type_traits>
#include <vector>

#include "seaglass/host.h"
#include "tests/unit/sea/starved.h"

namespace tests {

/// What a call fails with.
enum class Fault { hostMemory, deviceMemory, deviceLost, another /*that the call may give*/ };
constexpr Fault everyFault[] = {Fault::hostMemory, Fault::deviceMemory, Fault::deviceLost, Fault::another};
const char* toString(Fault fault);
/// As a call of the library has to say it.
seaglass::Status statusOf(Fault fault);

/// Any thread.
class FailingDevice {
  public:
    explicit FailingDevice(VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU) : type_(type) {}
    FailingDevice(const FailingDevice&) = delete;
    FailingDevice& operator=(const FailingDevice&) = delete;

    /// Its handles and its loader.
    seaglass::DeviceDesc desc();
    VkCommandBuffer commands() { return reinterpret_cast<VkCommandBuffer>(this); }
    /// An image, or a view of one, that the library must not destroy.
    template<typename Handle>
    Handle hosts() {
        return toHandle<Handle>(add("the host's", nullptr, 0));
    }

    /// Of the calls from here on that can fail, number `call` does, from 0; if `sticky`, those after it, too.
    void failAt(uint64_t call, Fault fault, bool sticky);
    void heal() { failAt(~uint64_t{0}, Fault::another, false); }
    /// Since failAt(): the calls that could have failed, and the function that did first; empty: none.
    const std::vector<const char*>& calls() const { return calls_; }
    const std::string& failed() const { return failed_; }

    /// What is not destroyed yet, without what is the host's.
    size_t held() const;
    /// The same without pipelines and their layouts, which a context keeps.
    size_t heldButPipelines() const;
    size_t heldBytes() const { return heldBytes_; }
    /// Handles that were destroyed, or used, and that no call gave or that were destroyed before; and uses of
    /// parts of buffers that Vulkan forbids.
    size_t garbageDestroyed() const { return garbageDestroyed_; }
    size_t garbageUsed() const { return garbageUsed_; }
    /// Objects that were destroyed with other callbacks than they were made with.
    size_t wrongAllocators() const { return wrongAllocators_; }
    /// The last of those three, as a line.
    const std::string& complaint() const { return complaint_; }

  private:
    struct Calls; ///< the entry points
    /// While it lives, the device has the memory that the library lacks.
    struct Lock {
        explicit Lock(const FailingDevice& device) : locked(device.mutex_) {}
        tests::Fed fed;
        std::lock_guard<std::mutex> locked;
    };
    struct Object {
        const char* kind = nullptr;
        uint64_t owner = 0;          ///< the pool of a descriptor set
        uint32_t sets = 0, room = 0; ///< of a pool: that it may hold, and that it has room for
        VkAllocationCallbacks allocator{};
        void* own = nullptr; ///< of `allocator`
        size_t bytes = 0;
        std::vector<std::byte> mapped;
    };

    template<typename Handle>
    static Handle toHandle(uint64_t bits) {
        if constexpr (std::is_pointer_v<Handle>)
            return reinterpret_cast<Handle>(static_cast<uintptr_t>(bits));
        else
            return bits;
    }
    template<typename Handle>
    static uint64_t bitsOf(Handle handle) {
        if constexpr (std::is_pointer_v<Handle>)
            return reinterpret_cast<uintptr_t>(handle);
        else
            return handle;
    }

    /// VK_SUCCESS, or what this call fails with.
    VkResult next(const char* function, VkResult another);
    uint64_t garbage() { return 0xbad00000u + 16 * ++garbageGiven_; }
    uint64_t add(const char* kind, const VkAllocationCallbacks* allocator, uint64_t owner);
    VkResult make(const char* function, VkResult another, const char* kind,
                  const VkAllocationCallbacks* allocator, uint64_t& bits, uint64_t owner = 0);
    void remove(const char* kind, uint64_t bits, const VkAllocationCallbacks* allocator);
    void removeOwned(uint64_t owner);
    void setBytes(uint64_t bits, size_t bytes);
    size_t bytes(uint64_t bits) const;
    void setRoom(uint64_t pool, uint32_t sets);
    /// False: the pool is full.
    bool takeRoom(uint64_t pool, uint32_t sets);
    void emptyPool(uint64_t pool);
    void use(const char* function, uint64_t bits);
    void usePart(const VkDescriptorBufferInfo& part);
    void complain(size_t& count, const char* what, const char* where);

    const VkPhysicalDeviceType type_;
    mutable std::mutex mutex_;
    std::map<uint64_t, Object> objects_;
    uint64_t given_ = 0, garbageGiven_ = 0;
    size_t heldBytes_ = 0;
    std::vector<const char*> calls_;
    uint64_t failAt_ = ~uint64_t{0};
    Fault fault_ = Fault::another;
    bool sticky_ = false;
    std::string failed_, complaint_;
    size_t garbageDestroyed_ = 0, garbageUsed_ = 0, wrongAllocators_ = 0;
};

} // namespace tests
