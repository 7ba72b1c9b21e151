// Memory, buffers, images, and commands that are waited for.
#include "engine.h"

VkDeviceMemory Engine::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
    for (uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
        if (!(needs.memoryTypeBits >> type & 1u)) continue;
        if ((memory.memoryTypes[type].propertyFlags & wanted) != wanted) continue;
        const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
        VkDeviceMemory out;
        check(vkAllocateMemory(device_, &info, nullptr, &out), "vkAllocateMemory");
        return out;
    }
    check(VK_ERROR_FEATURE_NOT_PRESENT, "finding memory");
    return VK_NULL_HANDLE;
}

AllocatedBuffer Engine::createBuffer(VkDeviceSize bytes, VkBufferUsageFlags usage) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes;
    info.usage = usage;
    AllocatedBuffer out;
    check(vkCreateBuffer(device_, &info, nullptr, &out.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device_, out.buffer, &needs);
    out.memory = allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(device_, out.buffer, out.memory, 0), "vkBindBufferMemory");
    deletions_.push_back([=] {
        vkDestroyBuffer(device_, out.buffer, nullptr);
        vkFreeMemory(device_, out.memory, nullptr);
    });
    return out;
}

void* Engine::map(const AllocatedBuffer& buffer) {
    void* mapped = nullptr;
    check(vkMapMemory(device_, buffer.memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    return mapped;
}

AllocatedImage Engine::createImage(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                                   uint32_t layers) {
    AllocatedImage out;
    out.layers = layers;
    if (format == depthFormat) out.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.flags = layers == 6 ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    check(vkCreateImage(device_, &info, nullptr, &out.image), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device_, out.image, &needs);
    out.memory = allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkBindImageMemory(device_, out.image, out.memory, 0), "vkBindImageMemory");
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = out.image;
    view.viewType = layers == 6 ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {out.aspect, 0, 1, 0, layers};
    check(vkCreateImageView(device_, &view, nullptr, &out.view), "vkCreateImageView");
    deletions_.push_back([=] {
        vkDestroyImageView(device_, out.view, nullptr);
        vkDestroyImage(device_, out.image, nullptr);
        vkFreeMemory(device_, out.memory, nullptr);
    });
    return out;
}

void Engine::submitNow(const std::function<void(VkCommandBuffer)>& record) {
    const FrameData& frame = frames_[frameNumber_ % framesInFlight];
    check(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle");
    check(vkResetCommandPool(device_, frame.pool, 0), "vkResetCommandPool");
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    check(vkBeginCommandBuffer(frame.commands, &begin), "vkBeginCommandBuffer");
    record(frame.commands);
    check(vkEndCommandBuffer(frame.commands), "vkEndCommandBuffer");
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &frame.commands;
    check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle");
}

void Engine::transition(VkCommandBuffer commands, const AllocatedImage& image, VkImageLayout from,
                        VkImageLayout to) {
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.image = image.image;
    barrier.subresourceRange = {image.aspect, 0, 1, 0, image.layers};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
                         0, nullptr, 0, nullptr, 1, &barrier);
}
