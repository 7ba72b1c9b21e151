#include "host/scene_again.h"

#include <glm/gtc/type_ptr.hpp>

#include "host/rendering.h"

namespace demos {
namespace {

constexpr VkPipelineStageFlags2 readers =
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;

VkImageMemoryBarrier2 discarded(VkImage image, VkImageAspectFlags aspect, VkImageLayout to,
                                VkPipelineStageFlags2 stage, VkAccessFlags2 access) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = readers;
    barrier.dstStageMask = stage;
    barrier.dstAccessMask = access;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, 1};
    return barrier;
}

void toAttachments(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    const VkImageMemoryBarrier2 barriers[] = {
        discarded(view.colorImage, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                  VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                  VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT),
        discarded(view.depthImage, VK_IMAGE_ASPECT_DEPTH_BIT, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                  VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
                  VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                      VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT)};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 2;
    dependency.pImageMemoryBarriers = barriers;
    vkCmdPipelineBarrier2(commands, &dependency);
}

constexpr VkPipelineStageFlags2 depthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

/// A barrier on an image that was drawn to, for what follows it in `to`.
VkImageMemoryBarrier2 drawn(VkImage image, VkImageAspectFlags aspect, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT | depthTests |
                           VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    barrier.srcAccessMask =
        VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    barrier.dstStageMask = barrier.srcStageMask;
    barrier.dstAccessMask = barrier.srcAccessMask | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                            VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, 1};
    return barrier;
}

void depthTo(VkCommandBuffer commands, const seaglass::PlanarView& view, VkImageLayout from,
             VkImageLayout to) {
    constexpr VkImageLayout color = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkImageMemoryBarrier2 barriers[] = {drawn(view.colorImage, VK_IMAGE_ASPECT_COLOR_BIT, color, color),
                                              drawn(view.depthImage, VK_IMAGE_ASPECT_DEPTH_BIT, from, to)};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 2;
    dependency.pImageMemoryBarriers = barriers;
    vkCmdPipelineBarrier2(commands, &dependency);
}

} // namespace

OtherEye otherEye(const seaglass::PlanarView& view) {
    OtherEye eye;
    glm::dmat4 rotation = glm::make_mat4(view.view);
    eye.position = glm::dvec3(glm::inverse(rotation)[3]);
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    eye.clipFromEye = glm::make_mat4(view.projection) * rotation;
    return eye;
}

FrameUniforms otherUniforms(const FrameUniforms& frame, const Camera& camera, const OtherEye& eye) {
    FrameUniforms uniforms = frame;
    uniforms.clipFromEye = glm::mat4(eye.clipFromEye);
    const glm::dmat4 toFrame = glm::translate(glm::dmat4(1), eye.position - camera.eye);
    for (glm::mat4& shadow : uniforms.shadowFromEye) shadow = glm::mat4(glm::dmat4(shadow) * toFrame);
    moveBentUniforms(eye.position - camera.eye, uniforms);
    return uniforms;
}

void recordSceneAgain(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                      const OpaquePass& opaque, const OtherEye& eye, const seaglass::PlanarView& view) {
    toAttachments(commands, view);
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_DONT_CARE, view.depth,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, view.clearDepth);
    MeshPipelines pipelines = opaque.meshPipelines(eye.clipFromEye);
    pipelines.mirrored = view.windingFlipped;
    drawMeshes(commands, layouts, meshes, eye.position, pipelines);
    vkCmdEndRendering(commands);
}

void beginOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    depthTo(commands, view, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
            VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_LOAD, view.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
}

void endOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    vkCmdEndRendering(commands);
    depthTo(commands, view, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL,
            VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
}

} // namespace demos
