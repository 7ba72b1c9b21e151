// Waves by compute shaders: spectrum and columns in one dispatch, rows and maps in another. Where the device
// is a CPU, whose stores to images cost several times those to buffers, maps are copied from a buffer.
// Everything stays within what Vulkan guarantees of any device: 128 invocations a group, 16 KiB they share.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/kernel.h"
#include "seaglass/sea.h"
#include "water/waves/wave_maps.h"

namespace seaglass {

/// Of all bodies of a context, by samples across.
class WaveKernels {
  public:
    Status create(Context&) { return Status::ok; }

    struct Pair {
        gpu::Kernel columns;
        gpu::Kernel rows;
    };
    /// Builds on first use.
    Status get(const gpu::Device& device, uint32_t samples, const Pair*& out);

  private:
    static Status createPair(const gpu::Device& device, uint32_t samples, Pair& out);

    std::map<uint32_t, Pair> kernels_;
};

class ComputedWaves {
  public:
    static VkImageUsageFlags mapUsage(const gpu::Device& device);

    /// `sea` is not flat and outlives the waves.
    Status create(Context& context, const Sea& sea);
    Status record(Context& context, VkCommandBuffer commands, const WaveMaps& maps, double time);
    /// Mip 0 of the first `cascades` alone.
    Status recordFirst(Context& context, VkCommandBuffer commands, const WaveMaps& maps, uint32_t cascades,
                       double time);

    static VkDeviceSize bytes(const gpu::Device& device, const Sea& sea);

  private:
    struct Sets {
        VkDescriptorSet columns = VK_NULL_HANDLE;
        VkDescriptorSet rows = VK_NULL_HANDLE;
    };
    Status recordMaps(Context& context, VkCommandBuffer commands, const WaveMaps& maps, uint32_t cascades,
                      double time);
    Status describe(Context& context, const WaveMaps& maps, const WaveKernels::Pair& kernels,
                    uint32_t cascades, double time, Sets& out) const;
    void recordUpload(Context& context, VkCommandBuffer commands);

    const Sea* sea_ = nullptr;
    std::shared_ptr<WaveKernels> kernels_;
    gpu::Buffer modes_;   ///< amplitudes, then frequencies
    gpu::Buffer staging_; ///< of the modes, until they are recorded
    gpu::Buffer columns_; ///< transforms along the columns
    gpu::Buffer copied_;  ///< mip 0 of the maps, where they are copied
    std::array<float, maxCascades> packing_{};
    bool uploaded_ = false;
};

} // namespace seaglass
