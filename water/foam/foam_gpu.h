// Foam by a compute shader, beside waves that are computed so: each step fills the wave maps for its own time
// and steps the history in place.
#pragma once

#include <memory>
#include <optional>

#include "gpu/pipeline/kernel.h"
#include "shaders/shared/foam/foam_block.h"
#include "water/foam/foam_image.h"
#include "water/foam/foam_steps.h"
#include "water/waves/waves_gpu.h"

namespace seaglass {

struct FoamKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

class ComputedFoam {
  public:
    static constexpr VkImageUsageFlags imageUsage = VK_IMAGE_USAGE_STORAGE_BIT;

    /// `sea` outlives the foam.
    Status create(Context& context, const Sea& sea, const FoamDesc& foam);
    /// Sets the image to `step` and the one after it. Leaves the maps at some step's time.
    Status record(Context& context, VkCommandBuffer commands, ComputedWaves& waves, const WaveMaps& maps,
                  const FoamImage& foam, int64_t step);

  private:
    Status recordStep(Context& context, VkCommandBuffer commands, const WaveMaps& maps, const FoamImage& foam,
                      const FoamStep& step);
    FoamBand bandOf(uint32_t cascade, const FoamStep& step) const;

    std::shared_ptr<FoamKernel> kernel_;
    const Sea* sea_ = nullptr;
    Breaking breaking_;
    FoamFadings fading_;
    FoamKnown known_; ///< its newest step is the later that the image holds
};

} // namespace seaglass
