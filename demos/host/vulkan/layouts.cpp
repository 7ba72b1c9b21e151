#include "host/vulkan/layouts.h"

#include <iterator>

#include "host/files/mesh_file.h"

namespace demos {

bool createSetLayout(const Device& device, std::span<const VkDescriptorType> types,
                     UniqueDescriptorSetLayout& out, Error& error, VkShaderStageFlags stages) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (uint32_t i = 0; i < types.size(); ++i) bindings.push_back({i, types[i], 1, stages, nullptr});
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.bindingCount = static_cast<uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    if (!succeeded(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout),
                   "vkCreateDescriptorSetLayout", error))
        return false;
    out = UniqueDescriptorSetLayout(device.handle(), layout);
    return true;
}

bool createPipelineLayout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                          uint32_t constantBytes, UniquePipelineLayout& out, Error& error) {
    const VkPushConstantRange range = {drawStages, 0, constantBytes};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = static_cast<uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = constantBytes ? 1 : 0;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    if (!succeeded(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout), "vkCreatePipelineLayout",
                   error))
        return false;
    out = UniquePipelineLayout(device.handle(), layout);
    return true;
}

void setClip(const glm::dmat4& clipFromEye, FrameUniforms& uniforms) {
    uniforms.clipFromEye = glm::mat4(clipFromEye);
    uniforms.sight = {0, 0, 0, 1};
    const glm::dvec3 weight(clipFromEye[0][3], clipFromEye[1][3], clipFromEye[2][3]);
    if (weight != glm::dvec3(0)) return;
    const glm::dvec3 towards(glm::inverse(clipFromEye)[2]);
    uniforms.sight = glm::vec4(-glm::normalize(towards), 0);
}

bool createLayouts(const Device& device, Layouts& out, Error& error) {
    constexpr VkDescriptorType uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    constexpr VkDescriptorType texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    constexpr VkDescriptorType frame[] = {uniform, texture, texture, texture, texture, texture, storage};
    constexpr VkDescriptorType material[] = {texture, texture, texture, texture, texture};
    static_assert(std::size(material) == textureSlots);
    if (!createSetLayout(device, frame, out.frame, error) ||
        !createSetLayout(device, material, out.material, error))
        return false;
    const VkDescriptorSetLayout sets[] = {out.frame.get(), out.material.get()};
    return createPipelineLayout(device, sets, sizeof(DrawConstants), out.pipeline, error);
}

bool allocateSet(const Device& device, VkDescriptorSetLayout layout,
                 std::span<const VkDescriptorPoolSize> sizes, UniqueDescriptorPool& pool,
                 VkDescriptorSet& set, Error& error) {
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = static_cast<uint32_t>(sizes.size());
    poolInfo.pPoolSizes = sizes.data();
    VkDescriptorPool made = VK_NULL_HANDLE;
    if (!succeeded(vkCreateDescriptorPool(device.handle(), &poolInfo, nullptr, &made),
                   "vkCreateDescriptorPool", error))
        return false;
    pool = UniqueDescriptorPool(device.handle(), made);
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = made;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    return succeeded(vkAllocateDescriptorSets(device.handle(), &info, &set), "vkAllocateDescriptorSets",
                     error);
}

namespace {

void writeBuffer(const Device& device, VkDescriptorSet set, uint32_t binding, VkDescriptorType type,
                 VkBuffer buffer, VkDeviceSize size) {
    const VkDescriptorBufferInfo range = {buffer, 0, size};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type;
    write.pBufferInfo = &range;
    vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

} // namespace

void writeUniformBuffer(const Device& device, VkDescriptorSet set, VkBuffer buffer, VkDeviceSize size) {
    writeBuffer(device, set, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, buffer, size);
}

void writeStorageBuffer(const Device& device, VkDescriptorSet set, uint32_t binding, VkBuffer buffer,
                        VkDeviceSize size) {
    writeBuffer(device, set, binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffer, size);
}

void writeTexture(const Device& device, VkDescriptorSet set, uint32_t binding, VkImageView view,
                  VkSampler sampler) {
    const VkDescriptorImageInfo image = {sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

} // namespace demos
