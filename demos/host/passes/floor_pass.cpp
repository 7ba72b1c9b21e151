#include "host/passes/floor_pass.h"

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"

#include "spirv/floor.comp.h"

namespace demos {

bool FloorPass::create(Device& device, VkExtent2D extent, Error& error) {
    return createImages(device, extent, error) && createSet(device, error) && createPipeline(device, error);
}

bool FloorPass::createImages(Device& device, VkExtent2D extent, Error& error) {
    for (size_t i = 0; i < 4; ++i) {
        ImageDesc desc;
        desc.format = i % 2 == 0 ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32_SFLOAT;
        desc.extent = extent;
        desc.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        if (!createImage(device, desc, images_[i], error)) return false;
    }
    // Filled, since memory that nobody has written yet may not be there to be read.
    return device.run(
        [&](VkCommandBuffer commands, Error&) {
            for (const Image& image : images_) {
                imageBarrier(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL, 0, 0,
                             VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
                const VkClearColorValue grey = {{0.5f, 0.5f, 0.5f, 1}};
                const VkImageSubresourceRange range = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
                vkCmdClearColorImage(commands, image.image.get(), VK_IMAGE_LAYOUT_GENERAL, &grey, 1, &range);
            }
            return true;
        },
        error);
}

bool FloorPass::createSet(const Device& device, Error& error) {
    constexpr VkDescriptorType image = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    constexpr VkDescriptorType types[] = {image, image, image, image};
    if (!createSetLayout(device, types, setLayout_, error, VK_SHADER_STAGE_COMPUTE_BIT)) return false;
    const VkDescriptorPoolSize size = {image, 4};
    if (!allocateSet(device, setLayout_.get(), {&size, 1}, pool_, set_, error)) return false;
    for (uint32_t i = 0; i < 4; ++i) {
        const VkDescriptorImageInfo bound = {VK_NULL_HANDLE, images_[i].view.get(), VK_IMAGE_LAYOUT_GENERAL};
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = set_;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = image;
        write.pImageInfo = &bound;
        vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
    }
    return true;
}

bool FloorPass::createPipeline(const Device& device, Error& error) {
    if (!createPipelineLayout(device, {&setLayout_.get(), 1}, 0, layout_, error)) return false;
    return createComputePipeline(device, floor_comp, layout_.get(), nullptr, pipeline_, error);
}

void FloorPass::record(VkCommandBuffer commands) const {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
    const VkExtent2D extent = images_[0].extent;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0, nullptr);
    vkCmdDispatch(commands, (extent.width + 7) / 8, (extent.height + 7) / 8, 1);
}

} // namespace demos
