#include "tests/gpu/drawn_view.h"

#include <span>

#include "tests/gpu/rig.h"

namespace tests {

namespace {

demos::Buffer upload(std::span<const std::byte> bytes) {
    demos::Buffer buffer;
    demos::Error error;
    EXPECT_TRUE(demos::createFilledBuffer(device(), bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, buffer, error))
        << error.text;
    return buffer;
}

void barrier(VkCommandBuffer commands, const seaglass::PlanarView& view, VkImageLayout colorFrom,
             VkImageLayout depthFrom, VkImageLayout colorTo, VkImageLayout depthTo) {
    const bool before = colorFrom == VK_IMAGE_LAYOUT_UNDEFINED;
    VkImageMemoryBarrier2 barriers[2] = {{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2},
                                         {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2}};
    for (VkImageMemoryBarrier2& b : barriers) {
        b.srcStageMask =
            before ? VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
                   : VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
        b.srcAccessMask = before ? VK_ACCESS_2_NONE : VK_ACCESS_2_TRANSFER_WRITE_BIT;
        b.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
        b.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    }
    if (!before) {
        barriers[0].dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
        barriers[0].dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
        barriers[1].dstStageMask = VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
        barriers[1].dstAccessMask = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    }
    barriers[0].oldLayout = colorFrom;
    barriers[0].newLayout = colorTo;
    barriers[0].image = view.colorImage;
    barriers[0].subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    barriers[1].oldLayout = depthFrom;
    barriers[1].newLayout = depthTo;
    barriers[1].image = view.depthImage;
    barriers[1].subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 2;
    dependency.pImageMemoryBarriers = barriers;
    vkCmdPipelineBarrier2(commands, &dependency);
}

} // namespace

glm::dmat4 matrix(const double (&values)[16]) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[i];
    return m;
}

DrawnBuffers::DrawnBuffers(const Drawn& drawn)
    : color(upload(std::as_bytes(std::span(drawn.color)))),
      depth(upload(std::as_bytes(std::span(drawn.depth)))) {}

void recordDrawing(VkCommandBuffer commands, const seaglass::PlanarView& view, const DrawnBuffers& drawn) {
    barrier(commands, view, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_UNDEFINED,
            VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageExtent = {view.extent.width, view.extent.height, 1};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    vkCmdCopyBufferToImage(commands, drawn.color.buffer.get(), view.colorImage,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    region.imageSubresource.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    vkCmdCopyBufferToImage(commands, drawn.depth.buffer.get(), view.depthImage,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    barrier(commands, view, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
            VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
}

} // namespace tests
