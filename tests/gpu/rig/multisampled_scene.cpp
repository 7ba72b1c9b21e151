#include "tests/gpu/rig/multisampled_scene.h"

#include <algorithm>

#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"
#include "spirv/fill_sample.frag.h"
#include "spirv/fill_sample.vert.h"
#include "tests/gpu/rig/rig.h"

namespace tests {

namespace {

constexpr VkFormat colorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

/// Vulkan 1.3, 28.3: standard sample locations.
std::vector<glm::dvec2> samplePlaces(VkSampleCountFlagBits samples) {
    switch (samples) {
    case VK_SAMPLE_COUNT_2_BIT:
        return {{0.75, 0.75}, {0.25, 0.25}};
    case VK_SAMPLE_COUNT_4_BIT:
        return {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
    default:
        return {{0.5625, 0.3125}, {0.4375, 0.6875}, {0.8125, 0.5625}, {0.3125, 0.1875},
                {0.1875, 0.8125}, {0.0625, 0.4375}, {0.6875, 0.9375}, {0.9375, 0.0625}};
    }
}

TracedView tracedAt(Camera camera, const std::vector<Box>& boxes, const glm::dvec2& place) {
    camera.jitter += 0.5 - place;
    TracedView traced = Tracer(camera, boxes).run();
    for (size_t i = 0; i < traced.color.size(); i += 4)
        for (int axis = 0; axis < 2; ++axis)
            traced.color[i + static_cast<size_t>(axis)] +=
                static_cast<float>((place[axis] - 0.5) / (axis == 0 ? camera.width : camera.height));
    return traced;
}

demos::Image attachment(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples,
                        VkImageUsageFlags usage) {
    demos::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.samples = samples;
    desc.usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createImage(device(), desc, image, error)) << error.text;
    return image;
}

VkRenderingAttachmentInfo kept(const demos::Image& image) {
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = image.view.get();
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
}

/// Draws pictures into single samples.
class SampleFiller {
  public:
    SampleFiller() {
        constexpr VkDescriptorType types[] = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                              VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
        EXPECT_TRUE(demos::createSetLayout(device(), types, set_, error_)) << error_.text;
        const VkDescriptorSetLayout set = set_.get();
        VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        info.setLayoutCount = 1;
        info.pSetLayouts = &set;
        VkPipelineLayout layout = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreatePipelineLayout(device().handle(), &info, nullptr, &layout), VK_SUCCESS);
        layout_ = demos::UniquePipelineLayout(device().handle(), layout);
        EXPECT_TRUE(demos::createSampler(device(), {}, sampler_, error_)) << error_.text;
    }

    void fill(const MultisampledScene& scene, VkSampleCountFlagBits samples, uint32_t sample,
              const TracedView& with) {
        const demos::Image color = uploadFloats(with.width, with.height, 4, with.color);
        const demos::Image depth = uploadFloats(with.width, with.height, 1, with.depth);
        demos::PipelineDesc desc;
        desc.vertex = fill_sample_vert;
        desc.fragment = fill_sample_frag;
        desc.meshVertices = false;
        desc.colorFormat = colorFormat;
        desc.depthFormat = depthFormat;
        desc.depthCompare = VK_COMPARE_OP_ALWAYS;
        desc.samples = samples;
        desc.sampleMask = 1u << sample;
        demos::UniquePipeline pipeline;
        EXPECT_TRUE(demos::createPipeline(device(), layout_.get(), desc, pipeline, error_)) << error_.text;
        constexpr VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2}};
        demos::UniqueDescriptorPool pool;
        VkDescriptorSet set = VK_NULL_HANDLE;
        EXPECT_TRUE(demos::allocateSet(device(), set_.get(), sizes, pool, set, error_)) << error_.text;
        demos::writeTexture(device(), set, 0, color.view.get(), sampler_.get());
        demos::writeTexture(device(), set, 1, depth.view.get(), sampler_.get());
        EXPECT_TRUE(device().run(
            [&](VkCommandBuffer commands, demos::Error&) {
                record(commands, scene, sample, pipeline.get(), set);
                return true;
            },
            error_))
            << error_.text;
    }

  private:
    void record(VkCommandBuffer commands, const MultisampledScene& scene, uint32_t sample,
                VkPipeline pipeline, VkDescriptorSet set) const {
        const auto barrier = [&](const demos::Image& image, VkImageLayout from, VkImageLayout to) {
            demos::imageBarrier(commands, image, from, to, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                VK_ACCESS_2_MEMORY_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
        };
        const VkImageLayout before = sample == 0 ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_GENERAL;
        barrier(scene.color, before, VK_IMAGE_LAYOUT_GENERAL);
        barrier(scene.depth, before, VK_IMAGE_LAYOUT_GENERAL);
        const VkRenderingAttachmentInfo color = kept(scene.color), depth = kept(scene.depth);
        VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
        rendering.renderArea.extent = scene.color.extent;
        rendering.layerCount = 1;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachments = &color;
        rendering.pDepthAttachment = &depth;
        vkCmdBeginRendering(commands, &rendering);
        const VkViewport viewport = {
            0, 0, static_cast<float>(scene.color.extent.width), static_cast<float>(scene.color.extent.height),
            0, 1};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
        vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
        vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0,
                                nullptr);
        vkCmdDraw(commands, 3, 1, 0, 0);
        vkCmdEndRendering(commands);
        barrier(scene.color, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
        barrier(scene.depth, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
    }

    demos::Error error_;
    demos::UniqueDescriptorSetLayout set_;
    demos::UniquePipelineLayout layout_;
    demos::UniqueSampler sampler_;
};

bool canMultisample(VkFormat format, VkImageUsageFlags usage, VkSampleCountFlagBits samples) {
    VkImageFormatProperties properties{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        device().physical(), format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL,
        usage | VK_IMAGE_USAGE_SAMPLED_BIT, 0, &properties);
    return result == VK_SUCCESS && (properties.sampleCounts & samples);
}

} // namespace

bool canMultisample(VkSampleCountFlagBits samples) {
    return device().properties().limits.standardSampleLocations &&
           canMultisample(colorFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, samples) &&
           canMultisample(depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, samples);
}

MultisampledScene drawMultisampled(const Camera& camera, const std::vector<Box>& boxes,
                                   VkSampleCountFlagBits samples, const Radiances* radiances) {
    const VkExtent2D extent = {camera.width, camera.height};
    MultisampledScene scene;
    scene.color = attachment(colorFormat, extent, samples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    scene.depth = attachment(depthFormat, extent, samples, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    SampleFiller filler;
    std::vector<float> mean(size_t{extent.width} * extent.height * 4, 0.0f);
    scene.things.resize(size_t{extent.width} * extent.height);
    const std::vector<glm::dvec2> places = samplePlaces(samples);
    for (uint32_t i = 0; i < places.size(); ++i) {
        TracedView traced = tracedAt(camera, boxes, places[i]);
        for (size_t pixel = 0; pixel < traced.depth.size(); ++pixel) {
            const bool thing = traced.depth[pixel] != (camera.reversed ? 0.0f : 1.0f);
            scene.things[pixel] += thing;
            if (radiances)
                std::fill_n(&traced.color[pixel * 4], 3, thing ? radiances->things : radiances->nothing);
        }
        filler.fill(scene, samples, i, traced);
        for (size_t c = 0; c < mean.size(); ++c)
            mean[c] += traced.color[c] / static_cast<float>(places.size());
    }
    scene.resolved = uploadFloats(extent.width, extent.height, 4, mean);
    return scene;
}

} // namespace tests
