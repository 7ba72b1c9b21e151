// The images that a window shows.
#pragma once

#include "host/vulkan/resources.h"

struct GLFWwindow;

namespace demos {

/// One frame at a time, waited for on the CPU: simple, and enough for looking at scenes.
class Swapchain {
  public:
    Swapchain() = default;
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// False with `error` set where the device cannot draw into the window.
    bool create(Device& device, GLFWwindow* window, Error& error);
    /// Images anew, as large as the window is now or, where it leaves that open, as `wanted`.
    bool resize(VkExtent2D wanted, Error& error);
    VkExtent2D extent() const { return extent_; }

    enum class Acquired {
        image, ///< to fill
        none,  ///< within the time: the display may show nothing of the window
        stale  ///< the window has changed
    };
    bool acquire(uint64_t waitNs, Acquired& acquired, Error& error);
    /// Copies a picture, which is a transfer's source, into the image.
    void record(VkCommandBuffer commands, const Image& picture) const;
    /// Shows the image once what fills it is done.
    bool present(bool& stale, Error& error);

  private:
    bool chooseFormat(Error& error);

    Device* device_ = nullptr;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkExtent2D extent_ = {0, 0};
    UniqueSwapchain swapchain_;
    UniqueFence acquired_;
    std::vector<VkImage> images_;
    uint32_t image_ = 0;
};

} // namespace demos
