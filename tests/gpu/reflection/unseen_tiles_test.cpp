// What nobody looks up of a reflection holds nothing, on GPUs by a kernel and on CPU devices by a clear:
// whatever the images held before, both leave the same to the bit.
#include <array>
#include <cmath>
#include <limits>

#include "gpu/memory/image.h"
#include "reflection/core/reflector.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/drawn_view.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// To what no reflection holds, and left to be sampled.
void recordSpoiled(VkCommandBuffer commands, const gpu::OwnedImage& image) {
    VkImageMemoryBarrier2 barrier =
        gpu::imageBarrier(image.handle(), gpu::discardedAfterSampling, gpu::copyWritten);
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const VkClearColorValue value{{nan, nan, nan, nan}};
    const VkImageSubresourceRange all = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
    vkCmdClearColorImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &all);
    barrier = gpu::imageBarrier(image.handle(), gpu::copyWritten, gpu::sampledByShaders);
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    vkCmdPipelineBarrier2(commands, &dependency);
}

/// What the next frame is to overwrite: of a technique that the host draws for, no more than its copies.
void recordSpoiled(VkCommandBuffer commands, const Reflector& reflector) {
    const ReflectedView& view = reflector.views[0];
    const bool drawn = reflector.desc.technique == ReflectionTechnique::planar;
    std::vector<const OwnedReflection*> overwritten;
    if (reflector.desc.temporal > 0) {
        overwritten.push_back(&view.temporal.other);
        if (!drawn) overwritten.push_back(&view.temporal.found);
    } else if (!drawn) {
        overwritten.push_back(&view.images);
    }
    for (const OwnedReflection* const images : overwritten) {
        recordSpoiled(commands, images->color);
        recordSpoiled(commands, images->info);
    }
}

/// Three frames of a camera that moves, the last two over spoiled images.
class UnseenTiles : public testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().validationMessages(); }
    void TearDown() override {
        pretendDeviceType(VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM);
        EXPECT_EQ(device().validationMessages(), messagesBefore_);
    }

    /// Ends with what the last frame left.
    Reflected reflectedOn(VkPhysicalDeviceType type, const ReflectorDesc& desc, Camera camera,
                          bool bentByNormals) {
        pretendDeviceType(type);
        std::string said;
        const DeviceDesc deviceSaid = deviceDesc(&said);
        Context* context = nullptr;
        Reflector* reflector = nullptr;
        EXPECT_EQ(createContext(&deviceSaid, &context), Status::ok) << said;
        EXPECT_EQ(createReflector(context, &desc, &reflector), Status::ok) << said;
        const demos::Image normals = uploadFloats(
            camera.width, camera.height, 4, std::vector<float>(size_t{4} * camera.width * camera.height));
        spiedCalls().clear();
        for (uint32_t frame = 0; frame < 3; ++frame) {
            const TracedView traced = Tracer(camera, harbourOfBoxes()).run();
            const demos::Image depth = uploadFloats(traced.width, traced.height, 1, traced.depth);
            const demos::Image color = uploadFloats(traced.width, traced.height, 4, traced.color);
            ViewDesc view = viewDesc(camera);
            view.sceneDepth = asSeaglass(depth);
            view.sceneColor = asSeaglass(color);
            const Image surface = asSeaglass(normals);
            if (bentByNormals) view.surfaceNormals = &surface;
            EXPECT_EQ(beginFrame(context, frame % 2), Status::ok);
            record([&](VkCommandBuffer commands) {
                if (frame > 0) recordSpoiled(commands, *reflector);
            });
            const std::unique_ptr<DrawnBuffers> drawn = drawnFor(reflector, view);
            record([&](VkCommandBuffer commands) {
                if (drawn) recordDrawing(commands, handedOut_, *drawn);
                EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << said;
            });
            camera.eye.x += 0.3;
            camera.target.y -= 0.2;
        }
        const ReflectionImages images = reflectionImages(reflector, 0);
        Reflected out{download(images.colorImage, VK_FORMAT_R16G16B16A16_SFLOAT, images.extent),
                      download(images.infoImage, VK_FORMAT_R16_SFLOAT, images.extent)};
        destroyReflector(reflector);
        for (uint32_t slot = 0; slot < 2; ++slot) EXPECT_EQ(beginFrame(context, slot), Status::ok);
        destroyContext(context);
        return out;
    }

  private:
    static void record(const std::function<void(VkCommandBuffer)>& commandsOf) {
        demos::Error error;
        EXPECT_TRUE(device().run(
            [&](VkCommandBuffer commands, demos::Error&) {
                commandsOf(commands);
                return true;
            },
            error))
            << error.text;
    }

    /// Null for techniques that the host draws nothing for.
    std::unique_ptr<DrawnBuffers> drawnFor(Reflector* reflector, const ViewDesc& view) {
        if (reflector->desc.technique != ReflectionTechnique::planar) return nullptr;
        EXPECT_EQ(planarView(reflector, &view, &handedOut_), Status::ok);
        const size_t texels = size_t{handedOut_.extent.width} * handedOut_.extent.height;
        Drawn drawn{std::vector<float>(texels, handedOut_.clearDepth),
                    std::vector<uint64_t>(texels, 0x3c00380034003000u)};
        for (size_t i = 0; i < texels; i += 3) drawn.depth[i] = 0.3f;
        return std::make_unique<DrawnBuffers>(drawn);
    }

    uint32_t messagesBefore_ = 0;
    PlanarView handedOut_;
};

TEST_F(UnseenTiles, HoldTheSameOnEveryDevice) {
    using enum ReflectionTechnique;
    for (const ReflectionTechnique technique : {sspr, ssr, hybrid, planar})
        for (const float temporal : {0.0f, 0.9f})
            for (uint32_t variant = 0; variant < 3; ++variant) {
                ReflectorDesc desc = with(technique);
                desc.reflection.temporal = temporal;
                desc.reflection.downscale = variant == 1 ? 2 : 1;
                desc.reflection.edgeReach = variant == 1 ? 0.2f : 0.0f;
                desc.reflection.edgeStretch = variant == 1 ? 0.5f : 0.0f;
                desc.reflection.overhangSamples = variant == 0 ? 6 : 0;
                Camera camera = poses()[variant].camera;
                camera.width = 243; // tiles hang over both borders
                camera.height = 139;
                if (variant == 0) {
                    desc.reflection.distortion = 0; // no tile beside the box is looked up
                    const glm::dvec3 low(-2, -0.1, -6), high(1.5, 0.1, 2);
                    for (int axis = 0; axis < 3; ++axis) {
                        desc.boundsLow[axis] = low[axis];
                        desc.boundsHigh[axis] = high[axis];
                    }
                }
                const bool bent = variant == 2 && technique == ssr;
                SCOPED_TRACE(testing::Message() << "technique " << static_cast<int>(technique)
                                                << ", temporal " << temporal << ", variant " << variant);
                const Reflected byClear = reflectedOn(VK_PHYSICAL_DEVICE_TYPE_CPU, desc, camera, bent);
                const size_t clears = countSpied("CmdClearColorImage");
                const Reflected byKernel =
                    reflectedOn(VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, desc, camera, bent);
                EXPECT_EQ(countSpied("CmdClearColorImage"), 0u);
                EXPECT_EQ(clears, 3 * 2u * ((technique != planar) + (temporal > 0)));
                EXPECT_EQ(byKernel.info, byClear.info);
                EXPECT_EQ(byKernel.color, byClear.color);
                size_t nothing = 0, something = 0;
                for (const float info : byKernel.info) ++(info == 0 ? nothing : something);
                EXPECT_GT(nothing, byKernel.info.size() / 8);
                EXPECT_GT(something, byKernel.info.size() / 100);
            }
}

} // namespace
