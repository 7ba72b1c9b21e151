#include "tests/gpu/host/cube_edges.h"

#include <gtest/gtest.h>

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"
#include "spirv/fill_sample.vert.h"

namespace tests {

namespace {

constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

/// A depth of one pixel, which nothing reads.
struct EdgeTarget {
    demos::Image depth;

    bool create(demos::Device& device, demos::Error& error) {
        demos::ImageDesc desc;
        desc.format = depthFormat;
        desc.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
        return demos::createImage(device, desc, depth, error);
    }

    void begin(VkCommandBuffer commands) const {
        demos::imageBarrier(commands, depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL,
                            VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                            VK_ACCESS_2_MEMORY_WRITE_BIT);
        VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        attachment.imageView = depth.view.get();
        attachment.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
        attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        attachment.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
        rendering.renderArea.extent = depth.extent;
        rendering.layerCount = 1;
        rendering.pDepthAttachment = &attachment;
        vkCmdBeginRendering(commands, &rendering);
        const VkViewport viewport = {0, 0, 1, 1, 0, 1};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
        vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
        vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    }
};

bool bindToDraw(demos::Device& device, const demos::Image& cube, demos::Error& error) {
    constexpr VkDescriptorType types[] = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    constexpr VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1}};
    demos::PipelineDesc desc;
    desc.vertex = fill_sample_vert;
    desc.meshVertices = false;
    desc.depthFormat = depthFormat;
    demos::UniqueDescriptorSetLayout setLayout;
    demos::UniquePipelineLayout layout;
    demos::UniquePipeline pipeline;
    demos::UniqueDescriptorPool pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    demos::UniqueSampler sampler;
    EdgeTarget target;
    if (!demos::createSetLayout(device, types, setLayout, error)) return false;
    const VkDescriptorSetLayout ofSet = setLayout.get();
    if (!demos::createPipelineLayout(device, {&ofSet, 1}, 0, layout, error) ||
        !demos::createPipeline(device, layout.get(), desc, pipeline, error) ||
        !demos::allocateSet(device, ofSet, sizes, pool, set, error) ||
        !demos::createSampler(device, {}, sampler, error) || !target.create(device, error))
        return false;
    demos::writeTexture(device, set, 0, cube.view.get(), sampler.get());
    return device.run(
        [&](VkCommandBuffer commands, demos::Error&) {
            target.begin(commands);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout.get(), 0, 1, &set, 0,
                                    nullptr);
            vkCmdDraw(commands, 3, 1, 0, 0);
            vkCmdEndRendering(commands);
            return true;
        },
        error);
}

} // namespace

void copyEdges(demos::Device& device, const demos::Image& cube) {
    if (!device.info().name.starts_with("SwiftShader")) return;
    demos::Error error;
    EXPECT_TRUE(bindToDraw(device, cube, error)) << error.text;
}

} // namespace tests
