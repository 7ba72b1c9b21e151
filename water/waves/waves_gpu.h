// Waves by compute shaders: spectrum and columns in one dispatch, rows and maps in another. Where the device
// is a CPU, whose stores to images cost several times those to buffers, maps are copied from a buffer.
// Everything stays within what Vulkan guarantees of any device: 128 invocations a group, 16 KiB they share.
#pragma once

#include <array>
#include <memory>

#include "gpu/memory/buffer.h"
#include "gpu/pipeline/kernel_cache.h"
#include "seaglass/sea.h"
#include "water/waves/wave_maps.h"

namespace seaglass {

struct WavePair {
    gpu::Kernel columns;
    gpu::Kernel rows;
};
/// Of a sea of `samples` across.
Status buildWaves(const gpu::Device& device, const uint32_t& samples, WavePair& out);
using WaveKernels = gpu::KernelCache<uint32_t, WavePair, buildWaves>;

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
    Status describe(Context& context, const WaveMaps& maps, const WavePair& kernels, uint32_t cascades,
                    double time, Sets& out) const;
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
