// Commands that hosts record beside Seaglass's: copies of the scene for it to read, what its images of
// planarView() and bedView() go through while the host draws into them, and a sky of one colour.
// Apart: no other header includes it, and nothing in the libraries was compiled with it. Vulkan's functions
// are called by their names: include what declares them (vulkan.h, volk.h) before.
#pragma once

#include "seaglass/reflection.h"

namespace seaglass {

/// What passes have drawn into, and an image of the same format and size that becomes its copy.
struct SceneCopy {
    VkImage from = VK_NULL_HANDLE;                         ///< made with VK_IMAGE_USAGE_TRANSFER_SRC_BIT
    VkImage to = VK_NULL_HANDLE;                           ///< made with TRANSFER_DST and SAMPLED
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;      ///< of `from`, before and after
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT; ///< or VK_IMAGE_ASPECT_DEPTH_BIT
    VkExtent2D extent = {0, 0};                            ///< [pixel]
};

/// A barrier over all of an image's one mip and `layers`.
inline VkImageMemoryBarrier2 imageBarrier(VkImage image, VkImageAspectFlags aspect, uint32_t layers,
                                          VkImageLayout before, VkImageLayout after) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.oldLayout = before;
    barrier.newLayout = after;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, layers};
    return barrier;
}

/// Records one barrier alone.
inline void recordBarrier(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

/// Outside any pass, after what draws into `from` and before reflect(). Waits for attachments to be written,
/// leaves `from` to be attached again and `to` in SHADER_READ_ONLY_OPTIMAL, visible to compute and fragment
/// shaders, whose reads before it waits for.
inline void recordSceneCopy(VkCommandBuffer commands, const SceneCopy& copy) {
    constexpr VkPipelineStageFlags2 attached = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT |
                                               VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                                               VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkPipelineStageFlags2 shaders =
        VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    constexpr VkAccessFlags2 written =
        VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    constexpr VkAccessFlags2 used =
        written | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;

    VkImageMemoryBarrier2 from =
        imageBarrier(copy.from, copy.aspect, 1, copy.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    from.srcStageMask = attached;
    from.srcAccessMask = written;
    from.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    from.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
    VkImageMemoryBarrier2 to = imageBarrier(copy.to, copy.aspect, 1, VK_IMAGE_LAYOUT_UNDEFINED,
                                            VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    to.srcStageMask = shaders;
    to.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    to.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    recordBarrier(commands, from);
    recordBarrier(commands, to);

    VkImageCopy region{};
    region.srcSubresource = region.dstSubresource = {copy.aspect, 0, 0, 1};
    region.extent = {copy.extent.width, copy.extent.height, 1};
    vkCmdCopyImage(commands, copy.from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.to,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);

    from = imageBarrier(copy.from, copy.aspect, 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.layout);
    from.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    from.dstStageMask = attached;
    from.dstAccessMask = used;
    to = imageBarrier(copy.to, copy.aspect, 1, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    to.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    to.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    to.dstStageMask = shaders;
    to.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    recordBarrier(commands, from);
    recordBarrier(commands, to);
}

/// What the images that planarView() or bedView() handed out are used for.
enum class DrawnUse : uint32_t {
    sampled = 0, ///< by what used them last, in an earlier frame; what they held is lost
    attached,    ///< to be drawn into; as reflect() takes them over
    /// Of a bed, for castCaustics() and drawCaustics() over it: the colour attached, the depth sampled and
    /// attached in VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL.
    depthRead,
};

/// Outside any pass: from `sampled` to `attached`, then the host's pass, then reflect(). Over a bed with
/// caustics on to `depthRead` between them, and back.
inline void recordDrawnUse(VkCommandBuffer commands, const PlanarView& drawn, DrawnUse before,
                           DrawnUse after) {
    struct Use {
        VkPipelineStageFlags2 stage;
        VkAccessFlags2 access;
        VkImageLayout layout;
    };
    constexpr VkPipelineStageFlags2 shaders =
        VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    constexpr VkPipelineStageFlags2 tests =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    constexpr Use lost = {shaders, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
    constexpr Use color = {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                           VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                           VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    constexpr Use depth = {
        tests, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
        VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    constexpr Use read = {shaders | tests,
                          VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
                          VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
    constexpr Use colors[] = {lost, color, color}, depths[] = {lost, depth, read};
    const auto record = [&](VkImage image, VkImageAspectFlags aspects, const Use* uses) {
        const Use &from = uses[static_cast<uint32_t>(before)], &to = uses[static_cast<uint32_t>(after)];
        VkImageMemoryBarrier2 barrier = imageBarrier(image, aspects, 1, from.layout, to.layout);
        barrier.srcStageMask = from.stage;
        barrier.srcAccessMask = from.access;
        barrier.dstStageMask = to.stage;
        barrier.dstAccessMask = to.access;
        recordBarrier(commands, barrier);
    };
    record(drawn.colorImage, VK_IMAGE_ASPECT_COLOR_BIT, colors);
    record(drawn.depthImage, drawn.depthAspects, depths);
}

/// For LightingDesc::skyCube of a scene with a sky of one colour: fills a cube of one mip, of any size and
/// made with VK_IMAGE_USAGE_TRANSFER_DST_BIT, and leaves it in SHADER_READ_ONLY_OPTIMAL, visible to compute
/// and fragment shaders. Once, outside any pass; what it held is lost.
inline void recordEvenSky(VkCommandBuffer commands, VkImage cube, float red, float green, float blue) {
    constexpr VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageMemoryBarrier2 barrier =
        imageBarrier(cube, aspect, 6, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    recordBarrier(commands, barrier);
    const VkClearColorValue color = {{red, green, blue, 1}};
    vkCmdClearColorImage(commands, cube, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1,
                         &barrier.subresourceRange);
    barrier = imageBarrier(cube, aspect, 6, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    recordBarrier(commands, barrier);
}

} // namespace seaglass
