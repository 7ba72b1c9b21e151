// The few samplers that all passes share.
#pragma once

#include "gpu/device.h"

namespace seaglass::gpu {

class Samplers {
  public:
    Samplers() = default;
    ~Samplers();
    Samplers(const Samplers&) = delete;
    Samplers& operator=(const Samplers&) = delete;

    Status create(const Device& device);

    VkSampler nearestClamp() const { return nearestClamp_; }
    VkSampler trilinearClamp() const { return trilinearClamp_; }
    VkSampler trilinearRepeat() const { return trilinearRepeat_; }

  private:
    const Device* device_ = nullptr;
    VkSampler nearestClamp_ = VK_NULL_HANDLE;
    VkSampler trilinearClamp_ = VK_NULL_HANDLE;
    VkSampler trilinearRepeat_ = VK_NULL_HANDLE;
};

} // namespace seaglass::gpu
