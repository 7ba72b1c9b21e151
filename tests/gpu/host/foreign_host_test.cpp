// A host in the form of public tutorials and samples: a swapchain's UNORM image drawn to directly, with
// colour as displays take it, by a VkRenderPass with a depth and stencil attachment; GLM's matrices flipped
// in y, and depth from 0 to 1. Its picture is that of the same renderer in linear light.
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

#include "seaglass/glm.h"
#include "seaglass/record.h"
#include "seaglass/water.h"
#include "tests/gpu/host/cube_edges.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

constexpr VkExtent2D extent = {160, 90};
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT_S8_UINT;
constexpr VkImageAspectFlags depthAspects = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;

class Renderer {
  public:
    explicit Renderer(VkFormat format) : format_(format) {
        color_ = image(format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
        depth_ =
            image(depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
        constexpr VkImageUsageFlags copied = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
        colorCopy = image(format, copied);
        depthCopy = image(depthFormat, copied);
        scenePass_ = pass(VK_ATTACHMENT_LOAD_OP_CLEAR, VK_IMAGE_LAYOUT_UNDEFINED);
        waterPass = pass(VK_ATTACHMENT_LOAD_OP_LOAD, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        depthView_ = viewOf(depth_, depthAspects);
        const VkImageView views[] = {color_.view.get(), depthView_.get()};
        VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        info.renderPass = scenePass_.get();
        info.attachmentCount = 2;
        info.pAttachments = views;
        info.width = extent.width;
        info.height = extent.height;
        info.layers = 1;
        VkFramebuffer framebuffer = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateFramebuffer(device().handle(), &info, nullptr, &framebuffer), VK_SUCCESS);
        framebuffer_ = {device().handle(), framebuffer};
        demos::Error error;
        EXPECT_TRUE(demos::createBuffer(device(), VkDeviceSize{16} * extent.width * extent.height,
                                        VK_BUFFER_USAGE_TRANSFER_DST_BIT, demos::BufferPlace::readback,
                                        readback_, error))
            << error.text;
    }

    bool isEncoded() const { return format_ == VK_FORMAT_B8G8R8A8_UNORM; }

    /// A sky, and a wall that stands in the water.
    void drawScene(Context* context, VkCommandBuffer commands, float wallDepth) {
        begin(commands, scenePass_.get());
        VkClearAttachment wall[2] = {};
        wall[0].aspectMask = VK_IMAGE_ASPECT_COLOR_BIT;
        wall[0].clearValue = shade({0.5f, 0.2f, 0.1f});
        wall[1].aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
        wall[1].clearValue.depthStencil = {wallDepth, 0};
        const VkClearRect rect = {{{50, 15}, {60, 40}}, 0, 1};
        vkCmdClearAttachments(commands, 2, wall, 1, &rect);
        vkCmdEndRenderPass(commands);
        const SceneCopy copies[] = {{color_.image.get(), colorCopy.image.get(),
                                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT,
                                     extent},
                                    {depth_.image.get(), depthCopy.image.get(),
                                     VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, depthAspects, extent}};
        for (const SceneCopy& copy : copies) EXPECT_EQ(recordSceneCopy(context, commands, copy), Status::ok);
    }

    void begin(VkCommandBuffer commands, VkRenderPass pass) {
        VkClearValue clears[2] = {shade({0.3f, 0.5f, 0.8f}), {}};
        clears[1].depthStencil = {1, 0};
        VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
        info.renderPass = pass;
        info.framebuffer = framebuffer_.get();
        info.renderArea.extent = extent;
        info.clearValueCount = 2;
        info.pClearValues = clears;
        vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    }

    void present(VkCommandBuffer commands) {
        demos::imageBarrier(
            commands, color_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
            VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
            VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {extent.width, extent.height, 1};
        vkCmdCopyImageToBuffer(commands, color_.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               readback_.buffer.get(), 1, &region);
        demos::transferToHost(commands);
    }

    /// As a display shows it.
    glm::vec3 shown(size_t pixel) const {
        const auto* bytes = static_cast<const std::byte*>(readback_.mapped);
        if (isEncoded()) {
            uint32_t texel = 0;
            std::memcpy(&texel, bytes + pixel * sizeof texel, sizeof texel);
            const glm::vec4 bgra = glm::unpackUnorm4x8(texel);
            return {bgra.b, bgra.g, bgra.r};
        }
        uint64_t texel = 0;
        std::memcpy(&texel, bytes + pixel * sizeof texel, sizeof texel);
        return glm::convertLinearToSRGB(glm::vec3(glm::unpackHalf4x16(texel)));
    }

    demos::Image colorCopy, depthCopy;
    demos::Unique<VkRenderPass, &vkDestroyRenderPass> waterPass;

  private:
    static demos::Image image(VkFormat format, VkImageUsageFlags usage) {
        demos::ImageDesc desc;
        desc.format = format;
        desc.extent = extent;
        desc.usage = usage;
        demos::Image made;
        demos::Error error;
        EXPECT_TRUE(demos::createImage(device(), desc, made, error)) << error.text;
        return made;
    }

    static demos::UniqueImageView viewOf(const demos::Image& image, VkImageAspectFlags aspects) {
        VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        info.image = image.image.get();
        info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        info.format = image.format;
        info.subresourceRange = {aspects, 0, 1, 0, 1};
        VkImageView view = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateImageView(device().handle(), &info, nullptr, &view), VK_SUCCESS);
        return {device().handle(), view};
    }

    /// What its material shaders end with.
    VkClearValue shade(glm::vec3 linear) const {
        const glm::vec3 c = isEncoded() ? glm::convertLinearToSRGB(linear) : linear;
        VkClearValue value{};
        value.color = {{c.r, c.g, c.b, 1}};
        return value;
    }

    demos::Unique<VkRenderPass, &vkDestroyRenderPass> pass(VkAttachmentLoadOp load, VkImageLayout before) {
        VkAttachmentDescription attachments[2] = {};
        attachments[0].format = format_;
        attachments[0].finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        attachments[1].format = depthFormat;
        attachments[1].finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
        for (VkAttachmentDescription& each : attachments) {
            each.samples = VK_SAMPLE_COUNT_1_BIT;
            each.loadOp = each.stencilLoadOp = load;
            each.initialLayout = before == VK_IMAGE_LAYOUT_UNDEFINED ? before : each.finalLayout;
        }
        const VkAttachmentReference color = {0, attachments[0].finalLayout},
                                    depth = {1, attachments[1].finalLayout};
        VkSubpassDescription subpass{};
        subpass.colorAttachmentCount = 1;
        subpass.pColorAttachments = &color;
        subpass.pDepthStencilAttachment = &depth;
        VkSubpassDependency after{};
        after.srcSubpass = VK_SUBPASS_EXTERNAL;
        after.srcStageMask = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
        after.dstStageMask = VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT;
        after.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
        after.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
        VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
        info.attachmentCount = 2;
        info.pAttachments = attachments;
        info.subpassCount = 1;
        info.pSubpasses = &subpass;
        info.dependencyCount = 1;
        info.pDependencies = &after;
        VkRenderPass made = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateRenderPass(device().handle(), &info, nullptr, &made), VK_SUCCESS);
        return {device().handle(), made};
    }

    VkFormat format_;
    demos::Image color_, depth_;
    demos::UniqueImageView depthView_;
    demos::Unique<VkRenderPass, &vkDestroyRenderPass> scenePass_;
    demos::Unique<VkFramebuffer, &vkDestroyFramebuffer> framebuffer_;
    demos::Buffer readback_;
};

class ForeignHost : public GpuTest {
  protected:
    /// The water's part: what the renderer's own code gains.
    void drawFrame(Renderer& renderer, VkFormat format) {
        const Encoding encoding = renderer.isEncoded() ? Encoding::srgb : Encoding::linear;
        TargetDesc targetDesc;
        targetDesc.colorFormat = format;
        targetDesc.depthFormat = depthFormat;
        targetDesc.renderPass = renderer.waterPass.get();
        targetDesc.reversedDepth = false;
        targetDesc.encoding = encoding;
        Target* target = nullptr;
        ASSERT_EQ(createTarget(context(), &targetDesc, &target), Status::ok) << message();
        SeaDesc sea;
        sea.windSpeed = 4;
        sea.fetch = 1e3f;
        sea.samples = 64;
        const RefractionDesc refraction;
        const ReflectionDesc reflection;
        BodyDesc bodyDesc;
        bodyDesc.waves = &sea;
        bodyDesc.wavesOn = WavesOn::gpu;
        bodyDesc.refraction = &refraction;
        bodyDesc.reflection = &reflection;
        Body* body = nullptr;
        ASSERT_EQ(createBody(context(), &bodyDesc, &body), Status::ok) << message();

        glm::mat4 projection = glm::perspectiveRH_ZO(
            glm::radians(60.0f), float(extent.width) / float(extent.height), 0.1f, 256.0f);
        projection[1][1] *= -1;
        const glm::mat4 view = glm::lookAt(glm::vec3(0, 2, 8), glm::vec3(0, 0.5f, 0), glm::vec3(0, 1, 0));
        const glm::vec4 wall = projection * glm::vec4(0, 0, -10, 1);
        ViewDesc viewDesc = seaglass::viewDesc(view, projection, extent);
        constexpr VkImageLayout read = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        viewDesc.sceneColor = {renderer.colorCopy.view.get(), format, extent, read};
        viewDesc.sceneColor.encoding = encoding;
        viewDesc.sceneDepth = {renderer.depthCopy.view.get(), depthFormat, extent, read};
        demos::Image sky = cube();
        LightingDesc light = lightingDesc(glm::vec3(0, 0.8f, 0.6f), glm::vec3(0.5f), glm::vec3(0.4f));
        light.skyCube = sky.view.get();
        frame([&](VkCommandBuffer commands) {
            renderer.drawScene(context(), commands, wall.z / wall.w);
            EXPECT_EQ(simulate(commands, &body, 1, 3), Status::ok) << message();
            EXPECT_EQ(reflect(commands, &body, 1, &viewDesc), Status::ok) << message();
            EXPECT_EQ(seaglass::shade(commands, &body, 1, &viewDesc, &light), Status::ok) << message();
            renderer.begin(commands, renderer.waterPass.get());
            EXPECT_EQ(draw(commands, target, &body, 1, &viewDesc, &light), Status::ok) << message();
            vkCmdEndRenderPass(commands);
            renderer.present(commands);
        });
        destroyBody(body);
        destroyTarget(target);
        EXPECT_EQ(message(), "");
    }

  private:
    static demos::Image cube() {
        demos::ImageDesc desc;
        desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
        desc.cube = true;
        std::vector<float> faces;
        for (int face = 0; face < 6; ++face) faces.insert(faces.end(), {0.3f, 0.5f, 0.8f, 1});
        const std::span<const std::byte> level = std::as_bytes(std::span(faces));
        demos::Image made;
        demos::Error error;
        EXPECT_TRUE(demos::createSampledImage(device(), desc, {&level, 1}, made, error)) << error.text;
        copyEdges(device(), made);
        return made;
    }
};

TEST_F(ForeignHost, OfAnEncodedSwapchainShowsWhatALinearOneDoes) {
    Renderer display(VK_FORMAT_B8G8R8A8_UNORM), linear(VK_FORMAT_R16G16B16A16_SFLOAT);
    drawFrame(display, VK_FORMAT_B8G8R8A8_UNORM);
    drawFrame(linear, VK_FORMAT_R16G16B16A16_SFLOAT);
    size_t water = 0;
    float most = 0;
    for (size_t i = 0; i < size_t{extent.width} * extent.height; ++i) {
        const glm::vec3 off = glm::abs(display.shown(i) - linear.shown(i));
        most = std::max(most, std::max(off.x, std::max(off.y, off.z)));
        water += glm::distance(linear.shown(i), linear.shown(0)) > 0.05f; // the sky's
    }
    std::printf("%zu pixels are no sky, at most %.1f of 255 apart\n", water, double{255 * most});
    EXPECT_GT(water, 6000u);
    EXPECT_LT(most, 2.0f / 255);
}

} // namespace
