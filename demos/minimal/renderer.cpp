#include "renderer.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "spirv/triangle.frag.h"
#include "spirv/triangle.vert.h"

namespace minimal {

void check(bool ok, const char* what) {
    if (ok) return;
    std::fprintf(stderr, "pond: %s failed\n", what);
    std::exit(1);
}

namespace {

uint32_t graphicsFamily(VkPhysicalDevice physical) {
    VkQueueFamilyProperties families[16];
    uint32_t count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families);
    for (uint32_t i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) return i;
    return 0;
}

VkDeviceMemory allocate(const Gpu& gpu, const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(gpu.physical, &memory);
    uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1u) ||
           (memory.memoryTypes[type].propertyFlags & wanted) != wanted)
        check(++type < memory.memoryTypeCount, "finding memory");
    const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
    VkDeviceMemory out = VK_NULL_HANDLE;
    check(vkAllocateMemory(gpu.device, &info, nullptr, &out) == VK_SUCCESS, "vkAllocateMemory");
    return out;
}

VkPipeline createPipeline(const Gpu& gpu, VkPipelineLayout layout) {
    VkPipelineShaderStageCreateInfo stages[2]{};
    VkShaderModuleCreateInfo code[2]{};
    code[0].codeSize = sizeof triangle_vert, code[0].pCode = triangle_vert;
    code[1].codeSize = sizeof triangle_frag, code[1].pCode = triangle_frag;
    for (int i = 0; i < 2; ++i) {
        code[i].sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        stages[i].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stages[i].stage = i == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
        stages[i].pName = "main";
        vkCreateShaderModule(gpu.device, &code[i], nullptr, &stages[i].module);
    }
    VkPipelineVertexInputStateCreateInfo none{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo list{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    list.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const VkViewport viewport{0, 0, size.width, size.height, 0, 1};
    const VkRect2D scissor{{0, 0}, size};
    const VkPipelineViewportStateCreateInfo viewports{
        VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, nullptr, 0, 1, &viewport, 1, &scissor};
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_GREATER; // reversed: nearer is greater
    VkPipelineColorBlendAttachmentState write{};
    write.colorWriteMask = 0xf;
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = 1;
    blend.pAttachments = &write;
    const VkPipelineRenderingCreateInfo formats{
        VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO, nullptr, 0, 1, &colorFormat, depthFormat};
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &formats, 0, 2,
                                      stages};
    info.pVertexInputState = &none;
    info.pInputAssemblyState = &list;
    info.pViewportState = &viewports;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(gpu.device, nullptr, 1, &info, nullptr, &pipeline) == VK_SUCCESS,
          "pipeline");
    for (const VkPipelineShaderStageCreateInfo& stage : stages)
        vkDestroyShaderModule(gpu.device, stage.module, nullptr);
    return pipeline;
}

float fromHalf(uint16_t half) {
    const int exponent = half >> 10 & 31, fraction = half & 1023;
    return std::ldexp(static_cast<float>(exponent ? 1024 + fraction : fraction),
                      (exponent ? exponent : 1) - 25);
}

void writePicture(const char* file, const uint16_t* halves) {
    std::FILE* out = std::fopen(file, "wb");
    check(out != nullptr, file);
    std::fprintf(out, "P6 %u %u 255\n", size.width, size.height);
    for (uint32_t i = 0; i < size.width * size.height; ++i)
        for (uint32_t c = 0; c < 3; ++c)
            std::fputc(
                static_cast<int>(255 * std::pow(std::fmin(fromHalf(halves[4 * i + c]), 1.0f), 1 / 2.2f)),
                out);
    check(std::fclose(out) == 0, file);
}

} // namespace

VkInstance createInstance() {
    VkApplicationInfo app{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    app.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &app;
    VkInstance instance = VK_NULL_HANDLE;
    check(vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS, "vkCreateInstance");
    return instance;
}

Gpu createGpu(VkInstance instance, VkPhysicalDevice physical, const VkPhysicalDeviceFeatures2& features) {
    Gpu gpu;
    gpu.instance = instance;
    gpu.physical = physical;
    gpu.family = graphicsFamily(physical);
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{
        VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, gpu.family, 1, &priority};
    VkDeviceCreateInfo device{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    device.queueCreateInfoCount = 1;
    device.pQueueCreateInfos = &queue;
    check(vkCreateDevice(physical, &device, nullptr, &gpu.device) == VK_SUCCESS, "vkCreateDevice");
    vkGetDeviceQueue(gpu.device, gpu.family, 0, &gpu.queue);
    const VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0, gpu.family};
    check(vkCreateCommandPool(gpu.device, &pool, nullptr, &gpu.pool) == VK_SUCCESS, "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr,
                                               gpu.pool, VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    check(vkAllocateCommandBuffers(gpu.device, &commands, &gpu.commands) == VK_SUCCESS, "command buffer");
    return gpu;
}

void destroyGpu(const Gpu& gpu) {
    vkDestroyCommandPool(gpu.device, gpu.pool, nullptr);
    vkDestroyDevice(gpu.device, nullptr);
    vkDestroyInstance(gpu.instance, nullptr);
}

Picture createPicture(const Gpu& gpu, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage) {
    Picture picture;
    if (format == depthFormat) picture.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    VkImageCreateInfo image{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    image.imageType = VK_IMAGE_TYPE_2D;
    image.format = format;
    image.extent = {extent.width, extent.height, 1};
    image.mipLevels = 1;
    image.arrayLayers = 1;
    image.samples = VK_SAMPLE_COUNT_1_BIT;
    image.usage = usage;
    check(vkCreateImage(gpu.device, &image, nullptr, &picture.image) == VK_SUCCESS, "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(gpu.device, picture.image, &needs);
    picture.memory = allocate(gpu, needs, 0);
    vkBindImageMemory(gpu.device, picture.image, picture.memory, 0);
    const VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     nullptr,
                                     0,
                                     picture.image,
                                     VK_IMAGE_VIEW_TYPE_2D,
                                     format,
                                     {},
                                     {picture.aspect, 0, 1, 0, 1}};
    check(vkCreateImageView(gpu.device, &view, nullptr, &picture.view) == VK_SUCCESS, "vkCreateImageView");
    return picture;
}

void destroyPicture(const Gpu& gpu, const Picture& picture) {
    vkDestroyImageView(gpu.device, picture.view, nullptr);
    vkDestroyImage(gpu.device, picture.image, nullptr);
    vkFreeMemory(gpu.device, picture.memory, nullptr);
}

void become(const Gpu& gpu, const Picture& picture, VkImageLayout from, VkImageLayout to) {
    const VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                        nullptr,
                                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                        VK_ACCESS_2_MEMORY_WRITE_BIT,
                                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                        VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                                        from,
                                        to,
                                        VK_QUEUE_FAMILY_IGNORED,
                                        VK_QUEUE_FAMILY_IGNORED,
                                        picture.image,
                                        {picture.aspect, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS}};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(gpu.commands, &dependency);
}

void copy(const Gpu& gpu, const Picture& from, const Picture& to) {
    become(gpu, from, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    become(gpu, to, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkImageCopy all{{from.aspect, 0, 0, 1}, {}, {to.aspect, 0, 0, 1}, {}, {size.width, size.height, 1}};
    vkCmdCopyImage(gpu.commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &all);
    become(gpu, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    become(gpu, to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

Triangle createTriangle(const Gpu& gpu) {
    Triangle triangle;
    const VkPushConstantRange camera{VK_SHADER_STAGE_VERTEX_BIT, 0, 16 * sizeof(float)};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &camera;
    check(vkCreatePipelineLayout(gpu.device, &info, nullptr, &triangle.layout) == VK_SUCCESS,
          "pipeline layout");
    triangle.pipeline = createPipeline(gpu, triangle.layout);
    return triangle;
}

void destroyTriangle(const Gpu& gpu, const Triangle& triangle) {
    vkDestroyPipeline(gpu.device, triangle.pipeline, nullptr);
    vkDestroyPipelineLayout(gpu.device, triangle.layout, nullptr);
}

void draw(const Gpu& gpu, const Triangle& triangle, const Camera& camera) {
    float clipFromWorld[16] = {};
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            for (int k = 0; k < 4; ++k)
                clipFromWorld[4 * c + r] +=
                    static_cast<float>(camera.projection[4 * k + r] * camera.view[4 * c + k]);
    vkCmdBindPipeline(gpu.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, triangle.pipeline);
    vkCmdPushConstants(gpu.commands, triangle.layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof clipFromWorld,
                       clipFromWorld);
    vkCmdDraw(gpu.commands, 3, 1, 0, 0);
}

void beginCommands(const Gpu& gpu) {
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(gpu.commands, &begin);
}

void beginPass(const Gpu& gpu, const Picture& color, const Picture& depth, VkAttachmentLoadOp load) {
    VkRenderingAttachmentInfo to[2]{};
    for (VkRenderingAttachmentInfo& attachment : to) {
        attachment.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        attachment.imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
        attachment.loadOp = load;
        attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    }
    to[0].imageView = color.view;
    to[0].clearValue.color = {{0.55f, 0.65f, 0.75f, 1}};
    to[1].imageView = depth.view;
    const VkRenderingInfo pass{
        VK_STRUCTURE_TYPE_RENDERING_INFO, nullptr, 0, {{0, 0}, size}, 1, 0, 1, &to[0], &to[1], nullptr};
    vkCmdBeginRendering(gpu.commands, &pass);
}

void finish(const Gpu& gpu, const Picture& color, const char* file) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = VkDeviceSize{8} * size.width * size.height;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(vkCreateBuffer(gpu.device, &info, nullptr, &buffer) == VK_SUCCESS, "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(gpu.device, buffer, &needs);
    const VkDeviceMemory memory =
        allocate(gpu, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    vkBindBufferMemory(gpu.device, buffer, memory, 0);

    become(gpu, color, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const VkBufferImageCopy all{0, 0, 0, {color.aspect, 0, 0, 1}, {}, {size.width, size.height, 1}};
    vkCmdCopyImageToBuffer(gpu.commands, color.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &all);
    const VkMemoryBarrier2 written{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2, nullptr,
                                   VK_PIPELINE_STAGE_2_COPY_BIT,       VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                   VK_PIPELINE_STAGE_2_HOST_BIT,       VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO, nullptr, 0, 1, &written};
    vkCmdPipelineBarrier2(gpu.commands, &dependency);
    vkEndCommandBuffer(gpu.commands);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &gpu.commands;
    check(vkQueueSubmit(gpu.queue, 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS, "vkQueueSubmit");
    check(vkDeviceWaitIdle(gpu.device) == VK_SUCCESS, "drawing");

    void* pixels = nullptr;
    check(vkMapMemory(gpu.device, memory, 0, VK_WHOLE_SIZE, 0, &pixels) == VK_SUCCESS, "vkMapMemory");
    writePicture(file, static_cast<const uint16_t*>(pixels));
    vkDestroyBuffer(gpu.device, buffer, nullptr);
    vkFreeMemory(gpu.device, memory, nullptr);
}

} // namespace minimal
