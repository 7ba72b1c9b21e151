// A body's waves: the maps of its sea, and who fills them.
#pragma once

#include <variant>

#include "seaglass/sea.h"
#include "water/wave_maps.h"
#include "water/waves_gpu.h"
#include "water/waves_upload.h"

namespace seaglass {

class Waves {
  public:
    /// `sea` is not flat and outlives the waves. By compute shaders without a backend.
    Status create(Context& context, const Sea& sea, const WavesBackend* backend);
    /// Sets the maps to the sea at `time`, for shaders to sample.
    Status record(Context& context, VkCommandBuffer commands, double time);

    /// Of a sea that is not flat, whatever fills the maps included.
    static VkDeviceSize bytes(const Context& context, const Sea& sea, const WavesBackend* backend);
    const WaveMaps& maps() const { return maps_; }
    /// Who fills the maps: one of the two, the other is null.
    ComputedWaves* computed() { return std::get_if<ComputedWaves>(&source_); }
    const UploadedWaves* uploaded() const { return std::get_if<UploadedWaves>(&source_); }

  private:
    WaveMaps maps_;
    std::variant<ComputedWaves, UploadedWaves> source_;
};

} // namespace seaglass
