// A body's foam: the history's image, and who steps it.
#pragma once

#include <optional>
#include <variant>

#include "water/foam/foam_gpu.h"
#include "water/foam/foam_image.h"
#include "water/foam/foam_upload.h"
#include "water/waves/waves.h"

namespace seaglass {

class Foam {
  public:
    /// `sea` breaks, and outlives the foam; `backend` computes its waves, null: shaders do.
    Status create(Context& context, const Sea& sea, const FoamDesc& foam, const WavesBackend* backend);
    /// Brings the history to `time` where it has passed a step. May leave the wave maps at another time.
    Status record(Context& context, VkCommandBuffer commands, Waves& waves, double time);

    static VkDeviceSize bytes(const Context& context, const Sea& sea, const FoamDesc& foam,
                              const WavesBackend* backend);
    VkImageView view() const { return image_.image.view(); }
    VkImage image() const { return image_.image.handle(); }
    uint32_t cascades() const { return image_.image.desc().layers; }
    const Breaking& breaking() const { return breaking_; }
    float albedo() const { return albedo_; }
    /// Where the time recorded last lies between the image's steps.
    const FoamTime& at() const { return at_; }
    /// Recorded last [s].
    double time() const { return time_; }

  private:
    Status recordSteps(Context& context, VkCommandBuffer commands, Waves& waves, int64_t step);

    double loopPeriod_ = 1;
    float albedo_ = 0;
    Breaking breaking_;
    FoamTime at_;
    double time_ = 0;
    FoamImage image_;
    std::variant<ComputedFoam, UploadedFoam> source_;
    std::optional<int64_t> step_; ///< that the image holds
};

} // namespace seaglass
