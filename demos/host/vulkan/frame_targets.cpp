#include "host/vulkan/frame_targets.h"

#include <cstring>
#include <limits>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

namespace demos {
namespace {

constexpr VkPipelineStageFlags2 depthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 colorOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 transfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 depthAccess =
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 colorAccess =
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkPipelineStageFlags2 readers =
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;

void colorToSource(VkCommandBuffer commands, const Image& color) {
    imageBarrier(commands, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, colorOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                 transfer, VK_ACCESS_2_TRANSFER_READ_BIT);
}

void depthToSource(VkCommandBuffer commands, const Image& depth) {
    imageBarrier(commands, depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, depthTests,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, transfer, VK_ACCESS_2_TRANSFER_READ_BIT);
}

void copyWhole(VkCommandBuffer commands, const Image& from, const Image& to) {
    VkImageCopy copy{};
    copy.srcSubresource = {from.aspect, 0, 0, 1};
    copy.dstSubresource = {to.aspect, 0, 0, 1};
    copy.extent = {from.extent.width, from.extent.height, 1};
    vkCmdCopyImage(commands, from.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image.get(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
}

void copyForReaders(VkCommandBuffer commands, const Image& from, const Image& to) {
    imageBarrier(commands, to, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, readers, 0,
                 transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    copyWhole(commands, from, to);
    imageBarrier(commands, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                 transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, readers, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

/// From what shaders sample; the attachment is left as a copy's destination.
void copyToAttachment(VkCommandBuffer commands, const Image& from, const Image& to) {
    imageBarrier(commands, from, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readers, 0, transfer, VK_ACCESS_2_TRANSFER_READ_BIT);
    imageBarrier(commands, to, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                 colorOutput | depthTests, 0, transfer, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    copyWhole(commands, from, to);
    imageBarrier(commands, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, transfer, 0, readers,
                 VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

Picture emptyPicture(VkExtent2D extent) {
    return {extent.width, extent.height, std::vector<float>(size_t(extent.width) * extent.height * 4)};
}

/// By a copy, of an attachment in this layout.
VkAccessFlags2 writtenByCopy(VkImageLayout from) {
    return from == VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL ? VK_ACCESS_2_NONE : VK_ACCESS_2_TRANSFER_WRITE_BIT;
}

} // namespace

void FrameTargets::colorToAttachment(VkCommandBuffer commands, VkImageLayout from) const {
    imageBarrier(commands, color, from, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, transfer | colorOutput,
                 writtenByCopy(from), colorOutput, colorAccess);
}

void FrameTargets::depthToAttachment(VkCommandBuffer commands, VkImageLayout from) const {
    imageBarrier(commands, depth, from, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, transfer | depthTests,
                 writtenByCopy(from), depthTests, depthAccess);
}

void FrameTargets::toAttachments(VkCommandBuffer commands, VkImageLayout from) const {
    colorToAttachment(commands, from);
    depthToAttachment(commands, from);
}

void FrameTargets::betweenPasses(VkCommandBuffer commands) const {
    imageBarrier(commands, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, colorOutput, colorAccess);
    imageBarrier(commands, depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, depthTests,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, depthTests, depthAccess);
}

void FrameTargets::copyColor(VkCommandBuffer commands) const {
    colorToSource(commands, color);
    copyForReaders(commands, color, sceneColor);
    colorToAttachment(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

void FrameTargets::copyDepth(VkCommandBuffer commands) const {
    depthToSource(commands, depth);
    copyForReaders(commands, depth, sceneDepth);
    depthToAttachment(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

void FrameTargets::copyScene(VkCommandBuffer commands) const {
    copyColor(commands);
    copyDepth(commands);
}

void FrameTargets::restoreScene(VkCommandBuffer commands) const {
    copyToAttachment(commands, sceneColor, color);
    copyToAttachment(commands, sceneDepth, depth);
    toAttachments(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
}

void FrameTargets::exactToAttachment(VkCommandBuffer commands) const {
    imageBarrier(commands, exact, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 transfer | colorOutput, 0, colorOutput, colorAccess);
}

void FrameTargets::beginOverlay(VkCommandBuffer commands) const {
    imageBarrier(commands, overlay, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL, transfer, 0,
                 VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void FrameTargets::endOverlay(VkCommandBuffer commands) const {
    imageBarrier(commands, overlay, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, colorOutput,
                 colorAccess);
}

void FrameTargets::copyBack(VkCommandBuffer commands, const Image& source) const {
    if (source.aspect == VK_IMAGE_ASPECT_DEPTH_BIT)
        depthToSource(commands, source);
    else
        colorToSource(commands, source);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {source.aspect, 0, 0, 1};
    copy.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyImageToBuffer(commands, source.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           readback.buffer.get(), 1, &copy);
    transferToHost(commands);
}

bool createFrameTargets(const Device& device, VkExtent2D extent, FrameTargets& out, Error& error) {
    // Two RGBA16F, two D32 and the readback; asked for beforehand, since a driver may promise memory that is
    // not there.
    const VkDeviceSize bytes = VkDeviceSize(extent.width) * extent.height * (2 * 8 + 2 * 4 + 8);
    const uint32_t limit = device.properties().limits.maxImageDimension2D;
    if (extent.width <= limit && extent.height <= limit && bytes > device.largestHeap()) {
        error.text = "a picture of " + std::to_string(extent.width) + "x" + std::to_string(extent.height) +
                     " needs " + std::to_string(bytes >> 20) + " MiB, the device has " +
                     std::to_string(device.largestHeap() >> 20);
        return false;
    }
    ImageDesc color;
    color.format = FrameTargets::colorFormat;
    color.extent = extent;
    constexpr VkImageUsageFlags copied = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    color.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | copied;
    ImageDesc depth = color;
    depth.format = FrameTargets::depthFormat;
    depth.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | copied;
    ImageDesc sceneColor = color, sceneDepth = depth;
    sceneColor.usage = sceneDepth.usage = VK_IMAGE_USAGE_SAMPLED_BIT | copied;
    out.extent = extent;
    return createImage(device, color, out.color, error) && createImage(device, depth, out.depth, error) &&
           createImage(device, sceneColor, out.sceneColor, error) &&
           createImage(device, sceneDepth, out.sceneDepth, error) &&
           createBuffer(device, VkDeviceSize(extent.width) * extent.height * 8,
                        VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::readback, out.readback, error);
}

bool createExactTarget(const Device& device, FrameTargets& targets, Error& error) {
    if (targets.exact.view) return true;
    ImageDesc desc;
    desc.format = FrameTargets::exactFormat;
    desc.extent = targets.extent;
    desc.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    return createImage(device, desc, targets.exact, error) &&
           createBuffer(device, VkDeviceSize(desc.extent.width) * desc.extent.height * 16,
                        VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::readback, targets.readback, error);
}

bool createOverlayTarget(const Device& device, FrameTargets& targets, Error& error) {
    if (targets.overlay.view) return true;
    ImageDesc desc;
    desc.format = FrameTargets::colorFormat;
    desc.extent = targets.extent;
    desc.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                 VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    return createImage(device, desc, targets.overlay, error);
}

Picture readColor(const FrameTargets& targets) {
    Picture picture = emptyPicture(targets.extent);
    const auto* const halves = static_cast<const uint64_t*>(targets.readback.mapped);
    for (size_t i = 0; i < picture.rgba.size() / 4; ++i) {
        const glm::vec4 pixel = glm::unpackHalf4x16(halves[i]);
        std::memcpy(&picture.rgba[4 * i], &pixel, sizeof(pixel));
    }
    return picture;
}

Picture readExact(const FrameTargets& targets) {
    Picture picture = emptyPicture(targets.extent);
    std::memcpy(picture.rgba.data(), targets.readback.mapped, picture.rgba.size() * sizeof(float));
    return picture;
}

Picture readDepth(const FrameTargets& targets, const Camera& camera) {
    Picture picture = emptyPicture(targets.extent);
    const auto* const depths = static_cast<const float*>(targets.readback.mapped);
    for (size_t i = 0; i < picture.rgba.size() / 4; ++i) {
        const double depth = static_cast<double>(depths[i]);
        picture.rgba[4 * i] =
            depth > 0 ? static_cast<float>(camera.distanceOf(depth)) : std::numeric_limits<float>::infinity();
        picture.rgba[4 * i + 3] = 1;
    }
    return picture;
}

} // namespace demos
