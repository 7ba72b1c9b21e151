// The images a frame is drawn into, the copies the water reads, and the way back to the CPU.
#pragma once

#include "host/camera.h"
#include "host/vulkan/resources.h"

namespace demos {

struct FrameTargets {
    static constexpr VkFormat colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
    static constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;
    static constexpr VkFormat exactFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

    VkExtent2D extent = {0, 0};
    Image color, depth;
    Image sceneColor, sceneDepth; ///< the opaque scene, for the water to read
    Image exact;                  ///< for what halves do not hold; only once createExactTarget() made it
    Image overlay;                ///< for the library to draw into; only once createOverlayTarget() made it
    Buffer readback;

    /// Attachments from `from`, whatever was done with them before.
    void colorToAttachment(VkCommandBuffer commands, VkImageLayout from) const;
    void depthToAttachment(VkCommandBuffer commands, VkImageLayout from) const;
    void toAttachments(VkCommandBuffer commands, VkImageLayout from) const;
    /// Between two passes that draw into the same attachments.
    void betweenPasses(VkCommandBuffer commands) const;
    /// Copies colour and depth to sceneColor and sceneDepth, which compute and fragment shaders may then
    /// sample.
    void copyColor(VkCommandBuffer commands) const;
    void copyDepth(VkCommandBuffer commands) const;
    void copyScene(VkCommandBuffer commands) const;
    /// Copies sceneColor and sceneDepth back, as if nothing had been drawn since copyScene().
    void restoreScene(VkCommandBuffer commands) const;
    /// Readies `exact` for a pass that clears it.
    void exactToAttachment(VkCommandBuffer commands) const;
    /// Readies `overlay` to be written by compute shaders, and what they wrote to be copied as attachments
    /// are.
    void beginOverlay(VkCommandBuffer commands) const;
    void endOverlay(VkCommandBuffer commands) const;
    /// Copies colour, exact, overlay or depth into `readback`; it ends as a transfer source.
    void copyBack(VkCommandBuffer commands, const Image& source) const;
};

/// Whether an output is drawn into FrameTargets::exact instead of color.
inline bool needsExact(Aov aov) {
    return aov == Aov::reflectionSource;
}

/// An extent over the device's limits or memory is an error.
bool createFrameTargets(const Device& device, VkExtent2D extent, FrameTargets& out, Error& error);

/// Adds `exact` to targets that lack it.
bool createExactTarget(const Device& device, FrameTargets& targets, Error& error);

/// Adds `overlay` to targets that lack it.
bool createOverlayTarget(const Device& device, FrameTargets& targets, Error& error);

/// What copyBack() brought, as floats.
Picture readColor(const FrameTargets& targets);
Picture readExact(const FrameTargets& targets);
/// Metres along the view axis in red, infinite for the far plane.
Picture readDepth(const FrameTargets& targets, const Camera& camera);

} // namespace demos
