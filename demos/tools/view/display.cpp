#include "view/display.h"

#include <cmath>

#include "host/vulkan/rendering.h"
#include "spirv/display.frag.h"
#include "spirv/display.vert.h"

namespace demos {

namespace {

constexpr VkPipelineStageFlags2 colorOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 transfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 colorAccess =
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;

/// As in shaders/display.frag.
struct DisplayConstants {
    Tone tone;
    float scale;
};

} // namespace

Look lookOf(Aov aov, double exposureEv, double whiteHeightM) {
    switch (aov) {
    case Aov::height:
        return {Tone::signedGrey, static_cast<float>(whiteHeightM)};
    case Aov::normal:
        return {Tone::direction};
    case Aov::foam:
        return {Tone::grey};
    case Aov::color:
    case Aov::reflection:
    case Aov::scene:
        return {Tone::light, static_cast<float>(std::exp2(exposureEv))};
    default:
        return {Tone::asIs};
    }
}

bool Display::create(Device& device, Error& error) {
    device_ = &device;
    PipelineDesc desc;
    desc.vertex = display_vert;
    desc.fragment = display_frag;
    desc.meshVertices = false;
    desc.colorFormat = format;
    return drawing_.create(device, desc, sizeof(DisplayConstants), error);
}

bool Display::resize(VkExtent2D extent, Error& error) {
    if (image_.extent.width == extent.width && image_.extent.height == extent.height) return true;
    image_ = {};
    now_ = VK_IMAGE_LAYOUT_UNDEFINED;
    ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    return createImage(*device_, desc, image_, error);
}

void Display::show(VkCommandBuffer commands, const Image& picture, const Look& look, const VkRect2D& part) {
    imageBarrier(commands, picture, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                 VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
    showTexture(commands, picture, look, part);
}

void Display::showTexture(VkCommandBuffer commands, const Image& picture, const Look& look,
                          const VkRect2D& part) {
    imageBarrier(commands, image_, now_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, transfer | colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, colorOutput, colorAccess);
    now_ = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    drawing_.point(*device_, picture.view.get());

    beginRendering(commands, image_.extent, image_.view.get(), VK_ATTACHMENT_LOAD_OP_LOAD, VK_NULL_HANDLE,
                   VK_ATTACHMENT_LOAD_OP_DONT_CARE, 0);
    vkCmdSetScissor(commands, 0, 1, &part);
    drawing_.bind(commands);
    const DisplayConstants constants = {look.tone, look.scale};
    drawing_.push(commands, std::as_bytes(std::span(&constants, 1)));
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

void Display::finish(VkCommandBuffer commands) {
    imageBarrier(commands, image_, now_, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, transfer, VK_ACCESS_2_TRANSFER_READ_BIT);
    now_ = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
}

bool Display::read(std::vector<uint8_t>& rgb, Error& error) {
    const size_t pixels = size_t(image_.extent.width) * image_.extent.height;
    Buffer readback;
    if (!createBuffer(*device_, 4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::readback, readback,
                      error))
        return false;
    const bool copied = device_->run(
        [&](VkCommandBuffer commands, Error&) {
            VkBufferImageCopy copy{};
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            copy.imageExtent = {image_.extent.width, image_.extent.height, 1};
            vkCmdCopyImageToBuffer(commands, image_.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                   readback.buffer.get(), 1, &copy);
            transferToHost(commands);
            return true;
        },
        error);
    if (!copied) return false;
    const auto* const rgba = static_cast<const uint8_t*>(readback.mapped);
    rgb.resize(3 * pixels);
    for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = rgba[i / 3 * 4 + i % 3];
    return true;
}

} // namespace demos
