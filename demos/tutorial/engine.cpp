#include "engine.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "spirv/mesh.frag.h"
#include "spirv/mesh.vert.h"

void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    std::fprintf(stderr, "tutorial: %s failed: %d\n", what, result);
    std::exit(1);
}

Engine::Engine(VkExtent2D extent) : extent_(extent) {
    createDevice();
    createFrames();
    createScene();
    createSwapchain();
    renderPass_ = createRenderPass(true, true);
    createFramebuffers();
    createPipeline();
}

Engine::~Engine() {
    vkDeviceWaitIdle(device_);
    while (!deletions_.empty()) {
        deletions_.back()();
        deletions_.pop_back();
    }
}

void Engine::createDevice() {
    VkApplicationInfo app{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    app.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo instanceInfo{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    instanceInfo.pApplicationInfo = &app;
    check(vkCreateInstance(&instanceInfo, nullptr, &instance_), "vkCreateInstance");

    uint32_t count = 1; // the first device will do
    if (vkEnumeratePhysicalDevices(instance_, &count, &physical_) < 0 || count == 0)
        check(VK_ERROR_INITIALIZATION_FAILED, "finding a device");
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
    while (!(families.at(queueFamily_).queueFlags & VK_QUEUE_GRAPHICS_BIT)) ++queueFamily_;

    const float priority = 1;
    const VkDeviceQueueCreateInfo queueInfo{
        VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, queueFamily_, 1, &priority};
    VkDeviceCreateInfo deviceInfo{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    deviceInfo.queueCreateInfoCount = 1;
    deviceInfo.pQueueCreateInfos = &queueInfo;
    check(vkCreateDevice(physical_, &deviceInfo, nullptr, &device_), "vkCreateDevice");
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
    deletions_.push_back([this] {
        vkDestroyDevice(device_, nullptr);
        vkDestroyInstance(instance_, nullptr);
    });
}

// Without a window the swapchain is three images of our own; with one, vkCreateSwapchainKHR makes them, and
// acquiring and presenting are vkAcquireNextImageKHR and vkQueuePresentKHR with a semaphore each.
void Engine::createSwapchain() {
    for (int i = 0; i < 3; ++i)
        swapchain_.push_back(createImage(
            swapchainFormat, extent_, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT));
    depth_ = createImage(depthFormat, extent_, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

uint32_t Engine::acquireNextImage() {
    return frameNumber_ % static_cast<uint32_t>(swapchain_.size());
}

void Engine::present(uint32_t image) {
    presented_ = image;
}

VkRenderPass Engine::createRenderPass(bool first, bool last) {
    constexpr VkImageLayout colorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    constexpr VkImageLayout depthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    VkAttachmentDescription attachments[2]{};
    attachments[0].format = swapchainFormat;
    attachments[0].samples = VK_SAMPLE_COUNT_1_BIT;
    attachments[0].loadOp = first ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    attachments[0].storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachments[0].initialLayout = first ? VK_IMAGE_LAYOUT_UNDEFINED : colorLayout;
    attachments[0].finalLayout = last ? presentedLayout : colorLayout;
    attachments[1].format = depthFormat;
    attachments[1].samples = VK_SAMPLE_COUNT_1_BIT;
    attachments[1].loadOp = attachments[0].loadOp;
    attachments[1].storeOp = last ? VK_ATTACHMENT_STORE_OP_DONT_CARE : VK_ATTACHMENT_STORE_OP_STORE;
    attachments[1].initialLayout = first ? VK_IMAGE_LAYOUT_UNDEFINED : depthLayout;
    attachments[1].finalLayout = depthLayout;

    const VkAttachmentReference color{0, colorLayout};
    const VkAttachmentReference depth{1, depthLayout};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &color;
    subpass.pDepthStencilAttachment = &depth;

    // The frame before may still be drawing into the same depth.
    VkSubpassDependency dependency{};
    dependency.srcSubpass = VK_SUBPASS_EXTERNAL;
    dependency.srcStageMask = dependency.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                                        VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                                        VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    dependency.srcAccessMask =
        VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    dependency.dstAccessMask = dependency.srcAccessMask | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT |
                               VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;

    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 1;
    info.pDependencies = &dependency;
    VkRenderPass pass;
    check(vkCreateRenderPass(device_, &info, nullptr, &pass), "vkCreateRenderPass");
    deletions_.push_back([=] { vkDestroyRenderPass(device_, pass, nullptr); });
    return pass;
}

void Engine::createFramebuffers() {
    for (const AllocatedImage& image : swapchain_) {
        const VkImageView views[] = {image.view, depth_.view};
        VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        info.renderPass = renderPass_;
        info.attachmentCount = 2;
        info.pAttachments = views;
        info.width = extent_.width;
        info.height = extent_.height;
        info.layers = 1;
        VkFramebuffer framebuffer;
        check(vkCreateFramebuffer(device_, &info, nullptr, &framebuffer), "vkCreateFramebuffer");
        framebuffers_.push_back(framebuffer);
        deletions_.push_back([=] { vkDestroyFramebuffer(device_, framebuffer, nullptr); });
    }
}

void Engine::createFrames() {
    for (FrameData& frame : frames_) {
        const VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0,
                                           queueFamily_};
        check(vkCreateCommandPool(device_, &pool, nullptr, &frame.pool), "vkCreateCommandPool");
        const VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr,
                                                   frame.pool, VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
        check(vkAllocateCommandBuffers(device_, &commands, &frame.commands), "vkAllocateCommandBuffers");
        const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr,
                                      VK_FENCE_CREATE_SIGNALED_BIT};
        check(vkCreateFence(device_, &fence, nullptr, &frame.rendered), "vkCreateFence");
        deletions_.push_back([=] {
            vkDestroyFence(device_, frame.rendered, nullptr);
            vkDestroyCommandPool(device_, frame.pool, nullptr);
        });
    }
}

namespace {

struct MeshPush {
    glm::mat4 clipFromWorld;
    glm::vec4 toSun, sunLight, skyLight;
};

} // namespace

void Engine::createScene() {
    camera_ = lookAtCove(static_cast<float>(extent_.width) / static_cast<float>(extent_.height));
    for (const std::vector<Vertex>& vertices : buildTriangle()) {
        const size_t bytes = vertices.size() * sizeof(Vertex);
        const Mesh mesh{createBuffer(bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
                        static_cast<uint32_t>(vertices.size())};
        std::memcpy(map(mesh.vertices), vertices.data(), bytes);
        meshes_.push_back(mesh);
    }
}

void Engine::drawScene(VkCommandBuffer commands) {
    const MeshPush push{camera_.projection * camera_.view, glm::vec4(toSun, 0), glm::vec4(sunLight, 0),
                        glm::vec4(skyLight, 0)};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdPushConstants(commands, pipelineLayout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof push, &push);
    for (const Mesh& mesh : meshes_) {
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(commands, 0, 1, &mesh.vertices.buffer, &offset);
        vkCmdDraw(commands, mesh.vertexCount, 1, 0, 0);
    }
}

void Engine::createPipeline() {
    const VkPushConstantRange pushed{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(MeshPush)};
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.pushConstantRangeCount = 1;
    layoutInfo.pPushConstantRanges = &pushed;
    check(vkCreatePipelineLayout(device_, &layoutInfo, nullptr, &pipelineLayout_), "vkCreatePipelineLayout");

    VkPipelineShaderStageCreateInfo stages[2]{};
    for (int i = 0; i < 2; ++i) {
        VkShaderModuleCreateInfo module{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        module.codeSize = i == 0 ? sizeof mesh_vert : sizeof mesh_frag;
        module.pCode = i == 0 ? mesh_vert : mesh_frag;
        stages[i].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stages[i].stage = i == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
        stages[i].pName = "main";
        check(vkCreateShaderModule(device_, &module, nullptr, &stages[i].module), "vkCreateShaderModule");
    }
    const VkVertexInputBindingDescription binding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription attributes[] = {
        {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
        {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
        {2, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, color)}};
    VkPipelineVertexInputStateCreateInfo vertices{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    vertices.vertexBindingDescriptionCount = 1;
    vertices.pVertexBindingDescriptions = &binding;
    vertices.vertexAttributeDescriptionCount = 3;
    vertices.pVertexAttributeDescriptions = attributes;
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    const VkDynamicState dynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                   nullptr, 0, 2, dynamicStates};
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS;
    VkPipelineColorBlendAttachmentState opaque{};
    opaque.colorWriteMask = 0xf;
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = 1;
    blend.pAttachments = &opaque;

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, nullptr, 0, 2, stages};
    info.pVertexInputState = &vertices;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = pipelineLayout_;
    info.renderPass = renderPass_;
    check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), "a pipeline");
    for (const VkPipelineShaderStageCreateInfo& stage : stages)
        vkDestroyShaderModule(device_, stage.module, nullptr);
    deletions_.push_back([this] {
        vkDestroyPipeline(device_, pipeline_, nullptr);
        vkDestroyPipelineLayout(device_, pipelineLayout_, nullptr);
    });
}

void Engine::beginPass(VkCommandBuffer commands, VkRenderPass pass, uint32_t image) {
    VkClearValue clears[2]{};
    clears[0].color = {{0, 0, 0, 1}};
    clears[1].depthStencil.depth = 1;
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = pass;
    info.framebuffer = framebuffers_[image];
    info.renderArea.extent = extent_;
    info.clearValueCount = 2;
    info.pClearValues = clears;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    const VkViewport viewport{0, 0, static_cast<float>(extent_.width), static_cast<float>(extent_.height),
                              0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

void Engine::draw() {
    const FrameData& frame = frames_[frameNumber_ % framesInFlight];
    check(vkWaitForFences(device_, 1, &frame.rendered, VK_TRUE, UINT64_MAX), "vkWaitForFences");
    check(vkResetFences(device_, 1, &frame.rendered), "vkResetFences");
    check(vkResetCommandPool(device_, frame.pool, 0), "vkResetCommandPool");
    const uint32_t image = acquireNextImage();

    const VkCommandBuffer commands = frame.commands;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");

    beginPass(commands, renderPass_, image);
    drawScene(commands);
    vkCmdEndRenderPass(commands);

    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(queue_, 1, &submit, frame.rendered), "vkQueueSubmit");
    present(image);
    ++frameNumber_;
}

void Engine::savePicture(const char* file) {
    const size_t pixels = size_t{extent_.width} * extent_.height;
    const AllocatedBuffer buffer = createBuffer(4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    submitNow([&](VkCommandBuffer commands) {
        const AllocatedImage& from = swapchain_[presented_];
        transition(commands, from, presentedLayout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        const VkBufferImageCopy all{0, 0, 0, {from.aspect, 0, 0, 1}, {}, {extent_.width, extent_.height, 1}};
        vkCmdCopyImageToBuffer(commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer, 1,
                               &all);
        VkMemoryBarrier written{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
        written.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                             &written, 0, nullptr, 0, nullptr);
    });
    const auto* bgra = static_cast<const unsigned char*>(map(buffer));
    std::FILE* out = std::fopen(file, "wb");
    if (!out) check(VK_ERROR_UNKNOWN, file);
    std::fprintf(out, "P6 %u %u 255\n", extent_.width, extent_.height);
    for (size_t i = 0; i < 4 * pixels; i += 4)
        for (const size_t channel : {2, 1, 0}) std::fputc(bgra[i + channel], out);
    if (std::fclose(out) != 0) check(VK_ERROR_UNKNOWN, file);
}
