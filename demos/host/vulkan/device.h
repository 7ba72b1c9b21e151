// Instance, device and the one queue the host submits to.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "host/host_desc.h"
#include "host/timing/pass_timer.h"
#include "host/vulkan/vk_handle.h"

namespace seaglass {
struct Requirements;
}

namespace demos {

/// What a device is made with, of what hosts differ in.
struct DeviceShape {
    bool onlyRequired = false; ///< the features that Seaglass asks for, and none of the host's own
    bool multiview = false;
    uint32_t familiesPassedOver = 0; ///< of the queue families that draw and compute
};

class Device {
  public:
    static std::unique_ptr<Device> create(const HostDesc& desc, Error& error, const DeviceShape& shape = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physical() const { return physical_; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    uint32_t queueFamily() const { return queueFamily_; }
    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    const DeviceInfo& info() const { return info_; }
    bool anisotropy() const { return anisotropy_; }
    PassClock clock() const { return clock_; }
    /// Whether compute passes alone in their submission are timed by timestamps.
    bool timesComputePasses() const { return hasTimestamps_ && clock_ != PassClock::processor; }
    /// Hears the passes of what run() records.
    PassTimer& passes() { return passes_; }
    /// Whether the device was found lost, or the end of its work was not seen.
    bool lost() const { return lost_; }
    uint32_t validationMessages() const { return validationMessages_; }

    /// The index of a memory type with all of `required`, preferring one with `preferred` too; UINT32_MAX
    /// when none.
    uint32_t memoryType(uint32_t allowed, VkMemoryPropertyFlags required,
                        VkMemoryPropertyFlags preferred) const;
    VkDeviceSize heapSize(uint32_t memoryType) const;
    VkDeviceSize largestHeap() const;
    VkDeviceSize maxAllocation() const { return maxAllocation_; }

    /// Records with `record`, submits and waits. False with `error` set when recording or the device fails;
    /// where it is lost or hangs, `error` names the pass.
    bool run(const std::function<bool(VkCommandBuffer, Error&)>& record, Error& error);
    /// Waits for the end of what signals `fence`, and resets that. False as run().
    bool waitFor(VkFence fence, Error& error);
    /// How long waitFor() waits; longer is taken for never.
    uint64_t patienceNs() const;
    /// True on VK_SUCCESS; otherwise `error` says what failed, or in which pass the device was lost or hangs.
    bool checked(VkResult result, const char* what, Error& error);
    /// Milliseconds from submission to fence of the last run(), by clock() where that is of the processors.
    double lastRunMs() const { return lastRunMs_; }

  private:
    Device() = default;
    bool createInstance(const HostDesc& desc, Error& error);
    bool choosePhysical(const std::string& wanted, Error& error);
    bool createDevice(const HostDesc& desc, const DeviceShape& shape, Error& error);
    bool makeDevice(const seaglass::Requirements& needs, bool forWindows, Error& error);
    bool createCommands(Error& error);
    bool createTimer(PassClock wanted, uint32_t timestampBits, Error& error);
    bool submit(Error& error);
    std::string whereItStopped() const;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    VkDeviceSize maxAllocation_ = 0;
    DeviceInfo info_;
    bool anisotropy_ = false;
    PassClock clock_ = PassClock::fence;
    bool hasTimestamps_ = false;
    bool lost_ = false;
    double lastRunMs_ = 0;
    std::atomic<uint32_t> validationMessages_ = 0;
    PassTimer passes_;
    std::string seenIn_; ///< the pass in which waitFor() saw it last, if in any
    UniqueCommandPool pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    UniqueFence fence_;
};

/// True on VK_SUCCESS; otherwise `error` says what failed and with which result.
bool succeeded(VkResult result, const char* what, Error& error);

} // namespace demos
