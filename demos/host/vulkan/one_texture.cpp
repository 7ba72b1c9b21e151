#include "host/vulkan/one_texture.h"

namespace demos {

bool OneTexture::create(const Device& device, const PipelineDesc& desc, uint32_t constantBytes,
                        Error& error) {
    constexpr VkDescriptorType texture[] = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
    const VkDescriptorPoolSize size = {texture[0], 1};
    return createSampler(device, {}, sampler_, error) &&
           createSetLayout(device, texture, setLayout_, error) &&
           allocateSet(device, setLayout_.get(), {&size, 1}, pool_, set_, error) &&
           createPipelineLayout(device, {&setLayout_.get(), 1}, constantBytes, layout_, error) &&
           createPipeline(device, layout_.get(), desc, pipeline_, error);
}

void OneTexture::bind(VkCommandBuffer commands) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_, 0,
                            nullptr);
}

void OneTexture::push(VkCommandBuffer commands, std::span<const std::byte> constants) const {
    vkCmdPushConstants(commands, layout_.get(), drawStages, 0, static_cast<uint32_t>(constants.size()),
                       constants.data());
}

} // namespace demos
