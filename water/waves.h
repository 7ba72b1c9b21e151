// A body's waves: the sea, the backend that evaluates it, and the maps it fills.
#pragma once

#include <array>
#include <memory>

#include "seaglass/sea.h"
#include "water/wave_maps.h"

namespace seaglass {

struct BackendStateDeleter {
    void (*destroy)(void*) = nullptr;
    void operator()(void* state) const { destroy(state); }
};

class Waves {
  public:
    /// `sea` is not flat and outlives the waves.
    Status create(Context& context, const Sea& sea, const WavesBackend& backend);
    /// Evaluates the sea at `time` on the calling thread and records its upload.
    Status record(Context& context, VkCommandBuffer commands, double time);

    /// Maps and staging of a sea that is not flat.
    static VkDeviceSize bytes(const Sea& sea, uint32_t framesInFlight);
    const WaveMaps& maps() const { return maps_; }

  private:
    const WavesBackend* backend_ = nullptr;
    std::unique_ptr<void, BackendStateDeleter> state_;
    WaveMaps maps_;
    std::array<gpu::Buffer, 4> staging_; ///< one a frame slot: map after map, cascade after cascade
};

} // namespace seaglass
