// The tiles of a view in which a surface was found, in lists by what their shading needs.
#pragma once

#include <array>
#include <compare>

#include "gpu/context.h"
#include "gpu/memory/buffer.h"
#include "gpu/pipeline/constants.h"
#include "gpu/pipeline/kernel_cache.h"
#include "shaders/shared/found_tiles_block.h"
#include "water/shading/found_surface.h"

namespace seaglass {

/// Which tiles are told apart, of a surface that has the feature at all.
struct TileSorting {
    bool hasReflection = false, hasRefraction = false;
    bool mirrors = false, bed = false; ///< by whether they need it
    uint32_t pixelsPerShading = 1;
    auto operator<=>(const TileSorting&) const = default;

    /// That some tile may be in it.
    bool uses(uint32_t list) const;
};
TileSorting tileSorting(const SurfaceVariant& variant);

struct TilesConstants {
#define CONSTANTS "shaders/shared/surface_tiles_constants.h"
#include "gpu/pipeline/constants.inl"
};

/// Of a view, of 8 x 8 blocks of so many pixels.
uint32_t tileCount(VkExtent2D view, uint32_t pixelsPerShading);

/// One for each step of the listing.
using TilesKernels = std::array<gpu::Kernel, 3>;
Status buildListing(const gpu::Device& device, const TileSorting& sorting, TilesKernels& out);
using SurfaceTilesKernels = gpu::KernelCache<TileSorting, TilesKernels, buildListing>;

/// Of one view, as large as what was found of it.
class SurfaceTiles {
  public:
    Status create(const gpu::Device& device, VkExtent2D extent);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent);
    VkBuffer handle() const { return buffer_.handle(); }
    /// Of the VkDispatchIndirectCommand of a list.
    static VkDeviceSize groupsOffset(uint32_t list);

    /// Leaves the lists to be read by compute shaders, and dispatched by.
    Status record(Context& context, VkCommandBuffer commands, const TilesKernels& kernels,
                  const Resources& resources, uint32_t tiles) const;

  private:
    gpu::Buffer buffer_; ///< shaders/shared/found_tiles_block.h
};

} // namespace seaglass
