// Commands that hosts record beside Seaglass's: copies of the scene for it to read, and what its images of
// planarView() and bedView() go through while the host draws into them. A host's own barriers do as well.
#pragma once

#include "seaglass/reflection.h"

namespace seaglass {

/// What passes have drawn into, and an image of the same format and size that becomes its copy.
struct SceneCopy {
    VkImage from = VK_NULL_HANDLE;                    ///< made with VK_IMAGE_USAGE_TRANSFER_SRC_BIT
    VkImage to = VK_NULL_HANDLE;                      ///< made with TRANSFER_DST and SAMPLED
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< of `from`, before and after; all its aspects'
    /// Or all that the format holds of VK_IMAGE_ASPECT_DEPTH_BIT and VK_IMAGE_ASPECT_STENCIL_BIT: the depth
    /// is copied, the stencil goes along from layout to layout.
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkExtent2D extent = {0, 0}; ///< [pixel]
};

/// Outside any pass, after what draws into `from` and before reflect(). Waits for attachments to be written,
/// leaves `from` to be attached again and `to` in SHADER_READ_ONLY_OPTIMAL, visible to compute and fragment
/// shaders, whose reads before it waits for. `invalidArgument`: a field is null or undefined.
Status recordSceneCopy(Context* context, VkCommandBuffer commands, const SceneCopy& copy);

/// What the images that planarView() or bedView() handed out are used for.
enum class DrawnUse : uint32_t {
    sampled = 0, ///< by what used them last, in an earlier frame; what they held is lost
    attached,    ///< to be drawn into; as reflect() takes them over
    /// Of a bed, for castCaustics() and drawCaustics() over it: the colour attached, the depth sampled and
    /// attached in VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL.
    depthRead,
};

/// Outside any pass: from `sampled` to `attached`, then the host's pass, then reflect(). Over a bed with
/// caustics on to `depthRead` between them, and back. `invalidArgument`: an image is null.
Status recordDrawnUse(Context* context, VkCommandBuffer commands, const PlanarView& drawn, DrawnUse before,
                      DrawnUse after);

} // namespace seaglass
