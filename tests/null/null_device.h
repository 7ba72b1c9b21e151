// A device of AMD's that is none: Mesa's driver compiles for it, by the compiler that players have, creates
// no images and runs nothing. Without a GPU it tells what shaders cost on one.
#pragma once

#include <memory>
#include <string>

#include <volk.h>

namespace tests {

class NullDevice {
  public:
    /// In an instance of its own, beside any other. Null with `whyNot` set, a line, where Mesa's driver for
    /// AMD is not installed or makes no such device. Sets environment variables meanwhile: no other thread
    /// may read them.
    static std::unique_ptr<NullDevice> create(std::string& whyNot);
    ~NullDevice();
    NullDevice(const NullDevice&) = delete;
    NullDevice& operator=(const NullDevice&) = delete;

    VkDevice handle() const { return device_; }
    const VolkDeviceTable& vk() const { return table_; }
    /// As its driver names it, with the driver's version.
    const std::string& name() const { return name_; }
    VkPhysicalDeviceType type() const { return type_; }

  private:
    NullDevice() = default;
    bool createInstance(std::string& whyNot);
    bool createDevice(std::string& whyNot);
    /// Of the instance.
    template<typename Function>
    Function load(const char* name) const {
        return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance_, name));
    }

    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VolkDeviceTable table_{};
    std::string name_;
    VkPhysicalDeviceType type_ = VK_PHYSICAL_DEVICE_TYPE_OTHER;
};

} // namespace tests
