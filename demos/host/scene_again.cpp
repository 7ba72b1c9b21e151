#include "host/scene_again.h"

#include <glm/gtc/type_ptr.hpp>

#include "host/rendering.h"

namespace demos {
namespace {

/// What the images of such a view are used for.
struct Use {
    VkPipelineStageFlags2 stage;
    VkAccessFlags2 access;
    VkImageLayout color, depth;
};

constexpr Use sampledBefore = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT |
                                   VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                               VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_UNDEFINED};
constexpr Use attached = {
    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
        VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
constexpr Use depthRead = {attached.stage | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                               VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                           attached.access | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, attached.color,
                           VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};

void change(VkCommandBuffer commands, const seaglass::PlanarView& view, const Use& from, const Use& to) {
    VkImageMemoryBarrier2 barriers[2] = {};
    for (VkImageMemoryBarrier2& barrier : barriers) {
        const bool color = &barrier == barriers;
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
        barrier.srcStageMask = from.stage;
        barrier.srcAccessMask = from.access;
        barrier.dstStageMask = to.stage;
        barrier.dstAccessMask = to.access;
        barrier.oldLayout = color ? from.color : from.depth;
        barrier.newLayout = color ? to.color : to.depth;
        barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = color ? view.colorImage : view.depthImage;
        barrier.subresourceRange.aspectMask = color ? VK_IMAGE_ASPECT_COLOR_BIT : VK_IMAGE_ASPECT_DEPTH_BIT;
        barrier.subresourceRange.levelCount = 1;
        barrier.subresourceRange.layerCount = 1;
    }
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
    setClip(eye.clipFromEye, uniforms);
    const glm::dmat4 toFrame = glm::translate(glm::dmat4(1), eye.position - camera.eye);
    for (glm::mat4& shadow : uniforms.shadowFromEye) shadow = glm::mat4(glm::dmat4(shadow) * toFrame);
    moveBentUniforms(eye.position - camera.eye, uniforms);
    return uniforms;
}

void recordSceneAgain(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                      const OpaquePass& opaque, const OtherEye& eye, const seaglass::PlanarView& view) {
    change(commands, view, sampledBefore, attached);
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_DONT_CARE, view.depth,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, view.clearDepth);
    MeshPipelines pipelines = opaque.meshPipelines(eye.clipFromEye);
    pipelines.mirrored = view.windingFlipped;
    drawMeshes(commands, layouts, meshes, eye.position, pipelines);
    vkCmdEndRendering(commands);
}

void readBedDepth(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    change(commands, view, attached, depthRead);
}

void beginOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_LOAD, view.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0, depthRead.depth);
}

void endOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    vkCmdEndRendering(commands);
    change(commands, view, depthRead, attached);
}

} // namespace demos
