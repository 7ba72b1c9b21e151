#include "tests/gpu/rig/rig.h"

#include <cstring>

#include <glm/gtc/packing.hpp>

#include "gpu/context.h"
#include "tests/gpu/host/spy.h"
#ifdef SEAGLASS_SHADER_RELOAD
#include "tests/gpu/rig/swapped_shaders.h"
#endif

namespace tests {

namespace {

uint32_t channelsOf(VkFormat format) {
    switch (format) {
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_R16_SFLOAT:
        return 1;
    case VK_FORMAT_R16G16_SFLOAT:
        return 2;
    default:
        return 4;
    }
}

VkImageAspectFlags aspectOf(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

void submit(const std::function<void(VkCommandBuffer)>& record) {
    demos::Error error;
    const bool done = device().run(
        [&](VkCommandBuffer commands, demos::Error&) {
            record(commands);
            return true;
        },
        error);
    if (device().lost()) {
        std::fprintf(stderr, "%s\n", error.text.c_str());
        std::fflush(stdout);
        std::_Exit(1); // no other test can run, and to destroy it would be to wait for it
    }
    ASSERT_TRUE(done) << error.text;
}

void imageToTransfer(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, bool back) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT;
    barrier.oldLayout =
        back ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    barrier.newLayout =
        back ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void keepMessage(void* text, const char* message) {
    // How long a driver compiles depends on the machine: it is no message that a test may expect or not.
    const bool isOfTime = std::strstr(message, ": the driver compiled it for ") != nullptr;
    if (!isOfTime) *static_cast<std::string*>(text) = message;
}

} // namespace

demos::Device& device() {
    static const std::unique_ptr<demos::Device> made = [] {
        demos::HostDesc desc;
        desc.validation = true;
        demos::Error error;
        auto d = demos::Device::create(desc, error);
        if (!d) {
            std::fprintf(stderr, "no device to test on: %s\n", error.text.c_str());
            std::exit(2);
        }
#ifdef SEAGLASS_SHADER_RELOAD
        swapShaders();
#endif
        return d;
    }();
    return *made;
}

double limitOnDriver([[maybe_unused]] double lavapipe, double others) {
#ifdef SEAGLASS_HOSTILE_ARITHMETIC
    return others;
#else
    return device().info().driver.starts_with("llvmpipe") ? lavapipe : others;
#endif
}

double limitOnGrid(double fine, double coarse) {
    return device().properties().limits.subPixelPrecisionBits >= 8 ? fine : coarse;
}

size_t onGpus(size_t count) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device().physical(), &properties);
    return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 0 : count;
}

seaglass::DeviceDesc deviceDesc(std::string* message) {
    seaglass::DeviceDesc desc;
    desc.instance = device().instance();
    desc.physicalDevice = device().physical();
    desc.device = device().handle();
    desc.getInstanceProcAddr = spiedGetInstanceProcAddr;
    desc.message = {keepMessage, message};
    desc.pass = {[](void* user, VkCommandBuffer commands, const char* pass, bool begins) {
                     static_cast<demos::PassTimer*>(user)->mark(commands, pass, begins);
                 },
                 &device().passes()};
    return desc;
}

std::unique_ptr<GpuTest::HeldContext> GpuTest::makeContext() {
    auto held = std::make_unique<HeldContext>();
    const seaglass::DeviceDesc desc = deviceDesc(&held->message);
    EXPECT_EQ(seaglass::createContext(&desc, &held->made), seaglass::Status::ok) << held->message;
    return held;
}

void GpuTest::useOwnContext() {
    context_ = makeContext();
    ASSERT_TRUE(context());
}

void GpuTest::SetUp() {
    messagesBefore_ = device().validationMessages();
    static const std::shared_ptr<HeldContext> ofAll = makeContext();
    context_ = ofAll;
    ASSERT_TRUE(context());
    context_->message.clear();
}

void GpuTest::TearDown() {
    if (!context()) return;
    EXPECT_EQ(context()->inUse, 0u) << "bodies, reflectors or targets that the test left";
    // What it destroyed is let go of, before the next test counts.
    for (uint32_t slot = 0; slot < context()->frameCount; ++slot)
        EXPECT_EQ(seaglass::beginFrame(context(), slot), seaglass::Status::ok) << message();
    if (!messagesExpected_) {
        EXPECT_EQ(device().validationMessages(), messagesBefore_);
    }
}

void GpuTest::frame(const std::function<void(VkCommandBuffer)>& record) {
    ASSERT_EQ(seaglass::beginFrame(context(), slot_), seaglass::Status::ok) << message();
    slot_ = (slot_ + 1) % 2;
    submit(record);
}

demos::Image uploadFloats(uint32_t width, uint32_t height, uint32_t channels,
                          const std::vector<float>& values) {
    demos::ImageDesc desc;
    desc.format = channels == 1 ? VK_FORMAT_R32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
    desc.extent = {width, height};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
    const std::span<const std::byte> level = std::as_bytes(std::span(values));
    demos::Image image;
    demos::Error error;
    EXPECT_TRUE(demos::createSampledImage(device(), desc, {&level, 1}, image, error)) << error.text;
    return image;
}

seaglass::Image asSeaglass(const demos::Image& image) {
    return {image.view.get(), image.format, image.extent, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

std::vector<float> download(VkImage image, VkFormat format, VkExtent2D extent, uint32_t mip, uint32_t layer) {
    const bool half = format == VK_FORMAT_R16G16B16A16_SFLOAT || format == VK_FORMAT_R16G16_SFLOAT ||
                      format == VK_FORMAT_R16_SFLOAT;
    const size_t count = size_t{extent.width} * extent.height * channelsOf(format);
    demos::Buffer buffer;
    demos::Error error;
    const VkDeviceSize bytes = count * (half ? 2 : 4);
    EXPECT_TRUE(demos::createBuffer(device(), bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                    demos::BufferPlace::readback, buffer, error))
        << error.text;
    submit([&](VkCommandBuffer commands) {
        imageToTransfer(commands, image, aspectOf(format), false);
        VkBufferImageCopy region{};
        region.imageSubresource = {aspectOf(format), mip, layer, 1};
        region.imageExtent = {extent.width, extent.height, 1};
        vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer.get(), 1,
                               &region);
        imageToTransfer(commands, image, aspectOf(format), true);
    });
    std::vector<float> values(count);
    if (half) {
        const auto* source = static_cast<const uint16_t*>(buffer.mapped);
        for (size_t i = 0; i < count; ++i) values[i] = glm::unpackHalf1x16(source[i]);
    } else {
        std::memcpy(values.data(), buffer.mapped, bytes);
    }
    return values;
}

std::vector<uint32_t> downloadWords(VkBuffer source, size_t count) {
    demos::Buffer buffer;
    demos::Error error;
    EXPECT_TRUE(demos::createBuffer(device(), count * 4, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                    demos::BufferPlace::readback, buffer, error))
        << error.text;
    submit([&](VkCommandBuffer commands) {
        const VkBufferCopy region{0, 0, count * 4};
        vkCmdCopyBuffer(commands, source, buffer.buffer.get(), 1, &region);
    });
    std::vector<uint32_t> words(count);
    std::memcpy(words.data(), buffer.mapped, count * 4);
    return words;
}

} // namespace tests
