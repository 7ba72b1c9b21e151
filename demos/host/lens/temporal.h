// Antialiasing over time: each frame is moved by another part of a pixel, and averaged with those before it.
#pragma once

#include "host/camera.h"
#include "host/lens/picture_pass.h"
#include "host/vulkan/frame_targets.h"

namespace demos {

/// What a frame was seen by.
struct Sight {
    CameraDesc desc;
    double timeS = 0;
    glm::dvec3 eye{0};
    glm::dmat4 clipFromEye{1}; ///< without a jitter
};

/// By which frame `index` is to be moved [pixel], as FrameDesc::jitterPx: Halton's sequence.
std::array<double, 2> jitterOf(uint32_t index);

class Temporal {
  public:
    bool fit(const Device& device, const FrameTargets& targets, Error& error);
    /// What it has averaged is of other frames than the last.
    void forget();
    /// Drops what it holds for targets.
    void drop();
    /// Makes targets.color the average, an attachment before and after. Takes targets.sceneDepth for it.
    void record(VkCommandBuffer commands, const FrameTargets& targets, const Sight& sight, bool follows);

  private:
    struct History {
        Image image;
        UniqueDescriptorPool pool, copyPool;
        VkDescriptorSet set = VK_NULL_HANDLE;     ///< to average with it
        VkDescriptorSet copySet = VK_NULL_HANDLE; ///< to read it alone
        bool drawn = false;
    };

    PicturePass pass_, copy_;
    History histories_[2]; ///< of the frame before and of this one, by turns
    uint32_t next_ = 0;
    uint32_t averaged_ = 0; ///< frames
    Sight before_;
};

} // namespace demos
