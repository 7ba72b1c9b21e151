#include "tests/gpu/host/host_shape.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>

#include "host/scene_again.h"
#include "host/seaglass_view.h"
#include "seaglass/record.h"
#include "tests/gpu/host/cube_edges.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/multisampled_scene.h"
#include "tests/gpu/rig/rig.h"
#include "tests/gpu/rig/scene_images.h"
#include "tests/gpu/rig/traced_scene.h"

namespace tests {

namespace {

using seaglass::Status;

/// Views of a multiview pass.
constexpr uint32_t viewsAtOnce = 2;
/// What is farther ahead is hidden: a test of depth in every convention.
constexpr double hiddenFrom = 20;

void expectVk(VkResult result, const char* what) {
    EXPECT_EQ(result, VK_SUCCESS) << what;
}

bool holdsStencil(VkFormat format) {
    return format == VK_FORMAT_D16_UNORM_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT ||
           format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

size_t texelBytes(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R32G32B32A32_SFLOAT:
        return 16;
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return 8;
    default:
        return 4;
    }
}

glm::vec4 decoded(VkFormat format, const std::byte* texel) {
    const auto as = [&]<typename T>(T value) {
        std::memcpy(&value, texel, sizeof value);
        return value;
    };
    switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return glm::unpackHalf4x16(as(uint64_t{}));
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
        return {glm::unpackF2x11_1x10(as(uint32_t{})), 1};
    case VK_FORMAT_R8G8B8A8_UNORM:
        return glm::unpackUnorm4x8(as(uint32_t{}));
    default:
        return as(glm::vec4{});
    }
}

demos::Image uploaded(demos::Device& device, VkFormat format, VkExtent2D extent, bool cube,
                      const std::vector<float>& values) {
    demos::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.cube = cube;
    const std::span<const std::byte> level = std::as_bytes(std::span(values));
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device, desc, {&level, 1}, image, error)) << error.text;
    if (cube) copyEdges(device, image);
    return image;
}

bool sameCamera(const Camera& a, const Camera& b) {
    return viewMatrix(a) == viewMatrix(b) && projectionMatrix(a) == projectionMatrix(b) &&
           a.width == b.width && a.height == b.height;
}

/// What the host's depth buffer holds of something so far ahead.
float depthOf(const Camera& camera, double ahead) {
    const glm::dvec4 clip = projectionMatrix(camera) * glm::dvec4(0, 0, -ahead, 1);
    return static_cast<float>(clip.z / clip.w);
}

VkImageMemoryBarrier2 toLayout(VkImage image, VkImageAspectFlags aspect, VkImageLayout from,
                               VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS};
    return barrier;
}

void recordBarrier(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

constexpr VkImageLayout colorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout depthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;

/// A background that every format of colour holds.
VkClearValue background(seaglass::Encoding encoding) {
    glm::vec3 color(0.25f, 0.5f, 1);
    if (encoding == seaglass::Encoding::srgb) color = glm::convertLinearToSRGB(color);
    VkClearValue value{};
    value.color = {{color.r, color.g, color.b, 1}};
    return value;
}

demos::Image emptyImage(const demos::Device& device, VkFormat format, VkExtent2D extent,
                        VkImageUsageFlags usage) {
    demos::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.usage = usage;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createImage(device, desc, image, error)) << error.text;
    return image;
}

VkClearValue clearOf(float depth) {
    VkClearValue value{};
    value.depthStencil.depth = depth;
    return value;
}

VkAttachmentDescription2 described(VkFormat format, VkSampleCountFlagBits samples, VkImageLayout layout) {
    VkAttachmentDescription2 description{VK_STRUCTURE_TYPE_ATTACHMENT_DESCRIPTION_2};
    description.format = format;
    description.samples = samples;
    description.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    description.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    description.stencilStoreOp = VK_ATTACHMENT_STORE_OP_STORE;
    description.initialLayout = description.finalLayout = layout;
    return description;
}

} // namespace

bool canDraw(const HostShape& shape) {
    const auto has = [](VkFormat format, VkFormatFeatureFlags needed) {
        VkFormatProperties properties{};
        vkGetPhysicalDeviceFormatProperties(device().physical(), format, &properties);
        return (properties.optimalTilingFeatures & needed) == needed;
    };
    const VkPhysicalDeviceLimits& limits = device().properties().limits;
    if (shape.resolvesScene && !canMultisample(VK_SAMPLE_COUNT_4_BIT)) return false;
    return has(shape.color, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) &&
           has(shape.depth, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) &&
           (limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts & shape.samples);
}

Picture displayed(const Picture& linear) {
    Picture encoded;
    for (size_t i = 0; i < linear.size(); i += 4) {
        const glm::vec3 c = glm::convertLinearToSRGB(glm::vec3(linear[i], linear[i + 1], linear[i + 2]));
        encoded.insert(encoded.end(), {c.r, c.g, c.b, linear[i + 3]});
    }
    return encoded;
}

Camera shoreCamera() {
    Camera camera;
    camera.eye = {-1, 2.2, 9};
    camera.target = {-0.5, 0.4, 0};
    camera.width = 200;
    camera.height = 112;
    return camera;
}

ShapedHost::ShapedHost(demos::Device& device, const HostShape& shape, bool reversedDepth,
                       const std::function<void(seaglass::DeviceDesc&)>& change,
                       const std::function<void(seaglass::BodyDesc&)>& changeBody)
    : device_(device), shape_(shape) {
    seaglass::DeviceDesc desc;
    desc.instance = device.instance();
    desc.physicalDevice = device.physical();
    desc.device = device.handle();
    desc.getInstanceProcAddr = spiedGetInstanceProcAddr;
    desc.framesInFlight = 4;
    desc.message = {[](void* user, const char* text) { *static_cast<std::string*>(user) = text; }, &message_};
    if (change) change(desc);
    EXPECT_EQ(seaglass::createContext(&desc, &context_), Status::ok) << message_;
    if (!context_) return;
    createLight();
    if (shape_.renderPass) createRenderPass();
    createWater(reversedDepth, changeBody);
    for (Slot& slot : slots_) {
        VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        poolInfo.queueFamilyIndex = device.queueFamily();
        VkCommandPool pool = VK_NULL_HANDLE;
        expectVk(vkCreateCommandPool(device.handle(), &poolInfo, nullptr, &pool), "vkCreateCommandPool");
        slot.pool = {device.handle(), pool};
        VkCommandBufferAllocateInfo buffers{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        buffers.commandPool = pool;
        buffers.commandBufferCount = 1;
        expectVk(vkAllocateCommandBuffers(device.handle(), &buffers, &slot.primary), "primary");
        slot.secondaries.resize(4);
        buffers.level = VK_COMMAND_BUFFER_LEVEL_SECONDARY;
        buffers.commandBufferCount = 4;
        expectVk(vkAllocateCommandBuffers(device.handle(), &buffers, slot.secondaries.data()), "secondaries");
        const VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
        VkFence fence = VK_NULL_HANDLE;
        expectVk(vkCreateFence(device.handle(), &fenceInfo, nullptr, &fence), "vkCreateFence");
        slot.fence = {device.handle(), fence};
    }
}

ShapedHost::~ShapedHost() {
    vkDeviceWaitIdle(device_.handle());
    seaglass::destroyBody(body_);
    seaglass::destroyTarget(target_);
    seaglass::destroyContext(context_);
}

void ShapedHost::createLight() {
    std::vector<float> faces;
    for (int face = 0; face < 6; ++face) faces.insert(faces.end(), {0.3f, 0.5f, 0.8f, 1});
    skyCube_ = uploaded(device_, VK_FORMAT_R32G32B32A32_SFLOAT, {1, 1}, true, faces);
    if (shape_.skyCube) lighting_.skyCube = skyCube_.view.get();
    for (float(*color)[3] : {&lighting_.skyZenith, &lighting_.skyHorizon, &lighting_.skyGround})
        std::copy_n(faces.begin(), 3, *color);
    const glm::dvec3 toSun = glm::normalize(toHost(shape_.world, {0.6, 0.8, 0}));
    for (int i = 0; i < 3; ++i) lighting_.toSun[i] = toSun[i];
    worldFrom(shape_.world.world, &lighting_);
    for (float& value : lighting_.sunIrradiance) value = 0.5f;
    for (float& value : lighting_.skyIrradiance) value = 0.5f;
    if (shape_.sunShadow) createSunShadow();
    fog_.shape = seaglass::FogShape::height;
    fog_.fromSky = 0.5f;
    if (shape_.fog) lighting_.fog = &fog_;
}

void ShapedHost::createSunShadow() {
    constexpr uint32_t size = 8;
    const std::vector<float> farthest(size * size, 1);
    shadowMap_ = uploaded(device_, VK_FORMAT_R32_SFLOAT, {size, size}, false, farthest);
    demos::Error error;
    EXPECT_TRUE(demos::createArrayView(device_, shadowMap_, shadowView_, error)) << error.text;
    sunShadow_.map = {shadowView_.get(), shadowMap_.format, shadowMap_.extent,
                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    double(&middle)[16] = sunShadow_.textureFromWorld[0]; // of all points
    middle[12] = middle[13] = middle[14] = 0.5;
    middle[15] = 1;
    lighting_.shadow = &sunShadow_;
}

void ShapedHost::createWater(bool reversedDepth, const std::function<void(seaglass::BodyDesc&)>& change) {
    seaglass::TargetDesc targetDesc;
    targetDesc.colorFormat = shape_.color;
    targetDesc.depthFormat = shape_.depth;
    if (shape_.stencilAttached && !shape_.renderPass) targetDesc.stencilFormat = shape_.depth;
    targetDesc.samples = shape_.samples;
    targetDesc.reversedDepth = reversedDepth;
    targetDesc.depthWrite = shape_.depthWrite;
    targetDesc.renderPass = renderPass_.get();
    targetDesc.viewMask = viewMask(viewsAtOnce);
    targetDesc.encoding = shape_.encoding;
    EXPECT_EQ(seaglass::createTarget(context_, &targetDesc, &target_), Status::ok) << message_;

    seaglass::SeaDesc sea;
    sea.windSpeed = 7;
    sea.fetch = 3e3f;
    sea.samples = 64;
    sea.seed = 3;
    const seaglass::FoamDesc foam;
    const seaglass::RefractionDesc refraction;
    const seaglass::ReflectionDesc reflection;
    seaglass::BodyDesc desc;
    desc.waves = &sea;
    desc.wavesOn = seaglass::WavesOn::gpu;
    desc.foam = &foam;
    desc.refraction = &refraction;
    desc.reflection = &reflection;
    if (change) change(desc);
    caustics_ = desc.caustics;
    bed_ = desc.bed;
    EXPECT_EQ(seaglass::createBody(context_, &desc, &body_), Status::ok) << message_;
}

void ShapedHost::createRenderPass() {
    const bool many = shape_.samples != VK_SAMPLE_COUNT_1_BIT;
    const VkAttachmentDescription2 attachments[] = {
        described(shape_.color, shape_.samples, colorLayout),
        described(shape_.depth, shape_.samples, depthLayout),
        described(shape_.color, VK_SAMPLE_COUNT_1_BIT, colorLayout),
    };
    const auto reference = [](uint32_t attachment, VkImageLayout layout, VkImageAspectFlags aspect) {
        return VkAttachmentReference2{VK_STRUCTURE_TYPE_ATTACHMENT_REFERENCE_2, nullptr, attachment, layout,
                                      aspect};
    };
    const VkAttachmentReference2 color = reference(0, colorLayout, VK_IMAGE_ASPECT_COLOR_BIT);
    const VkAttachmentReference2 depth = reference(1, depthLayout, VK_IMAGE_ASPECT_DEPTH_BIT);
    const VkAttachmentReference2 resolve = reference(2, colorLayout, VK_IMAGE_ASPECT_COLOR_BIT);
    VkSubpassDescription2 subpass{VK_STRUCTURE_TYPE_SUBPASS_DESCRIPTION_2};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.viewMask = viewMask(viewsAtOnce);
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &color;
    subpass.pResolveAttachments = many ? &resolve : nullptr;
    subpass.pDepthStencilAttachment = &depth;
    VkRenderPassCreateInfo2 info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO_2};
    info.attachmentCount = many ? 3 : 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass made = VK_NULL_HANDLE;
    expectVk(vkCreateRenderPass2(device_.handle(), &info, nullptr, &made), "vkCreateRenderPass2");
    renderPass_ = {device_.handle(), made};
}

ShapedHost::Attachment ShapedHost::createAttachment(VkFormat format, VkExtent2D extent, uint32_t layers,
                                                    VkSampleCountFlagBits samples, VkImageUsageFlags usage) {
    const bool color = usage & VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    Attachment made;
    made.aspect = color ? VK_IMAGE_ASPECT_COLOR_BIT : VK_IMAGE_ASPECT_DEPTH_BIT;
    if (!color && holdsStencil(format)) made.aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = layers;
    info.samples = samples;
    info.usage = usage;
    VkImage image = VK_NULL_HANDLE;
    expectVk(vkCreateImage(device_.handle(), &info, nullptr, &image), "vkCreateImage");
    made.image = {device_.handle(), image};
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device_.handle(), image, &needs);
    VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex =
        device_.memoryType(needs.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    expectVk(vkAllocateMemory(device_.handle(), &allocation, nullptr, &memory), "vkAllocateMemory");
    made.memory = {device_.handle(), memory};
    expectVk(vkBindImageMemory(device_.handle(), image, memory, 0), "vkBindImageMemory");
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image;
    view.viewType = layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {made.aspect, 0, 1, 0, layers};
    VkImageView handle = VK_NULL_HANDLE;
    expectVk(vkCreateImageView(device_.handle(), &view, nullptr, &handle), "vkCreateImageView");
    made.view = {device_.handle(), handle};
    return made;
}

ShapedHost::Targets ShapedHost::createTargets(VkExtent2D extent, uint32_t layers) {
    Targets targets;
    targets.extent = extent;
    targets.layers = layers;
    const bool many = shape_.samples != VK_SAMPLE_COUNT_1_BIT;
    targets.color = createAttachment(shape_.color, extent, layers, VK_SAMPLE_COUNT_1_BIT,
                                     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    targets.depth = createAttachment(shape_.depth, extent, layers, shape_.samples,
                                     VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    if (many)
        targets.manyColors = createAttachment(shape_.color, extent, layers, shape_.samples,
                                              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    demos::Error error;
    EXPECT_TRUE(demos::createBuffer(device_, texelBytes(shape_.color) * extent.width * extent.height * layers,
                                    VK_BUFFER_USAGE_TRANSFER_DST_BIT, demos::BufferPlace::readback,
                                    targets.readback, error))
        << error.text;
    if (!shape_.renderPass) return targets;
    const VkImageView views[] = {many ? targets.manyColors.view.get() : targets.color.view.get(),
                                 targets.depth.view.get(), targets.color.view.get()};
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = renderPass_.get();
    info.attachmentCount = many ? 3 : 2;
    info.pAttachments = views;
    info.width = extent.width;
    info.height = extent.height;
    info.layers = 1; // of a multiview pass too
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    expectVk(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffer), "vkCreateFramebuffer");
    targets.framebuffer = {device_.handle(), framebuffer};
    return targets;
}

const ShapedHost::Scene& ShapedHost::sceneOf(const Camera& camera) {
    for (const auto& scene : scenes_)
        if (sameCamera(scene->camera, camera)) return *scene;
    std::vector<Box> boxes = harbourOfBoxes();
    boxes.push_back({{-60, -2.5, -100}, {60, -2, 40}}); // a bed
    TracedView traced = Tracer(camera, boxes).run();
    if (shape_.scene == SceneGiven::nothing) {
        std::ranges::fill(traced.color, 0.0f);
        std::ranges::fill(traced.depth, camera.reversed ? 0.0f : 1.0f);
    }
    auto made = std::make_unique<Scene>();
    made->camera = camera;
    const VkExtent2D extent = {camera.width, camera.height};
    if (shape_.resolvesScene) {
        MultisampledScene many = drawMultisampled(camera, boxes, VK_SAMPLE_COUNT_4_BIT);
        made->color = std::move(many.resolved);
        made->depth = std::move(many.depth);
        return *scenes_.emplace_back(std::move(made));
    }
    if (shape_.encoding == seaglass::Encoding::srgb)
        made->color = uploadColor(shape_.color, extent, displayed(traced.color));
    else
        made->color = uploaded(device_, VK_FORMAT_R32G32B32A32_SFLOAT, extent, false, traced.color);
    if (shape_.copiesDepth) {
        made->drawnDepth = uploadDepth(shape_.depth, extent, traced.depth, VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
        made->depth = emptyImage(device_, shape_.depth, extent,
                                 VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    } else {
        made->depth = uploaded(device_, VK_FORMAT_R32_SFLOAT, extent, false, traced.depth);
    }
    scenes_.push_back(std::move(made));
    return *scenes_.back();
}

seaglass::ViewDesc ShapedHost::viewOf(const Camera& camera, uint32_t index) {
    seaglass::ViewDesc view = viewDesc(camera);
    copyMatrix(hostView(shape_.world, camera), view.view);
    copyMatrix(hostProjection(shape_.world, camera), view.projection);
    worldFrom(shape_.world.world, &view);
    if (shape_.flipped) {
        for (int column = 0; column < 4; ++column) view.projection[column * 4 + 1] *= -1;
        view.viewport.y = view.viewport.height;
        view.viewport.height *= -1;
    }
    view.viewIndex = index;
    if (shape_.scene == SceneGiven::noImages) return view;
    const Scene& scene = sceneOf(camera);
    const auto as = [&](const demos::Image& image) {
        return seaglass::Image{image.view.get(), image.format, image.extent,
                               VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    };
    view.sceneColor = as(scene.color);
    view.sceneColor.encoding = shape_.encoding;
    view.sceneDepth = as(scene.depth);
    if (shape_.resolvesScene) {
        view.sceneDepth.layout = VK_IMAGE_LAYOUT_GENERAL;
        view.sceneDepth.samples = VK_SAMPLE_COUNT_4_BIT;
    }
    return view;
}

void ShapedHost::record(Slot& slot, const Targets* targets,
                        const std::function<void(VkCommandBuffer)>& commands) {
    if (!shape_.secondary) return commands(slot.primary);
    const VkCommandBuffer own = slot.secondaries.at(slot.secondariesUsed++);
    VkCommandBufferInheritanceRenderingInfo rendering{
        VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_RENDERING_INFO};
    rendering.viewMask = viewMask(viewsAtOnce);
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachmentFormats = &shape_.color;
    rendering.depthAttachmentFormat = shape_.depth;
    if (shape_.stencilAttached) rendering.stencilAttachmentFormat = shape_.depth;
    rendering.rasterizationSamples = shape_.samples;
    VkCommandBufferInheritanceInfo inherited{VK_STRUCTURE_TYPE_COMMAND_BUFFER_INHERITANCE_INFO};
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    begin.pInheritanceInfo = &inherited;
    if (targets) {
        begin.flags |= VK_COMMAND_BUFFER_USAGE_RENDER_PASS_CONTINUE_BIT;
        inherited.renderPass = renderPass_.get();
        if (!shape_.renderPass) inherited.pNext = &rendering;
    }
    expectVk(vkBeginCommandBuffer(own, &begin), "vkBeginCommandBuffer");
    commands(own);
    expectVk(vkEndCommandBuffer(own), "vkEndCommandBuffer");
    vkCmdExecuteCommands(slot.primary, 1, &own);
}

void ShapedHost::copyDepth(VkCommandBuffer commands, const Scene& scene) const {
    if (!shape_.copiesDepth) return;
    seaglass::SceneCopy copy;
    copy.from = scene.drawnDepth.image.get();
    copy.to = scene.depth.image.get();
    copy.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    copy.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    if (holdsStencil(shape_.depth)) copy.aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
    copy.extent = scene.depth.extent;
    EXPECT_EQ(seaglass::recordSceneCopy(context_, commands, copy), Status::ok) << message_;
}

void ShapedHost::clearBed(VkCommandBuffer commands, const seaglass::ViewDesc& view) {
    seaglass::PlanarView bed;
    EXPECT_EQ(seaglass::bedView(body_, &view, &bed), Status::ok) << message_;
    beginDrawing(context_, commands, bed);
    vkCmdEndRendering(commands);
    if (!caustics_) return;
    demos::readBedDepth(context_, commands, bed);
    seaglass::ViewDesc over = demos::viewOf(bed);
    over.viewIndex = view.viewIndex;
    EXPECT_EQ(seaglass::castCaustics(commands, &body_, 1, &over, &lighting_), Status::ok) << message_;
    demos::beginOverBed(commands, bed); // a target of the bed's formats would draw them
    demos::endOverBed(context_, commands, bed);
}

void ShapedHost::beginPass(VkCommandBuffer commands, const Targets& targets, float clearDepth) {
    const VkRect2D area = {{0, 0}, targets.extent};
    const bool many = shape_.samples != VK_SAMPLE_COUNT_1_BIT;
    const VkClearValue far = clearOf(clearDepth);
    if (shape_.renderPass) {
        const VkClearValue clears[] = {background(shape_.encoding), far, background(shape_.encoding)};
        VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
        begin.renderPass = renderPass_.get();
        begin.framebuffer = targets.framebuffer.get();
        begin.renderArea = area;
        begin.clearValueCount = many ? 3 : 2;
        begin.pClearValues = clears;
        vkCmdBeginRenderPass(commands, &begin,
                             shape_.secondary ? VK_SUBPASS_CONTENTS_SECONDARY_COMMAND_BUFFERS
                                              : VK_SUBPASS_CONTENTS_INLINE);
        return;
    }
    const auto attached = [](const Attachment& attachment, VkImageLayout layout, const VkClearValue& clear) {
        VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        info.imageView = attachment.view.get();
        info.imageLayout = layout;
        info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        info.clearValue = clear;
        return info;
    };
    VkRenderingAttachmentInfo color =
        attached(many ? targets.manyColors : targets.color, colorLayout, background(shape_.encoding));
    if (many) {
        color.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
        color.resolveImageView = targets.color.view.get();
        color.resolveImageLayout = colorLayout;
    }
    const VkRenderingAttachmentInfo depth = attached(targets.depth, depthLayout, far);
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    if (shape_.secondary) rendering.flags = VK_RENDERING_CONTENTS_SECONDARY_COMMAND_BUFFERS_BIT;
    rendering.renderArea = area;
    rendering.layerCount = 1;
    rendering.viewMask = viewMask(targets.layers);
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &color;
    rendering.pDepthAttachment = &depth;
    rendering.pStencilAttachment = shape_.stencilAttached ? &depth : nullptr;
    vkCmdBeginRendering(commands, &rendering);
}

void ShapedHost::endPass(VkCommandBuffer commands) {
    if (shape_.renderPass)
        vkCmdEndRenderPass(commands);
    else
        vkCmdEndRendering(commands);
}

void ShapedHost::readBack(VkCommandBuffer commands, const Targets& targets) {
    recordBarrier(commands, toLayout(targets.color.image.get(), VK_IMAGE_ASPECT_COLOR_BIT, colorLayout,
                                     VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL));
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, targets.layers};
    region.imageExtent = {targets.extent.width, targets.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, targets.color.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           targets.readback.buffer.get(), 1, &region);
}

void ShapedHost::submit(uint32_t slotIndex, std::span<const Camera> cameras, double time) {
    Slot& slot = slots_[slotIndex];
    const auto count = static_cast<uint32_t>(cameras.size());
    const VkExtent2D extent = {cameras[0].width, cameras[0].height};
    slot.passes.clear();
    if (shape_.multiview)
        slot.passes.push_back(createTargets(extent, count));
    else
        for (const Camera& camera : cameras)
            slot.passes.push_back(createTargets({camera.width, camera.height}, 1));
    std::vector<seaglass::ViewDesc> views;
    for (uint32_t i = 0; i < count; ++i) views.push_back(viewOf(cameras[i], i));

    slot.secondariesUsed = 0;
    expectVk(vkResetCommandPool(device_.handle(), slot.pool.get(), 0), "vkResetCommandPool");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    expectVk(vkBeginCommandBuffer(slot.primary, &begin), "vkBeginCommandBuffer");
    EXPECT_EQ(seaglass::beginFrame(context_, slotIndex), Status::ok) << message_;
    record(slot, nullptr, [&](VkCommandBuffer commands) {
        EXPECT_EQ(seaglass::simulate(commands, &body_, 1, time), Status::ok) << message_;
        for (const Camera& camera : cameras) copyDepth(commands, sceneOf(camera));
        for (const seaglass::ViewDesc& view : views)
            if (bed_) clearBed(commands, view);
        for (const seaglass::ViewDesc& view : views)
            EXPECT_EQ(seaglass::reflect(commands, &body_, 1, &view), Status::ok) << message_;
        for (const seaglass::ViewDesc& view : views)
            if (caustics_) {
                EXPECT_EQ(seaglass::castCaustics(commands, &body_, 1, &view, &lighting_), Status::ok)
                    << message_;
            }
    });
    for (const seaglass::ViewDesc& view : views)
        EXPECT_EQ(seaglass::shade(slot.primary, &body_, 1, &view, &lighting_), Status::ok) << message_;
    for (size_t pass = 0; pass < slot.passes.size(); ++pass) {
        const Targets& targets = slot.passes[pass];
        for (const Attachment* color : {&targets.color, &targets.manyColors})
            if (color->image)
                recordBarrier(slot.primary, toLayout(color->image.get(), color->aspect,
                                                     VK_IMAGE_LAYOUT_UNDEFINED, colorLayout));
        recordBarrier(slot.primary, toLayout(targets.depth.image.get(), targets.depth.aspect,
                                             VK_IMAGE_LAYOUT_UNDEFINED, depthLayout));
        beginPass(slot.primary, targets, depthOf(cameras[pass], hiddenFrom));
        record(slot, &targets, [&](VkCommandBuffer commands) {
            const std::span<const seaglass::ViewDesc> drawn =
                shape_.multiview ? std::span<const seaglass::ViewDesc>(views)
                                 : std::span<const seaglass::ViewDesc>(&views[pass], 1);
            for (const seaglass::ViewDesc& view : drawn) {
                if (caustics_) {
                    EXPECT_EQ(seaglass::drawCaustics(commands, target_, &body_, 1, &view, &lighting_),
                              Status::ok)
                        << message_;
                }
                EXPECT_EQ(seaglass::draw(commands, target_, &body_, 1, &view, &lighting_), Status::ok)
                    << message_;
            }
        });
        endPass(slot.primary);
        readBack(slot.primary, targets);
    }
    VkMemoryBarrier2 toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    toHost.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    toHost.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    toHost.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    toHost.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &toHost;
    vkCmdPipelineBarrier2(slot.primary, &dependency);
    expectVk(vkEndCommandBuffer(slot.primary), "vkEndCommandBuffer");

    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = slot.primary;
    VkSubmitInfo2 submission{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submission.commandBufferInfoCount = 1;
    submission.pCommandBufferInfos = &buffer;
    expectVk(vkQueueSubmit2(device_.queue(), 1, &submission, slot.fence.get()), "vkQueueSubmit2");
}

std::vector<Picture> ShapedHost::fetch(uint32_t slotIndex) {
    Slot& slot = slots_[slotIndex];
    expectVk(vkWaitForFences(device_.handle(), 1, &slot.fence.get(), VK_TRUE, UINT64_MAX), "vkWaitForFences");
    expectVk(vkResetFences(device_.handle(), 1, &slot.fence.get()), "vkResetFences");
    std::vector<Picture> pictures;
    for (const Targets& targets : slot.passes) {
        const auto* texel = static_cast<const std::byte*>(targets.readback.mapped);
        for (uint32_t layer = 0; layer < targets.layers; ++layer) {
            Picture& picture = pictures.emplace_back();
            for (size_t i = 0; i < size_t{targets.extent.width} * targets.extent.height; ++i) {
                const glm::vec4 value = decoded(shape_.color, texel);
                picture.insert(picture.end(), {value.r, value.g, value.b, value.a});
                texel += texelBytes(shape_.color);
            }
        }
    }
    return pictures;
}

Picture ShapedHost::picture(const Camera& camera, double time, uint32_t slot) {
    submit(slot, {&camera, 1}, time);
    return fetch(slot).front();
}

} // namespace tests
