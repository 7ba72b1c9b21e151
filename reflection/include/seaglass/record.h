// Commands that hosts record beside Seaglass's, or their own in the place of these: copies of the scene, and
// barriers on what planarView() and bedView() hand out.
#pragma once

#include "seaglass/reflection.h"

namespace seaglass {

/// What passes have drawn into, and an image of its format and size that becomes its copy.
struct SceneCopy {
    VkImage from = VK_NULL_HANDLE;                    ///< made with VK_IMAGE_USAGE_TRANSFER_SRC_BIT
    VkImage to = VK_NULL_HANDLE;                      ///< made with TRANSFER_DST and SAMPLED
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< of `from`, before and after; all its aspects'
    /// Or all that a format holds of depth and stencil: depth is copied, stencil changes layouts with it.
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkExtent2D extent = {0, 0}; ///< [pixel]
};

/// Outside any pass, after what draws into `from` and before reflect(). Waits for attachment writes, and for
/// compute and fragment shaders that read `to`. Leaves `from` to be attached again, and `to` visible to those
/// in SHADER_READ_ONLY_OPTIMAL. `invalidArgument`: a field is null or undefined.
Status recordSceneCopy(Context* context, VkCommandBuffer commands, const SceneCopy& copy);

/// What images of planarView() or bedView() are used for.
enum class DrawnUse : uint32_t {
    sampled = 0, ///< by what used them last, in an earlier frame; what they held is lost
    attached,    ///< to be drawn into; as reflect() takes them over
    depthRead,   ///< for caustics over a bed: as `attached`, but the depth DEPTH_STENCIL_READ_ONLY_OPTIMAL
};

/// Outside any pass: from `sampled` to `attached`, then the host's pass, then reflect(); over a bed with
/// caustics on to `depthRead` in between, and back. `invalidArgument`: an image is null.
Status recordDrawnUse(Context* context, VkCommandBuffer commands, const PlanarView& drawn, DrawnUse before,
                      DrawnUse after);

} // namespace seaglass
