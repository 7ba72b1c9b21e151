// Foam kept on the CPU beside waves that are computed there, uploaded at each of its steps.
#pragma once

#include <array>
#include <optional>

#include "water/foam/foam_history.h"
#include "water/foam/foam_image.h"
#include "water/waves/waves_upload.h"

namespace seaglass {

class UploadedFoam {
  public:
    static constexpr VkImageUsageFlags imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;

    /// `sea` breaks, and outlives the foam.
    Status create(Context& context, const Sea& sea, const FoamDesc& foam);
    /// Sets the image to `step` and the one after it.
    Status record(Context& context, VkCommandBuffer commands, const UploadedWaves& waves,
                  const FoamImage& foam, int64_t step);

    static VkDeviceSize bytes(const Context& context, uint32_t samples, uint32_t cascades);

  private:
    void write(void* staging) const;

    std::optional<FoamHistory> history_;
    std::array<gpu::Buffer, 4> staging_; ///< one a frame slot
};

} // namespace seaglass
