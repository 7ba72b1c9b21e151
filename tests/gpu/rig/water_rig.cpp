#include "tests/gpu/rig/water_rig.h"

#include <cstring>

#include "tests/gpu/host/cube_edges.h"

namespace tests {

namespace {

constexpr VkFormat colorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

demos::Image attachment(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                        VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT) {
    demos::ImageDesc desc;
    desc.samples = samples;
    desc.format = format;
    desc.extent = extent;
    desc.usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createImage(device(), desc, image, error)) << error.text;
    return image;
}

demos::Image uniformCube() {
    demos::ImageDesc desc;
    desc.format = colorFormat;
    desc.extent = {1, 1};
    desc.cube = true;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
    std::vector<float> faces;
    for (int face = 0; face < 6; ++face) faces.insert(faces.end(), {1, 2, 3, 1});
    const std::span<const std::byte> level = std::as_bytes(std::span(faces));
    demos::Image cube;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device(), desc, {&level, 1}, cube, error)) << error.text;
    copyEdges(device(), cube);
    return cube;
}

VkRenderingAttachmentInfo cleared(const demos::Image& image, VkImageLayout layout, VkClearValue value) {
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = image.view.get();
    info.imageLayout = layout;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = value;
    return info;
}

/// Draws into `many` and leaves one sample of it, or the mean of all, in the attachment's own image.
void resolve(VkRenderingAttachmentInfo& info, const demos::Image& many, VkResolveModeFlagBits mode) {
    info.resolveImageView = std::exchange(info.imageView, many.view.get());
    info.resolveImageLayout = info.imageLayout;
    info.resolveMode = mode;
}

void toAttachment(VkCommandBuffer commands, const demos::Image& image, VkImageLayout layout, bool depth) {
    demos::imageBarrier(
        commands, image, VK_IMAGE_LAYOUT_UNDEFINED, layout, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
        depth ? VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT
              : VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
        depth ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT
              : VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
}

void toSampled(VkCommandBuffer commands, const demos::Image& image, VkImageLayout from) {
    demos::imageBarrier(commands, image, from, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                        VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT);
}

} // namespace

void WaterTest::SetUp() {
    GpuTest::SetUp();
    skyCube_ = uniformCube();
    lighting.skyCube = skyCube_.view.get();
    useSamples(VK_SAMPLE_COUNT_1_BIT);
}

void WaterTest::useOwnContext() {
    seaglass::destroyTarget(std::exchange(target_, nullptr));
    GpuTest::useOwnContext();
    makeTarget();
}

void WaterTest::useSamples(VkSampleCountFlagBits samples) {
    samples_ = samples;
    makeTarget();
}

void WaterTest::useDepth(bool reversed) {
    reversedDepth_ = reversed;
    makeTarget();
}

void WaterTest::useEncoding(seaglass::Encoding encoding) {
    encoding_ = encoding;
    makeTarget();
}

void WaterTest::leaveDepth() {
    depthWrite_ = false;
    makeTarget();
}

void WaterTest::makeTarget() {
    seaglass::destroyTarget(target_);
    seaglass::TargetDesc desc;
    desc.colorFormat = colorFormat;
    desc.depthFormat = depthFormat;
    desc.samples = samples_;
    desc.depthWrite = depthWrite_;
    desc.reversedDepth = reversedDepth_;
    desc.encoding = encoding_;
    ASSERT_EQ(seaglass::createTarget(context(), &desc, &target_), seaglass::Status::ok) << message();
}

void WaterTest::TearDown() {
    for (seaglass::Body* body : std::exchange(bodies_, {})) seaglass::destroyBody(body);
    seaglass::destroyTarget(std::exchange(target_, nullptr));
    GpuTest::TearDown();
}

seaglass::Body* WaterTest::makeBody(seaglass::BodyDesc desc) {
    // What a CPU device chooses by itself: tests count its dispatches, and compare its maps to the bit.
    if (desc.wavesBackend && desc.wavesOn == seaglass::WavesOn::automatic)
        desc.wavesOn = seaglass::WavesOn::cpu;
    seaglass::Body* body = nullptr;
    EXPECT_EQ(seaglass::createBody(context(), &desc, &body), seaglass::Status::ok) << message();
    if (body) bodies_.push_back(body);
    return body;
}

void WaterTest::drawCausticsOf(seaglass::Body* body, const seaglass::LightingDesc& lights) {
    beforeDrawing = [body, &lights](VkCommandBuffer commands, const seaglass::ViewDesc& view) {
        return seaglass::castCaustics(commands, &body, 1, &view, &lights);
    };
    drawing = [body, &lights](VkCommandBuffer commands, seaglass::Target* target,
                              const seaglass::ViewDesc& view) {
        return seaglass::drawCaustics(commands, target, &body, 1, &view, &lights);
    };
}

void WaterTest::shineFrom(const glm::dvec3& unitToSun, float irradiance) {
    for (int i = 0; i < 3; ++i) lighting.toSun[i] = unitToSun[i];
    std::ranges::fill(lighting.sunIrradiance, irradiance);
}

void WaterTest::shadeBefore(seaglass::Body* body, seaglass::SurfaceOutput output) {
    beforeDrawing = [this, body, output](VkCommandBuffer commands, const seaglass::ViewDesc& view) {
        return seaglass::shade(commands, &body, 1, &view, &lighting, output);
    };
}

WaterPicture WaterTest::picture(const std::vector<seaglass::Body*>& bodies, const Camera& camera, double time,
                                seaglass::SurfaceOutput output, const SceneBehind& behind) {
    using seaglass::Status;
    const VkExtent2D extent = {camera.width, camera.height};
    const size_t pixels = size_t{camera.width} * camera.height;
    const float farDepth = camera.reversed ? 0.0f : 1.0f;
    const demos::Image sceneColor = uploadFloats(
        camera.width, camera.height, 4, behind.color.empty() ? std::vector<float>(pixels * 4) : behind.color);
    const demos::Image sceneDepth =
        uploadFloats(camera.width, camera.height, 1,
                     behind.depth.empty() ? std::vector<float>(pixels, farDepth) : behind.depth);
    const demos::Image color = attachment(colorFormat, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    const demos::Image depth = attachment(depthFormat, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    demos::Image manyColors, manyDepths;
    if (samples_ != VK_SAMPLE_COUNT_1_BIT) {
        manyColors = attachment(colorFormat, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, samples_);
        manyDepths = attachment(depthFormat, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, samples_);
    }

    seaglass::ViewDesc view = viewDesc(camera);
    view.sceneColor = asSeaglass(sceneColor);
    view.sceneColor.encoding = encoding_;
    view.sceneDepth = asSeaglass(sceneDepth);
    if (changeView) changeView(view);
    seaglass::ViewDesc reflected = view;
    if (misleadReflection) misleadReflection(reflected);
    const auto count = static_cast<uint32_t>(bodies.size());
    frame([&](VkCommandBuffer commands) {
        EXPECT_EQ(seaglass::simulate(commands, bodies.data(), count, time), Status::ok) << message();
        if (beforeReflection) beforeReflection(commands);
        EXPECT_EQ(seaglass::reflect(commands, bodies.data(), count, &reflected), Status::ok) << message();
        if (beforeDrawing) {
            EXPECT_EQ(beforeDrawing(commands, view), Status::ok) << message();
        }
        if (!drawing) {
            EXPECT_EQ(seaglass::shade(commands, bodies.data(), count, &view, &lighting, output), Status::ok)
                << message();
        }
        toAttachment(commands, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, false);
        toAttachment(commands, depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true);
        VkClearValue untouched{};
        for (float& channel : untouched.color.float32) channel = WaterPicture::untouched;
        VkClearValue far{};
        far.depthStencil.depth = farDepth;
        VkRenderingAttachmentInfo colorInfo =
            cleared(color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, untouched);
        VkRenderingAttachmentInfo depthInfo = cleared(depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, far);
        if (samples_ != VK_SAMPLE_COUNT_1_BIT) {
            toAttachment(commands, manyColors, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, false);
            toAttachment(commands, manyDepths, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true);
            resolve(colorInfo, manyColors, VK_RESOLVE_MODE_AVERAGE_BIT);
            resolve(depthInfo, manyDepths, VK_RESOLVE_MODE_SAMPLE_ZERO_BIT);
        }
        VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
        rendering.renderArea.extent = extent;
        rendering.layerCount = 1;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachments = &colorInfo;
        rendering.pDepthAttachment = &depthInfo;
        vkCmdBeginRendering(commands, &rendering);
        const Status drawn =
            drawing ? drawing(commands, target_, view)
                    : seaglass::draw(commands, target_, bodies.data(), count, &view, &lighting, output);
        EXPECT_EQ(drawn, Status::ok) << message();
        vkCmdEndRendering(commands);
        toSampled(commands, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        toSampled(commands, depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    });
    WaterPicture result;
    result.width = camera.width;
    result.height = camera.height;
    result.color = download(color.image.get(), colorFormat, extent);
    result.depth = download(depth.image.get(), depthFormat, extent);
    return result;
}

namespace {

glm::dvec3 unproject(const Camera& camera, double x, double y, double depth) {
    const glm::dmat4 inverse = glm::inverse(projectionMatrix(camera) * viewMatrix(camera));
    const glm::dvec4 p = inverse * glm::dvec4(x / camera.width * 2 - 1, y / camera.height * 2 - 1, depth, 1);
    return glm::dvec3(p) / p.w;
}

} // namespace

glm::dvec3 worldAt(const Camera& camera, const WaterPicture& picture, uint32_t x, uint32_t y) {
    return unproject(camera, x + 0.5, y + 0.5, double{picture.depth[size_t{y} * picture.width + x]});
}

glm::dvec3 rayThrough(const Camera& camera, uint32_t x, uint32_t y) {
    return lineThrough(camera, x, y).along;
}

Line lineThrough(const Camera& camera, uint32_t x, uint32_t y) {
    const glm::dvec3 inside = unproject(camera, x + 0.5, y + 0.5, 0.5);
    if (camera.parallelHeight == 0) return {camera.eye, glm::normalize(inside - camera.eye)};
    const glm::dvec3 from = unproject(camera, x + 0.5, y + 0.5, camera.reversed ? 1 : 0);
    return {from, glm::normalize(inside - from)};
}

float depthOf(const Camera& camera, const glm::dvec3& world) {
    const glm::dvec4 p = projectionMatrix(camera) * viewMatrix(camera) * glm::dvec4(world, 1);
    return static_cast<float>(p.z / p.w);
}

SceneBehind nothingBehind(const Camera& camera) {
    SceneBehind behind;
    const size_t pixels = size_t{camera.width} * camera.height;
    behind.color.assign(4 * pixels, 0);
    behind.depth.assign(pixels, camera.reversed ? 0.0f : 1.0f);
    return behind;
}

SceneBehind planeBelow(const Camera& camera, double bed, float radiance) {
    SceneBehind behind;
    for (uint32_t y = 0; y < camera.height; ++y)
        for (uint32_t x = 0; x < camera.width; ++x) {
            const auto [from, along] = lineThrough(camera, x, y);
            const glm::dvec3 met = from + along * ((bed - from.y) / along.y);
            const float far = camera.reversed ? 0 : 1;
            behind.depth.push_back(along.y < 0 ? depthOf(camera, met) : far);
            behind.color.insert(behind.color.end(), {radiance, radiance, radiance, 1});
        }
    return behind;
}

seaglass::SeaDesc breeze() {
    seaglass::SeaDesc sea;
    sea.windSpeed = 8;
    sea.fetch = 50e3f;
    sea.samples = 64;
    sea.cascades = 3;
    return sea;
}

double angleBelowHorizon(const Camera& camera, uint32_t x, uint32_t y) {
    return -std::asin(rayThrough(camera, x, y).y);
}

} // namespace tests
