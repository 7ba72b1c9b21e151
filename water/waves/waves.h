// A body's waves: the maps of its sea, and who fills them.
#pragma once

#include <variant>

#include "seaglass/sea.h"
#include "water/waves/wave_maps.h"
#include "water/waves/waves_gpu.h"
#include "water/waves/waves_upload.h"

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
    /// The same to be filled for another time than record() has left.
    const WaveMaps& mapsToFill();
    /// Keeps the displacement of the time before.
    Status keepLast(const gpu::Device& device);
    static VkDeviceSize lastBytes(const gpu::Device& device, const Sea& sea, const WavesBackend* backend);
    VkImageView lastDisplacement() const;
    /// Who fills the maps: one of the two, the other is null.
    ComputedWaves* computed() { return std::get_if<ComputedWaves>(&source_); }
    const UploadedWaves* uploaded() const { return std::get_if<UploadedWaves>(&source_); }

  private:
    WaveMaps maps_;
    gpu::OwnedImage last_;  ///< takes turns with the maps' own
    bool turned_ = false;   ///< it holds something
    bool recorded_ = false; ///< the maps hold the time of record()
    std::variant<ComputedWaves, UploadedWaves> source_;
};

} // namespace seaglass
