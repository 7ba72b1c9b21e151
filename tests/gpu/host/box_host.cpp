#include "tests/gpu/host/box_host.h"

#include <cstring>

#include <gtest/gtest.h>

#include "gpu/view/scene_formats.h"
#include "seaglass/record.h"
#include "spirv/boxes.frag.h"
#include "spirv/boxes.vert.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/rig.h"

namespace tests {

namespace {

constexpr VkImageLayout colorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout depthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;

struct Pushed {
    glm::mat4 clipFromWorld;
    glm::vec4 low, high;
};

void expectVk(VkResult result, const char* what) {
    EXPECT_EQ(result, VK_SUCCESS) << what;
}

VkAttachmentDescription attachment(VkFormat format, VkSampleCountFlagBits samples, VkImageLayout layout) {
    VkAttachmentDescription description{};
    description.format = format;
    description.samples = samples;
    description.loadOp = description.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    description.initialLayout = description.finalLayout = layout;
    return description;
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule module) {
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = which;
    info.module = module;
    info.pName = "main";
    return info;
}

demos::Unique<VkShaderModule, &vkDestroyShaderModule> moduleOf(std::span<const uint32_t> spirv) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = spirv.size_bytes();
    info.pCode = spirv.data();
    VkShaderModule module = VK_NULL_HANDLE;
    expectVk(vkCreateShaderModule(device().handle(), &info, nullptr, &module), "vkCreateShaderModule");
    return {device().handle(), module};
}

} // namespace

BoxHost::BoxHost(const seaglass::DrawnDesc& drawn, bool renderPass, std::vector<Box> boxes)
    : drawn_(drawn), boxes_(std::move(boxes)) {
    if (renderPass) {
        main_ = createPass(many());
        again_ = createPass(many() && drawn.samples.color == VK_SAMPLE_COUNT_1_BIT);
    }
    createPipeline();
}

BoxHost::Pass BoxHost::createPass(bool resolves) const {
    const VkAttachmentDescription attachments[] = {
        attachment(drawn_.colorFormat, drawn_.samples.depth, colorLayout),
        attachment(drawn_.depthFormat, drawn_.samples.depth, depthLayout),
        attachment(drawn_.colorFormat, VK_SAMPLE_COUNT_1_BIT, colorLayout)};
    const VkAttachmentReference color = {0, colorLayout}, depth = {1, depthLayout},
                                resolved = {2, colorLayout};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &color;
    subpass.pResolveAttachments = resolves ? &resolved : nullptr;
    subpass.pDepthStencilAttachment = &depth;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = resolves ? 3 : 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass made = VK_NULL_HANDLE;
    expectVk(vkCreateRenderPass(device().handle(), &info, nullptr, &made), "vkCreateRenderPass");
    return {device().handle(), made};
}

void BoxHost::createPipeline() {
    const VkPushConstantRange pushed = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(Pushed)};
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.pushConstantRangeCount = 1;
    layoutInfo.pPushConstantRanges = &pushed;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    expectVk(vkCreatePipelineLayout(device().handle(), &layoutInfo, nullptr, &layout), "layout");
    layout_ = {device().handle(), layout};

    const auto vertex = moduleOf(boxes_vert), fragment = moduleOf(boxes_frag);
    const VkPipelineShaderStageCreateInfo stages[] = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                                                      stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};
    const VkPipelineVertexInputStateCreateInfo input{
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo rasterization{
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    rasterization.cullMode = VK_CULL_MODE_BACK_BIT;
    rasterization.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo multisample{
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples = drawn_.samples.depth;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;
    VkPipelineColorBlendAttachmentState written{};
    written.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                             VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = 1;
    blend.pAttachments = &written;
    constexpr VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                         VK_DYNAMIC_STATE_FRONT_FACE};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = 3;
    dynamic.pDynamicStates = states;
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachmentFormats = &drawn_.colorFormat;
    rendering.depthAttachmentFormat = drawn_.depthFormat;
    if (seaglass::holdsStencil(drawn_.depthFormat)) rendering.stencilAttachmentFormat = drawn_.depthFormat;
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.pNext = main_ ? nullptr : &rendering;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &rasterization;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout;
    info.renderPass = main_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    expectVk(vkCreateGraphicsPipelines(device().handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
             "vkCreateGraphicsPipelines");
    pipeline_ = {device().handle(), pipeline};
}

demos::Image BoxHost::createImage(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples,
                                  VkImageUsageFlags usage) const {
    demos::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.samples = samples;
    desc.usage = usage;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createImage(device(), desc, image, error)) << error.text;
    return image;
}

void BoxHost::toAttachment(VkCommandBuffer commands, const demos::Image& image, VkImageLayout layout) const {
    demos::imageBarrier(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, layout, VK_PIPELINE_STAGE_2_NONE,
                        VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_ALL_GRAPHICS_BIT,
                        VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
}

void BoxHost::drawMain(VkCommandBuffer commands, const Camera& camera) {
    InUse inUse;
    const VkExtent2D extent = {camera.width, camera.height};
    inUse.color =
        createImage(drawn_.colorFormat, extent, drawn_.samples.depth, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    inUse.depth = createImage(drawn_.depthFormat, extent, drawn_.samples.depth,
                              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    toAttachment(commands, inUse.color, colorLayout);
    toAttachment(commands, inUse.depth, depthLayout);
    if (many()) {
        inUse.resolved = createImage(drawn_.colorFormat, extent, VK_SAMPLE_COUNT_1_BIT,
                                     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
        toAttachment(commands, inUse.resolved, colorLayout);
    }
    const Attachments into = {extent, inUse.color.view.get(), inUse.depth.view.get(),
                              inUse.resolved.view.get()};
    draw(commands, into, main_.get(), viewDesc(camera).viewport,
         projectionMatrix(camera) * viewMatrix(camera), camera.reversed ? 0.0f : 1.0f, false, inUse);
    inUse_.push_back(std::move(inUse));
}

void BoxHost::drawAgain(seaglass::Context* context, VkCommandBuffer commands,
                        const seaglass::PlanarView& view) {
    using seaglass::DrawnUse;
    InUse inUse;
    Attachments into = {view.extent, view.color, view.depth, VK_NULL_HANDLE};
    if (many() && view.samples.color == VK_SAMPLE_COUNT_1_BIT) {
        inUse.color = createImage(drawn_.colorFormat, view.extent, drawn_.samples.depth,
                                  VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
        toAttachment(commands, inUse.color, colorLayout);
        into.color = inUse.color.view.get();
        into.resolved = view.color;
    }
    EXPECT_EQ(seaglass::recordDrawnUse(context, commands, view, DrawnUse::sampled, DrawnUse::attached),
              seaglass::Status::ok);
    draw(commands, into, again_.get(), view.viewport, matrix(view.projection) * matrix(view.view),
         view.clearDepth, view.windingFlipped, inUse);
    inUse_.push_back(std::move(inUse));
}

void BoxHost::begin(VkCommandBuffer commands, const Attachments& into, VkRenderPass pass, float clearDepth,
                    InUse& inUse) const {
    VkClearValue clears[3] = {};
    clears[1].depthStencil.depth = clearDepth;
    if (pass) {
        const VkImageView views[] = {into.color, into.depth, into.resolved};
        VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        info.renderPass = pass;
        info.attachmentCount = into.resolved ? 3 : 2;
        info.pAttachments = views;
        info.width = into.extent.width;
        info.height = into.extent.height;
        info.layers = 1;
        VkFramebuffer framebuffer = VK_NULL_HANDLE;
        expectVk(vkCreateFramebuffer(device().handle(), &info, nullptr, &framebuffer), "vkCreateFramebuffer");
        inUse.framebuffer = {device().handle(), framebuffer};
        VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
        begin.renderPass = pass;
        begin.framebuffer = framebuffer;
        begin.renderArea.extent = into.extent;
        begin.clearValueCount = 3;
        begin.pClearValues = clears;
        vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
        return;
    }
    VkRenderingAttachmentInfo color{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    color.imageView = into.color;
    color.imageLayout = colorLayout;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    if (into.resolved) {
        color.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
        color.resolveImageView = into.resolved;
        color.resolveImageLayout = colorLayout;
    }
    VkRenderingAttachmentInfo depth = color;
    depth.imageView = into.depth;
    depth.imageLayout = depthLayout;
    depth.resolveMode = VK_RESOLVE_MODE_NONE;
    depth.clearValue = clears[1];
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea.extent = into.extent;
    info.layerCount = 1;
    info.colorAttachmentCount = 1;
    info.pColorAttachments = &color;
    info.pDepthAttachment = &depth;
    if (seaglass::holdsStencil(drawn_.depthFormat)) info.pStencilAttachment = &depth;
    vkCmdBeginRendering(commands, &info);
}

void BoxHost::draw(VkCommandBuffer commands, const Attachments& into, VkRenderPass pass,
                   const VkViewport& viewport, const glm::dmat4& clipFromWorld, float clearDepth,
                   bool mirrored, InUse& inUse) {
    begin(commands, into, pass, clearDepth, inUse);
    const VkRect2D area = {{0, 0}, into.extent};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    vkCmdSetFrontFace(commands, mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    for (const Box& box : boxes_) {
        const Pushed pushed = {glm::mat4(clipFromWorld), glm::vec4(box.low, 0), glm::vec4(box.high, 0)};
        vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof pushed, &pushed);
        vkCmdDraw(commands, 36, 1, 0, 0);
    }
    if (pass)
        vkCmdEndRenderPass(commands);
    else
        vkCmdEndRendering(commands);
}

} // namespace tests
