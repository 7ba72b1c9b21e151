#include "host/scene_again.h"

#include <glm/gtc/type_ptr.hpp>

#include "host/passes/fog_uniforms.h"
#include "host/vulkan/rendering.h"
#include "host/water/wet_sand.h"
#include "seaglass/record.h"

namespace demos {

using seaglass::DrawnUse;

namespace {

/// Of images that Seaglass has just handed out, so nothing of it can be wrong.
void become(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view,
            DrawnUse before, DrawnUse after) {
    static_cast<void>(seaglass::recordDrawnUse(context, commands, view, before, after));
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
    moveFogUniforms(eye.position - camera.eye, uniforms);
    moveShoreUniforms(eye.position - camera.eye, uniforms);
    return uniforms;
}

void recordSceneAgain(seaglass::Context* context, VkCommandBuffer commands, const Layouts& layouts,
                      const MeshSet& meshes, const OpaquePass& opaque, const OtherEye& eye,
                      const seaglass::PlanarView& view) {
    become(context, commands, view, DrawnUse::sampled, DrawnUse::attached);
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_DONT_CARE, view.depth,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, view.clearDepth,
                   VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
    MeshPipelines pipelines = opaque.meshPipelines(eye.clipFromEye);
    pipelines.mirrored = view.windingFlipped;
    drawMeshes(commands, layouts, meshes, eye.position, pipelines);
    vkCmdEndRendering(commands);
}

void readBedDepth(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view) {
    become(context, commands, view, DrawnUse::attached, DrawnUse::depthRead);
}

void beginOverBed(VkCommandBuffer commands, const seaglass::PlanarView& view) {
    beginRendering(commands, view.extent, view.color, VK_ATTACHMENT_LOAD_OP_LOAD, view.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
}

void endOverBed(seaglass::Context* context, VkCommandBuffer commands, const seaglass::PlanarView& view) {
    vkCmdEndRendering(commands);
    become(context, commands, view, DrawnUse::depthRead, DrawnUse::attached);
}

} // namespace demos
