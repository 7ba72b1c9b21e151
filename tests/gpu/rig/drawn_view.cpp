#include "tests/gpu/rig/drawn_view.h"

#include <span>

#include "host/vulkan/rendering.h"
#include "seaglass/record.h"
#include "tests/gpu/rig/rig.h"

namespace tests {

namespace {

demos::Buffer upload(std::span<const std::byte> bytes) {
    demos::Buffer buffer;
    demos::Error error;
    EXPECT_TRUE(demos::createFilledBuffer(device(), bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, buffer, error))
        << error.text;
    return buffer;
}

struct Use {
    VkPipelineStageFlags2 stage;
    VkAccessFlags2 access;
    VkImageLayout layout;
};

/// Of both images.
struct Uses {
    Use color, depth;
};

constexpr Use sampledLast = {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                             VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
constexpr Use copied = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr Uses discarded = {sampledLast, sampledLast};
constexpr Uses filled = {copied, copied};
constexpr Uses attached = {
    {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
    {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}};

VkImageMemoryBarrier2 barrierOf(VkImage image, VkImageAspectFlags aspect, const Use& from, const Use& to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = from.stage;
    barrier.srcAccessMask = from.access;
    barrier.dstStageMask = to.stage;
    barrier.dstAccessMask = to.access;
    barrier.oldLayout = from.layout;
    barrier.newLayout = to.layout;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, 1};
    return barrier;
}

void recordBarriers(VkCommandBuffer commands, const seaglass::PlanarView& view, const Uses& from,
                    const Uses& to) {
    const VkImageMemoryBarrier2 barriers[] = {
        barrierOf(view.colorImage, VK_IMAGE_ASPECT_COLOR_BIT, from.color, to.color),
        barrierOf(view.depthImage, VK_IMAGE_ASPECT_DEPTH_BIT, from.depth, to.depth)};
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
    recordBarriers(commands, view, discarded, filled);
    VkBufferImageCopy region{};
    region.imageExtent = {view.extent.width, view.extent.height, 1};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    vkCmdCopyBufferToImage(commands, drawn.color.buffer.get(), view.colorImage,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    region.imageSubresource.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    vkCmdCopyBufferToImage(commands, drawn.depth.buffer.get(), view.depthImage,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    recordBarriers(commands, view, filled, attached);
}

void beginDrawing(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view) {
    using seaglass::DrawnUse;
    EXPECT_EQ(seaglass::recordDrawnUse(context, commands, view, DrawnUse::sampled, DrawnUse::attached),
              seaglass::Status::ok);
    demos::beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_CLEAR, view.depth,
                          VK_ATTACHMENT_LOAD_OP_CLEAR, view.clearDepth,
                          VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
}

} // namespace tests
