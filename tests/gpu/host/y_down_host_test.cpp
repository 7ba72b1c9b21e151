// A renderer in the form of a public one: a VkRenderPass, GLM's float matrices in a world whose y points
// down, as clip space's does, forward depth, no scene images and no sky's cube. What it adds for water is
// marked.
#include <array>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "seaglass/glm.h"
#include "seaglass/world.h"
#include "tests/gpu/rig/rig.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace tests;

constexpr VkFormat colorFormat = VK_FORMAT_R32G32B32A32_SFLOAT, depthFormat = VK_FORMAT_D32_SFLOAT;
constexpr uint32_t width = 256, height = 144;

VkAttachmentDescription cleared(VkFormat format, VkImageLayout after) {
    VkAttachmentDescription attachment{};
    attachment.format = format;
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    attachment.finalLayout = after;
    return attachment;
}

class YDownRenderer {
  public:
    YDownRenderer() {
        const std::array attachments = {
            cleared(colorFormat, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL),
            cleared(depthFormat, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL)};
        const VkAttachmentReference color = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
        const VkAttachmentReference depth = {1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
        VkSubpassDescription subpass{};
        subpass.colorAttachmentCount = 1;
        subpass.pColorAttachments = &color;
        subpass.pDepthStencilAttachment = &depth;
        VkSubpassDependency toShaders{};
        toShaders.dstSubpass = VK_SUBPASS_EXTERNAL;
        toShaders.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
        toShaders.dstStageMask = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
        toShaders.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
        toShaders.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT;
        VkRenderPassCreateInfo pass{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
        pass.attachmentCount = static_cast<uint32_t>(attachments.size());
        pass.pAttachments = attachments.data();
        pass.subpassCount = 1;
        pass.pSubpasses = &subpass;
        pass.dependencyCount = 1;
        pass.pDependencies = &toShaders;
        VkRenderPass made = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateRenderPass(device().handle(), &pass, nullptr, &made), VK_SUCCESS);
        renderPass_ = {device().handle(), made};
        create(colorFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, color_);
        create(depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, depth_);
        const std::array views = {color_.view.get(), depth_.view.get()};
        VkFramebufferCreateInfo framebuffer{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        framebuffer.renderPass = made;
        framebuffer.attachmentCount = static_cast<uint32_t>(views.size());
        framebuffer.pAttachments = views.data();
        framebuffer.width = width;
        framebuffer.height = height;
        framebuffer.layers = 1;
        VkFramebuffer target = VK_NULL_HANDLE;
        EXPECT_EQ(vkCreateFramebuffer(device().handle(), &framebuffer, nullptr, &target), VK_SUCCESS);
        framebuffer_ = {device().handle(), target};
    }

    VkRenderPass renderPass() const { return renderPass_.get(); }
    /// Negative is up.
    const glm::vec3 eye{3, -4, 7}, middle{3, -2, -3}, toSun{0.6f, -0.8f, 0};
    glm::mat4 view() const { return glm::lookAt(eye, middle, glm::vec3(0, 1, 0)); }
    glm::mat4 projection() const {
        return glm::perspectiveRH_ZO(glm::radians(50.0f), float{width} / float{height}, 0.1f, 2000.0f);
    }

    void beginPass(VkCommandBuffer commands) const {
        std::array<VkClearValue, 2> clears{};
        for (float& channel : clears[0].color.float32) channel = WaterPicture::untouched;
        clears[1].depthStencil.depth = 1;
        VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
        begin.renderPass = renderPass_.get();
        begin.framebuffer = framebuffer_.get();
        begin.renderArea.extent = {width, height};
        begin.clearValueCount = static_cast<uint32_t>(clears.size());
        begin.pClearValues = clears.data();
        vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    }
    std::vector<float> pixels() const { return download(color_.image.get(), colorFormat, {width, height}); }

  private:
    static void create(VkFormat format, VkImageUsageFlags usage, demos::Image& out) {
        demos::ImageDesc desc;
        desc.format = format;
        desc.extent = {width, height};
        desc.usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
        demos::Error error;
        EXPECT_TRUE(demos::createImage(device(), desc, out, error)) << error.text;
    }

    demos::Unique<VkRenderPass, &vkDestroyRenderPass> renderPass_;
    demos::Unique<VkFramebuffer, &vkDestroyFramebuffer> framebuffer_;
    demos::Image color_, depth_;
};

class YDownHost : public WaterTest {};

TEST_F(YDownHost, DrawsThePictureOfOneWithYUp) {
    const YDownRenderer renderer;
    // What it adds for water.
    const seaglass::SeaDesc breeze{.windSpeed = 8, .fetch = 50e3f, .samples = 64};
    const seaglass::RefractionDesc deep;
    seaglass::BodyDesc desc;
    desc.waves = &breeze;
    desc.wavesOn = seaglass::WavesOn::gpu;
    desc.refraction = &deep;
    seaglass::Body* water = makeBody(desc);
    seaglass::TargetDesc targetDesc;
    targetDesc.colorFormat = colorFormat;
    targetDesc.depthFormat = depthFormat;
    targetDesc.renderPass = renderer.renderPass();
    targetDesc.reversedDepth = false;
    seaglass::Target* target = nullptr;
    ASSERT_EQ(createTarget(context(), &targetDesc, &target), seaglass::Status::ok) << message();
    const seaglass::World world = {seaglass::WorldUp::minusY, true, 1, false};
    seaglass::ViewDesc view = seaglass::viewDesc(renderer.view(), renderer.projection(), {width, height});
    seaglass::LightingDesc light = seaglass::lightingDesc(renderer.toSun, glm::vec3(2.0f));
    worldFrom(world, &view);
    worldFrom(world, &light);
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(simulate(commands, &water, 1, 5), seaglass::Status::ok) << message();
        EXPECT_EQ(shade(commands, &water, 1, &view, &light), seaglass::Status::ok) << message();
        renderer.beginPass(commands);
        EXPECT_EQ(draw(commands, target, &water, 1, &view, &light), seaglass::Status::ok) << message();
        vkCmdEndRenderPass(commands);
    });
    const std::vector<float> drawn = renderer.pixels();
    destroyTarget(target);

    Camera camera;
    camera.eye = {3, 4, 7};
    camera.target = {3, 2, -3};
    camera.reversed = false;
    camera.far = 2000;
    camera.width = width;
    camera.height = height;
    useDepth(false);
    lighting = light;
    changeView = [](seaglass::ViewDesc& v) { v.sceneColor = v.sceneDepth = {}; };
    const WaterPicture ordinary = picture({water}, camera, 5);
    size_t covered = 0, apart = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
        const bool water1 = ordinary.color[i] != WaterPicture::untouched;
        covered += water1;
        apart += std::abs(drawn[i] - ordinary.color[i]) > 0.004f;
    }
    EXPECT_GT(covered, drawn.size() / 2);
    EXPECT_LT(apart, drawn.size() / 100);
}

} // namespace
