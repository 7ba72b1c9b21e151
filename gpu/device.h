// The host's device as Seaglass uses it: entry points, memory types, limits and where errors go.
#pragma once

#include <cstdarg>

#include "gpu/debug_names.h"
#include "gpu/dispatch.h"
#include "seaglass/host.h"

namespace seaglass::gpu {

class Device {
  public:
    /// `desc` has been checked for null handles.
    Status init(const DeviceDesc& desc);

    VkDevice handle() const { return device_; }
    const DeviceTable& vk() const { return table_; }
    const VkAllocationCallbacks* allocator() const { return hasAllocator_ ? &allocator_ : nullptr; }
    VkPipelineCache pipelineCache() const { return pipelineCache_; }
    const VkPhysicalDeviceLimits& limits() const { return limits_; }
    /// Some things are done another way there: shaders store to images slowly, and clears, copies and blits
    /// are fast.
    bool isCpu() const { return isCpu_; }

    VkFormatFeatureFlags optimalFeatures(VkFormat format) const;

    /// Memory with all `wanted` properties for one buffer or image, mapped if it is host-visible.
    Status allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, bool image,
                    const char* what, MemoryPiece& out) const;
    void free(MemoryPiece& piece) const;

    /// Sends one line to the host and gives `status` back, so that a failing call reads `return
    /// device.fail(...)`.
    [[gnu::format(printf, 3, 4)]] Status fail(Status status, const char* format, ...) const;
    /// Sends one line of what is as the host asks, but hardly as it means.
    [[gnu::format(printf, 2, 3)]] void warn(const char* format, ...) const;
    /// As fail() with invalidArgument, of a call that breaks a rule of docs/contract.md in when or of what it
    /// is made. Debug builds end there.
    [[gnu::format(printf, 2, 3)]] Status misused(const char* format, ...) const;
    /// VK_SUCCESS is ok; anything else is reported as the failure of `what`.
    Status check(VkResult result, const char* what) const;
    /// As check() of what made `handle`, which debuggers then know as `what`. What a failed call left there
    /// is undefined (Vulkan 1.3, Return Codes): it becomes null.
    template<typename Handle>
    Status made(VkResult result, VkObjectType type, Handle& handle, const char* what) const {
        const Status s = check(result, what);
        if (s == Status::ok)
            names_.name(device_, type, handle, what);
        else
            handle = VK_NULL_HANDLE;
        return s;
    }

    void passBegins(VkCommandBuffer commands, const char* pass) const;
    void passEnds(VkCommandBuffer commands, const char* pass) const;

  private:
    [[gnu::format(printf, 2, 0)]] void say(const char* format, va_list arguments) const;
    /// A memory type out of `allowedBits` with all `wanted` properties, or ~0u.
    uint32_t memoryType(uint32_t allowedBits, VkMemoryPropertyFlags wanted) const;

    Status allocateOwn(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, const char* what,
                       MemoryPiece& out) const;
    Status allocateHosts(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, bool image,
                         const char* what, MemoryPiece& out) const;

    VkDevice device_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    InstanceTable instanceTable_;
    DeviceTable table_;
    VkAllocationCallbacks allocator_{};
    bool hasAllocator_ = false;
    VkPipelineCache pipelineCache_ = VK_NULL_HANDLE;
    VkPhysicalDeviceLimits limits_{};
    bool isCpu_ = false;
    VkPhysicalDeviceMemoryProperties memory_{};
    MemoryCallbacks memoryCallbacks_;
    MessageCallback message_;
    PassCallback pass_;
    DebugNames names_;
};

/// Brackets the commands of one pass for the host's PassCallback and for debuggers.
class PassScope {
  public:
    PassScope(const Device& device, VkCommandBuffer commands, const char* pass)
        : device_(device), commands_(commands), pass_(pass) {
        device_.passBegins(commands_, pass_);
    }
    ~PassScope() { device_.passEnds(commands_, pass_); }
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

  private:
    const Device& device_;
    VkCommandBuffer commands_;
    const char* pass_;
};

} // namespace seaglass::gpu
