// Beginning a dynamic rendering pass over whole images.
#pragma once

#include "host/vulkan/resources.h"

namespace demos {

/// Colour is cleared to zero, depth to `clearDepth`; both are kept. Depth in a layout to read is only read.
/// Viewport and scissor are set to all of it.
inline void beginRendering(VkCommandBuffer commands, VkExtent2D extent, VkImageView color,
                           VkAttachmentLoadOp colorLoad, VkImageView depth, VkAttachmentLoadOp depthLoad,
                           float clearDepth,
                           VkImageLayout depthLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL) {
    VkRenderingAttachmentInfo colorInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    colorInfo.imageView = color;
    colorInfo.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colorInfo.loadOp = colorLoad;
    colorInfo.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    VkRenderingAttachmentInfo depthInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    depthInfo.imageView = depth;
    depthInfo.imageLayout = depthLayout;
    depthInfo.loadOp = depthLoad;
    depthInfo.storeOp = depthLayout == VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                            ? VK_ATTACHMENT_STORE_OP_NONE
                            : VK_ATTACHMENT_STORE_OP_STORE;
    depthInfo.clearValue.depthStencil.depth = clearDepth;
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea.extent = extent;
    info.layerCount = 1;
    info.colorAttachmentCount = color ? 1 : 0;
    info.pColorAttachments = &colorInfo;
    info.pDepthAttachment = &depthInfo;
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport = {0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height),
                                 0, 1};
    const VkRect2D scissor = {{0, 0}, extent};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

inline void beginRendering(VkCommandBuffer commands, VkExtent2D extent, const Image* color,
                           VkAttachmentLoadOp colorLoad, const Image& depth, VkAttachmentLoadOp depthLoad,
                           float clearDepth) {
    beginRendering(commands, extent, color ? color->view.get() : VK_NULL_HANDLE, colorLoad, depth.view.get(),
                   depthLoad, clearDepth);
}

} // namespace demos
