#include "host/passes/opaque.h"

#include "host/vulkan/pipeline.h"
#include "host/vulkan/rendering.h"
#include "spirv/opaque.frag.h"
#include "spirv/opaque.vert.h"

namespace demos {

bool OpaquePass::create(const Device& device, const Layouts& layouts, Error& error) {
    return sky_.create(device, layouts, FrameTargets::colorFormat, FrameTargets::depthFormat, error);
}

bool OpaquePass::prepare(const Device& device, const Layouts& layouts, const MeshSet& meshes, Error& error) {
    PipelineDesc desc;
    desc.vertex = opaque_vert;
    desc.fragment = opaque_frag;
    desc.colorFormat = FrameTargets::colorFormat;
    desc.depthFormat = FrameTargets::depthFormat;
    return pipelines_.make(device, layouts.pipeline.get(), desc, featuresOf(meshes), error);
}

void OpaquePass::record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                        const Camera& camera, const FrameTargets& targets) const {
    targets.toAttachments(commands, VK_IMAGE_LAYOUT_UNDEFINED);
    beginRendering(commands, targets.extent, &targets.color, VK_ATTACHMENT_LOAD_OP_CLEAR, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, 0);
    drawMeshes(commands, layouts, meshes, camera.eye, meshPipelines(camera.projection * camera.rotation));
    sky_.draw(commands);
    vkCmdEndRendering(commands);
}

} // namespace demos
