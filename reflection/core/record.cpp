#include "seaglass/record.h"

#include "gpu/guard.h"
#include "gpu/memory/image.h"

namespace seaglass {

namespace {

using gpu::Use;

constexpr VkPipelineStageFlags2 shaders =
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 depthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

/// What shaders sampled last is to be overwritten.
constexpr Use lost = {shaders, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
constexpr Use sampled = {shaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
constexpr Use copied = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                        VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
constexpr Use colorAttached = {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                               VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                               VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr Use depthAttached = {depthTests,
                               VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                   VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                               VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
constexpr Use depthReadOnly = {
    shaders | depthTests, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};

VkImageMemoryBarrier2 barrierOf(VkImage image, VkImageAspectFlags aspects, const Use& before,
                                const Use& after) {
    VkImageMemoryBarrier2 barrier = gpu::imageBarrier(image, before, after, 0, 1);
    barrier.subresourceRange.aspectMask = aspects;
    return barrier;
}

const char* badField(VkCommandBuffer commands, const SceneCopy& copy) {
    if (!commands) return "commands is null";
    if (!copy.from) return "SceneCopy.from is null";
    if (!copy.to) return "SceneCopy.to is null";
    if (copy.layout == VK_IMAGE_LAYOUT_UNDEFINED) return "SceneCopy.layout is undefined";
    const VkImageAspectFlags depth = copy.aspect & ~VkImageAspectFlags{VK_IMAGE_ASPECT_STENCIL_BIT};
    if (depth != VK_IMAGE_ASPECT_DEPTH_BIT && copy.aspect != VK_IMAGE_ASPECT_COLOR_BIT)
        return "SceneCopy.aspect is neither colour nor depth";
    if (copy.extent.width == 0 || copy.extent.height == 0) return "SceneCopy.extent is empty";
    return nullptr;
}

Use colorOf(DrawnUse use) {
    return use == DrawnUse::sampled ? lost : colorAttached;
}

Use depthOf(DrawnUse use) {
    switch (use) {
    case DrawnUse::attached:
        return depthAttached;
    case DrawnUse::depthRead:
        return depthReadOnly;
    case DrawnUse::sampled:
        break;
    }
    return lost;
}

} // namespace

Status recordSceneCopy(Context* context, VkCommandBuffer commands, const SceneCopy& copy) {
    if (!context) return Status::invalidArgument;
    const gpu::Device& device = context->device;
    if (const char* bad = badField(commands, copy))
        return device.fail(Status::invalidArgument, "recordSceneCopy: %s", bad);

    Use drawn = copy.aspect == VK_IMAGE_ASPECT_COLOR_BIT ? colorAttached : depthAttached;
    drawn.layout = copy.layout;
    const VkImageMemoryBarrier2 before[] = {barrierOf(copy.from, copy.aspect, drawn, copied),
                                            barrierOf(copy.to, copy.aspect, lost, gpu::copyWritten)};
    gpu::recordBarriers(device, commands, before, 2);

    VkImageCopy region{};
    const VkImageAspectFlags kept = copy.aspect & ~VkImageAspectFlags{VK_IMAGE_ASPECT_STENCIL_BIT};
    region.srcSubresource = region.dstSubresource = {kept, 0, 0, 1};
    region.extent = {copy.extent.width, copy.extent.height, 1};
    device.vk().CmdCopyImage(commands, copy.from, copied.layout, copy.to, gpu::copyWritten.layout, 1,
                             &region);

    const VkImageMemoryBarrier2 after[] = {barrierOf(copy.from, copy.aspect, copied, drawn),
                                           barrierOf(copy.to, copy.aspect, gpu::copyWritten, sampled)};
    gpu::recordBarriers(device, commands, after, 2);
    return Status::ok;
}

Status recordDrawnUse(Context* context, VkCommandBuffer commands, const PlanarView& drawn, DrawnUse before,
                      DrawnUse after) {
    if (!context) return Status::invalidArgument;
    if (!commands || !drawn.colorImage || !drawn.depthImage)
        return context->device.fail(Status::invalidArgument, "recordDrawnUse: %s is null",
                                    !commands ? "commands" : "an image of PlanarView");
    const VkImageMemoryBarrier2 barriers[] = {
        barrierOf(drawn.colorImage, VK_IMAGE_ASPECT_COLOR_BIT, colorOf(before), colorOf(after)),
        barrierOf(drawn.depthImage, drawn.depthAspects, depthOf(before), depthOf(after))};
    gpu::recordBarriers(context->device, commands, barriers, 2);
    return Status::ok;
}

} // namespace seaglass
