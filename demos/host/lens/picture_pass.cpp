#include "host/lens/picture_pass.h"

#include <vector>

#include "host/vulkan/frame_targets.h"
#include "host/vulkan/pipeline.h"
#include "host/vulkan/rendering.h"
#include "spirv/full_screen.vert.h"

namespace demos {

namespace {

constexpr VkPipelineStageFlags2 drawing = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 reading = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;

} // namespace

bool PicturePass::create(const Device& device, std::span<const uint32_t> fragment, uint32_t textures,
                         uint32_t constantBytes, bool blends, Error& error) {
    textures_ = textures;
    constantBytes_ = constantBytes;
    const std::vector<VkDescriptorType> types(textures, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    SamplerDesc nearest;
    nearest.larger = nearest.smaller = VK_FILTER_NEAREST;
    nearest.mips = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    PipelineDesc desc;
    desc.vertex = full_screen_vert;
    desc.fragment = fragment;
    desc.meshVertices = false;
    desc.blends = blends;
    desc.colorFormat = FrameTargets::colorFormat;
    desc.depthWrite = false;
    return createSampler(device, nearest, nearest_, error) && createSampler(device, {}, linear_, error) &&
           createSetLayout(device, types, setLayout_, error) &&
           createPipelineLayout(device, {&setLayout_.get(), 1}, constantBytes, layout_, error) &&
           createPipeline(device, layout_.get(), desc, pipeline_, error);
}

bool PicturePass::allocate(const Device& device, std::span<const VkImageView> pictures,
                           UniqueDescriptorPool& pool, VkDescriptorSet& set, Error& error) const {
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, textures_};
    if (!allocateSet(device, setLayout_.get(), {&size, 1}, pool, set, error)) return false;
    for (uint32_t i = 0; i < textures_; ++i)
        writeTexture(device, set, i, pictures[i], (i + 1 < textures_ ? nearest_ : linear_).get());
    return true;
}

void PicturePass::record(VkCommandBuffer commands, const Image& target, VkDescriptorSet set,
                         const void* constants) const {
    beginRendering(commands, target.extent, target.view.get(), VK_ATTACHMENT_LOAD_OP_LOAD, VK_NULL_HANDLE,
                   VK_ATTACHMENT_LOAD_OP_DONT_CARE, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, layout_.get(), drawStages, 0, constantBytes_, constants);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

void drawnToRead(VkCommandBuffer commands, const Image& image) {
    imageBarrier(commands, image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, drawing, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                 reading, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

void readToDrawn(VkCommandBuffer commands, const Image& image, VkImageLayout before) {
    imageBarrier(commands, image, before, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, reading | drawing, 0,
                 drawing, VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
}

bool createPicture(const Device& device, VkExtent2D extent, Image& out, Error& error) {
    ImageDesc desc;
    desc.format = FrameTargets::colorFormat;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    return createImage(device, desc, out, error);
}

} // namespace demos
