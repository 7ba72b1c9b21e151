// Waves by a backend on the CPU, uploaded each frame.
#pragma once

#include <array>
#include <memory>

#include "seaglass/sea.h"
#include "water/waves/wave_maps.h"

namespace seaglass {

struct BackendStateDeleter {
    void (*destroy)(void*) = nullptr;
    void operator()(void* state) const { destroy(state); }
};

class UploadedWaves {
  public:
    static constexpr VkImageUsageFlags mapUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;

    /// `sea` is not flat and outlives the waves.
    Status create(Context& context, const Sea& sea, const WavesBackend& backend);
    /// Evaluates the sea at `time` on the calling thread and records its upload.
    Status record(Context& context, VkCommandBuffer commands, const WaveMaps& maps, double time);

    const WavesBackend& backend() const { return *backend_; }
    void* state() const { return state_.get(); }

    static VkDeviceSize bytes(const Context& context, const Sea& sea);

  private:
    const WavesBackend* backend_ = nullptr;
    std::unique_ptr<void, BackendStateDeleter> state_;
    std::array<gpu::Buffer, 4> staging_; ///< one a frame slot: map after map, cascade after cascade
};

} // namespace seaglass
