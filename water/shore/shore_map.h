// A shore as shaders see it: its places as an image, and its trains' rows.
#pragma once

#include "water/shore/shore.h"
#include "water/waves/fixed_image.h"

namespace seaglass {

class ShoreMap {
  public:
    Status create(Context& context, const Shore& shore);
    static VkDeviceSize bytes(const gpu::Device& device, const Shore& shore);
    /// The map on its first call, and the trains at `time`.
    void record(const gpu::Device& device, VkCommandBuffer commands, const Shore& shore, double time,
                double decayTime);
    VkImageView view() const { return image_.view(); }
    const ShoreSignal& signal() const { return signal_; }
    /// Of the call before; of the first call, that one's own.
    const ShoreSignal& last() const { return last_; }

  private:
    FixedImage image_;
    ShoreSignal signal_, last_;
};

} // namespace seaglass
