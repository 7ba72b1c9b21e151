// What shows of a surface in a view, shaded once a pixel: kernels over the tiles in which it was found.
#pragma once

#include <array>
#include <memory>

#include "gpu/context.h"
#include "gpu/memory/buffer.h"
#include "gpu/memory/image.h"
#include "gpu/pipeline/kernel_cache.h"
#include "water/shading/surface_tiles.h"

namespace seaglass {

/// What shading depends on.
SurfaceVariant shadingVariant(const SurfaceVariant& all);

/// One for each variant of the surface that shades alike.
Status buildShading(const gpu::Device& device, const SurfaceVariant& variant, gpu::Kernel& out);
using ShadingKernels = gpu::KernelCache<SurfaceVariant, gpu::Kernel, buildShading>;

/// What a kernel does: all of the shading; only what shines through the surface, or what it mirrors; or the
/// rest, where other kernels did these before. Each takes fewer registers and instructions than one that does
/// all, but finds the waves' slopes anew.
enum class ShadingStep : uint32_t { all = 0, bed, mirror, rest };
/// What one of these depends on.
SurfaceVariant stepVariant(const SurfaceVariant& all, ShadingStep step);

/// Of each list of tiles the kernel for it; null: there is none.
using ListedKernels = std::array<const gpu::Kernel*, foundLists>;
struct SteppedKernels {
    ListedKernels beds{}, mirrors{}, rest{};
};
bool isAny(const ListedKernels& of);
/// CPU devices pay for finding the slopes anew, and have no registers to gain.
bool takesSteps(const gpu::Device& device);
/// `apart`: by steps, else `rest` does all.
Status getListed(ShadingKernels& kernels, const SurfaceVariant& variant, const TileSorting& sorting,
                 bool apart, SteppedKernels& out);

/// What makes of one pixel of 2 or of 4 all of them: one for each.
Status buildCompleting(const gpu::Device& device, const uint32_t& pixelsPerShading, gpu::Kernel& out);
using CompletingKernels = gpu::KernelCache<uint32_t, gpu::Kernel, buildCompleting>;

/// What a surface is shaded by.
struct ShadedBy {
    const TilesKernels* listing = nullptr;
    SteppedKernels shading;
    const gpu::Kernel* completing = nullptr; ///< null: each pixel is shaded
    uint32_t pixelsPerShading = 1;
};

/// Of one view, as large as what was found of it.
struct ShadedSurface {
    gpu::OwnedImage color;    ///< linear: RGBA16F; of other outputs than `shaded` RGBA32F
    gpu::OwnedImage mirrored; ///< where that is a step and each pixel is shaded: light, and the share that
                              ///< enters the water. Of one pixel of several `color` has room for it.
    SurfaceTiles tiles;

    /// `mirrorsApart`: with `mirrored`.
    Status create(const gpu::Device& device, VkExtent2D extent, SurfaceOutput output, bool mirrorsApart);
    /// Of `shaded`.
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, bool mirrorsApart);
    /// Leaves the colour to be sampled where a surface was found. `resources`: all that shaders of the body
    /// read.
    Status record(Context& context, VkCommandBuffer commands, const ShadedBy& kernels,
                  const FoundSurface& found, Resources resources, VkExtent2D region) const;

  private:
    Status recordListed(Context& context, VkCommandBuffer commands, const ListedKernels& kernels,
                        const Resources& resources) const;
    Status recordShading(Context& context, VkCommandBuffer commands, const SteppedKernels& kernels,
                         const Resources& resources) const;
    Status recordCompleting(Context& context, VkCommandBuffer commands, const gpu::Kernel& kernel,
                            const Resources& resources, uint32_t tileCount) const;
};

} // namespace seaglass
