#include "reflection/interface/drawn_images.h"

#include "gpu/view/scene_formats.h"

namespace seaglass {

namespace {

bool isAttachedDepth(VkFormat format) {
    return holdsDepth(format) && format != VK_FORMAT_R16_UNORM && format != VK_FORMAT_R32_SFLOAT;
}

bool canBe(const gpu::Device& device, VkFormat format, VkFormatFeatureFlags attached) {
    const VkFormatFeatureFlags needed = attached | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    return (device.optimalFeatures(format) & needed) == needed;
}

bool holdsSamples(const gpu::Device& device, const DrawnDesc& drawn) {
    const VkPhysicalDeviceLimits& limits = device.limits();
    VkSampleCountFlags depth = limits.framebufferDepthSampleCounts & limits.sampledImageDepthSampleCounts;
    if (holdsStencil(drawn.depthFormat)) depth &= limits.framebufferStencilSampleCounts;
    VkSampleCountFlags color = limits.framebufferColorSampleCounts;
    if (drawn.samples.color != VK_SAMPLE_COUNT_1_BIT) color &= limits.sampledImageColorSampleCounts;
    return drawn.samples.depth & depth & color;
}

VkImageAspectFlags depthAspects(VkFormat format) {
    constexpr VkImageAspectFlags depth = VK_IMAGE_ASPECT_DEPTH_BIT;
    return holdsStencil(format) ? depth | VK_IMAGE_ASPECT_STENCIL_BIT : depth;
}

} // namespace

Status checkDrawn(const gpu::Device& device, const DrawnDesc& drawn, const char* owner) {
    const SceneSamples& samples = drawn.samples;
    if (!holdsColor(drawn.colorFormat))
        return device.fail(Status::invalidArgument,
                           "%s.drawn.colorFormat holds no colour that can be read, expected one of those of "
                           "ViewDesc.sceneColor.format",
                           owner);
    if (!isAttachedDepth(drawn.depthFormat))
        return device.fail(Status::invalidArgument,
                           "%s.drawn.depthFormat is no depth that can be read, expected D16_UNORM, "
                           "X8_D24_UNORM_PACK32 or D32_SFLOAT, with stencil or without",
                           owner);
    if (!hasSamplePlace(samples.depth))
        return device.fail(Status::invalidArgument, "%s.drawn.samples.depth is %u, expected 1, 2, 4, 8 or 16",
                           owner, static_cast<uint32_t>(samples.depth));
    if (samples.color != VK_SAMPLE_COUNT_1_BIT && samples.color != samples.depth)
        return device.fail(Status::invalidArgument,
                           "%s.drawn.samples.color is %u, expected 1 or that of samples.depth", owner,
                           static_cast<uint32_t>(samples.color));
    if (!canBe(device, drawn.colorFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT))
        return device.fail(Status::unsupported,
                           "%s.drawn.colorFormat is none that this device draws into and samples", owner);
    if (!canBe(device, drawn.depthFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
        return device.fail(Status::unsupported,
                           "%s.drawn.depthFormat is none that this device draws depth into and samples",
                           owner);
    if (!holdsSamples(device, drawn))
        return device.fail(Status::unsupported,
                           "%s.drawn.samples is more than this device draws into and samples", owner);
    return Status::ok;
}

gpu::ImageDesc drawnColorDesc(const DrawnDesc& drawn, VkExtent2D extent) {
    gpu::ImageDesc desc;
    desc.format = drawn.colorFormat;
    desc.extent = extent;
    desc.usage =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    desc.samples = drawn.samples.color;
    return desc;
}

gpu::ImageDesc drawnDepthDesc(const DrawnDesc& drawn, VkExtent2D extent) {
    gpu::ImageDesc desc;
    desc.format = drawn.depthFormat;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    // What is sampled; as an attachment a view has both aspects, whatever it says (Vulkan 1.3, 12.5).
    desc.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    desc.samples = drawn.samples.depth;
    return desc;
}

void setImages(const gpu::OwnedImage& color, const gpu::OwnedImage& depth, double farDepth, PlanarView& out) {
    out.extent = color.desc().extent;
    out.colorImage = color.handle();
    out.color = color.firstMipView();
    out.colorFormat = color.desc().format;
    out.depthImage = depth.handle();
    out.depth = depth.view();
    out.depthFormat = depth.desc().format;
    out.depthAspects = depthAspects(depth.desc().format);
    out.samples = {depth.desc().samples, color.desc().samples};
    out.clearDepth = static_cast<float>(farDepth);
}

VkImageMemoryBarrier2 colorDrawn(const gpu::OwnedImage& color, const gpu::Use& next) {
    return gpu::imageBarrier(color.handle(), gpu::drawnColor, next, 0, 1);
}

VkImageMemoryBarrier2 depthDrawn(const gpu::OwnedImage& depth) {
    VkImageMemoryBarrier2 barrier = gpu::imageBarrier(depth.handle(), gpu::drawnDepth, gpu::sampledByShaders);
    barrier.subresourceRange.aspectMask = depthAspects(depth.desc().format);
    return barrier;
}

} // namespace seaglass
