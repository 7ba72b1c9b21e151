#include "water/shading/found_surface.h"

#include <utility>

#include "spirv/found_surface.frag.h"
#include "spirv/motion.frag.h"

namespace seaglass {

namespace {

constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat asideFormat = VK_FORMAT_R32_UINT; // two of 16 bits
constexpr VkFormat motionFormat = VK_FORMAT_R32G32_SFLOAT;

constexpr gpu::Use depthDrawn = {
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};

gpu::ImageDesc depthDesc(VkExtent2D extent) {
    return {.format = depthFormat,
            .extent = extent,
            .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
            .aspect = VK_IMAGE_ASPECT_DEPTH_BIT};
}

gpu::ImageDesc besideDesc(VkFormat format, VkExtent2D extent) {
    return {.format = format,
            .extent = extent,
            .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
}

VkAttachmentDescription attachment(VkFormat format, VkImageLayout layout) {
    VkAttachmentDescription out{};
    out.format = format;
    out.samples = VK_SAMPLE_COUNT_1_BIT;
    out.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    out.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    out.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    out.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    out.initialLayout = out.finalLayout = layout;
    return out;
}

/// From the viewport's own corner on.
ViewDesc withoutOrigin(const ViewDesc& view, const ViewGeometry& geometry) {
    ViewDesc own = view;
    own.viewport.x -= static_cast<float>(geometry.regionOrigin.x);
    own.viewport.y -= static_cast<float>(geometry.regionOrigin.y);
    return own;
}

} // namespace

FoundVariant foundVariant(const SurfaceVariant& all) {
    SurfaceVariant v = shapeVariant(all);
    v.hasRefraction = all.hasRefraction;
    v.manySamples = all.manySamples;
    v.forMotion = all.forMotion;
    return {v};
}

Status buildPipeline(const gpu::Device& device, const TargetDesc& target, const FoundVariant& variant,
                     DrawPipeline& out) {
    const std::span<const uint32_t> fragment =
        variant.surface.forMotion ? motion_frag : std::span<const uint32_t>(found_surface_frag);
    return buildMeshPipeline(device, target, fragment, variant.surface, "found surface pipeline", out);
}

Status getFound(FoundPass& pass, const FoundVariant& variant, const DrawPipeline*& uncut,
                const DrawPipeline*& cut) {
    FoundVariant whole = variant;
    whole.surface.exclusionVolumes = 0;
    if (const Status s = pass.pipelines.get(whole, uncut); s != Status::ok) return s;
    return pass.pipelines.get(variant, cut);
}

FoundPass::~FoundPass() {
    if (device) device->vk().DestroyRenderPass(device->handle(), renderPass, device->allocator());
}

Status FoundPass::create(Context& context, VkFormat keptBeside) {
    device = &context.device;
    beside = keptBeside;
    if (!(device->optimalFeatures(depthFormat) & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
        return device->fail(Status::unsupported, "shade: this device draws no depth of D32_SFLOAT");
    const VkAttachmentDescription attachments[] = {
        attachment(beside, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL),
        attachment(depthFormat, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL)};
    const VkAttachmentReference color = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference depth = {1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &color;
    subpass.pDepthStencilAttachment = &depth;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    if (const Status s = device->made(
            device->vk().CreateRenderPass(device->handle(), &info, device->allocator(), &renderPass),
            VK_OBJECT_TYPE_RENDER_PASS, renderPass, "found surface");
        s != Status::ok)
        return s;
    TargetDesc target;
    target.colorFormat = beside;
    target.depthFormat = depthFormat;
    target.renderPass = renderPass;
    pipelines.init(*device, target);
    return Status::ok;
}

Status FoundPasses::create(Context& context) {
    if (const Status s = places.create(context, asideFormat); s != Status::ok) return s;
    return motion.create(context, motionFormat);
}

FoundSurface& FoundSurface::operator=(FoundSurface&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    depth_ = std::move(other.depth_);
    beside_ = std::move(other.beside_);
    framebuffer_ = std::exchange(other.framebuffer_, VK_NULL_HANDLE);
    return *this;
}

void FoundSurface::release() {
    if (!device_) return;
    device_->vk().DestroyFramebuffer(device_->handle(), framebuffer_, device_->allocator());
    device_ = nullptr;
    framebuffer_ = VK_NULL_HANDLE;
}

Status FoundSurface::create(const FoundPass& pass, VkExtent2D extent) {
    release();
    const gpu::Device& device = *pass.device;
    if (const Status s = depth_.create(device, depthDesc(extent), "found surface's depth"); s != Status::ok)
        return s;
    if (const Status s = beside_.create(device, besideDesc(pass.beside, extent), "found surface");
        s != Status::ok)
        return s;
    const VkImageView views[] = {beside_.view(), depth_.view()};
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = pass.renderPass;
    info.attachmentCount = 2;
    info.pAttachments = views;
    info.width = extent.width;
    info.height = extent.height;
    info.layers = 1;
    device_ = &device;
    return device.made(
        device.vk().CreateFramebuffer(device.handle(), &info, device.allocator(), &framebuffer_),
        VK_OBJECT_TYPE_FRAMEBUFFER, framebuffer_, "found surface");
}

bool FoundSurface::holds(VkExtent2D wanted) const {
    return framebuffer_ && extent().width >= wanted.width && extent().height >= wanted.height;
}

VkDeviceSize FoundSurface::bytes(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, depthDesc(extent)) +
           gpu::heldBytes(device, besideDesc(asideFormat, extent));
}

void FoundSurface::begin(VkCommandBuffer commands, const FoundPass& pass, VkExtent2D region) const {
    const gpu::Device& device = *pass.device;
    VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(beside_.handle(), gpu::discardedAfterSampling, gpu::drawnColor),
        gpu::imageBarrier(depth_.handle(), gpu::discardedAfterSampling, depthDrawn)};
    before[1].subresourceRange.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    gpu::recordBarriers(device, commands, before, 2);
    VkClearValue clear[2] = {}; // depth 0: nothing
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = pass.renderPass;
    info.framebuffer = framebuffer_;
    info.renderArea.extent = region;
    info.clearValueCount = 2;
    info.pClearValues = clear;
    device.vk().CmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
}

Status FoundSurface::record(Context& context, VkCommandBuffer commands, FoundPass& pass,
                            const FoundVariant& variant, const PlacedMesh& mesh, const Resources& resources,
                            const ViewDesc& view, const ViewGeometry& geometry) const {
    const gpu::Device& device = context.device;
    const DrawPipeline *uncut = nullptr, *cut = nullptr;
    if (const Status s = getFound(pass, variant, uncut, cut); s != Status::ok) return s;
    ViewGeometry own = geometry;
    own.regionOrigin = {0, 0};
    begin(commands, pass, extentOf(geometry));
    setViewport(device, commands, withoutOrigin(view, geometry), own);
    const InstancesDraw draws[] = {{uncut, {0, mesh.uncut}},
                                   {cut, {mesh.uncut, mesh.instanceCount - mesh.uncut}}};
    const Status drawn = recordSurface(context, commands, draws, mesh, resources, view.viewIndex);
    device.vk().CmdEndRenderPass(commands);
    VkImageMemoryBarrier2 after[] = {
        gpu::imageBarrier(beside_.handle(), gpu::drawnColor, gpu::sampledByShaders),
        gpu::imageBarrier(depth_.handle(), depthDrawn, gpu::sampledByShaders)};
    after[1].subresourceRange.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    gpu::recordBarriers(device, commands, after, 2);
    return drawn;
}

} // namespace seaglass
