// Mips are means of 2 x 2 texels, by kernels on GPUs as by blits on CPU devices.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include <glm/gtc/packing.hpp>

#include "gpu/context.h"
#include "gpu/memory/mip_chain.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

struct Shape {
    VkFormat format;
    VkExtent2D extent;
    uint32_t mips, layers, images;
};

constexpr VkFormat wide = VK_FORMAT_R32G32B32A32_SFLOAT, narrow = VK_FORMAT_R16G16B16A16_SFLOAT,
                   twoChannels = VK_FORMAT_R16G16_SFLOAT;

uint32_t channelsOf(const Shape& shape) {
    return shape.format == twoChannels ? 2 : 4;
}

/// One image's texels of one mip, layer after layer.
std::vector<float> halved(const std::vector<float>& finer, VkExtent2D extent, const Shape& shape) {
    const uint32_t channels = channelsOf(shape), width = extent.width / 2, height = extent.height / 2;
    std::vector<float> out;
    for (uint32_t layer = 0; layer < shape.layers; ++layer)
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                for (uint32_t c = 0; c < channels; ++c) {
                    double sum = 0;
                    for (uint32_t i = 0; i < 4; ++i) {
                        const size_t row = (size_t{layer} * extent.height + 2 * y + i / 2) * extent.width;
                        sum += double{finer[(row + 2 * x + i % 2) * channels + c]};
                    }
                    out.push_back(static_cast<float>(sum / 4));
                }
    return out;
}

class MipChains : public GpuTest, public testing::WithParamInterface<VkPhysicalDeviceType> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        pretendDeviceType(GetParam());
        useOwnContext();
    }
    void TearDown() override {
        GpuTest::TearDown();
        pretendDeviceType(VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM);
    }

    void expectMeans(const Shape& shape) {
        SCOPED_TRACE(testing::Message() << shape.extent.width << " x " << shape.extent.height << ", "
                                        << shape.mips << " mips, " << shape.layers << " layers");
        std::vector<std::vector<float>> expected = randomImages(shape);
        std::vector<gpu::OwnedImage> images(shape.images);
        gpu::MipChain chain;
        ASSERT_EQ(chain.create(*context(), shape.format), Status::ok) << message();
        gpu::ImageDesc desc;
        desc.format = shape.format;
        desc.extent = shape.extent;
        desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                     VK_IMAGE_USAGE_TRANSFER_SRC_BIT | gpu::MipChain::usage(context()->device);
        desc.mipLevels = shape.mips;
        desc.layers = shape.layers;
        desc.arrayView = true;
        for (gpu::OwnedImage& image : images)
            ASSERT_EQ(image.create(context()->device, desc, "mips"), Status::ok) << message();
        fill(shape, images, expected, chain);
        VkExtent2D extent = shape.extent;
        for (uint32_t mip = 1; mip < shape.mips; ++mip) {
            for (uint32_t i = 0; i < shape.images; ++i) {
                expected[i] = halved(expected[i], extent, shape);
                expectNear(images[i], shape, mip, expected[i]);
            }
            extent = {extent.width / 2, extent.height / 2};
        }
    }

  private:
    static std::vector<std::vector<float>> randomImages(const Shape& shape) {
        std::mt19937 random(shape.extent.width + shape.layers);
        std::uniform_real_distribution<float> value(-1, 1);
        std::vector<std::vector<float>> out(shape.images);
        for (std::vector<float>& image : out) {
            image.resize(size_t{shape.extent.width} * shape.extent.height * shape.layers * channelsOf(shape));
            for (float& v : image) v = value(random);
        }
        return out;
    }

    void fill(const Shape& shape, const std::vector<gpu::OwnedImage>& images,
              const std::vector<std::vector<float>>& texels, const gpu::MipChain& chain) {
        std::vector<demos::Buffer> staging(shape.images);
        for (uint32_t i = 0; i < shape.images; ++i) {
            demos::Error error;
            const size_t bytes = texels[i].size() * (shape.format == wide ? 4 : 2);
            ASSERT_TRUE(demos::createBuffer(device(), bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                            demos::BufferPlace::upload, staging[i], error))
                << error.text;
            if (shape.format == wide) std::memcpy(staging[i].mapped, texels[i].data(), bytes);
            auto* const halves = static_cast<uint16_t*>(staging[i].mapped);
            if (shape.format != wide)
                std::ranges::transform(texels[i], halves, [](float v) { return glm::packHalf1x16(v); });
        }
        frame([&](VkCommandBuffer commands) {
            std::vector<const gpu::OwnedImage*> all;
            for (uint32_t i = 0; i < shape.images; ++i) {
                const VkImageMemoryBarrier2 before =
                    gpu::imageBarrier(images[i].handle(), gpu::Use{}, gpu::copyWritten, 0, 1);
                gpu::recordBarriers(context()->device, commands, &before, 1);
                VkBufferImageCopy region{};
                region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, shape.layers};
                region.imageExtent = {shape.extent.width, shape.extent.height, 1};
                vkCmdCopyBufferToImage(commands, staging[i].buffer.get(), images[i].handle(),
                                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
                all.push_back(&images[i]);
            }
            spiedCalls().clear();
            EXPECT_EQ(chain.record(*context(), commands, all, gpu::copyWritten), Status::ok) << message();
        });
        const bool blits = GetParam() == VK_PHYSICAL_DEVICE_TYPE_CPU;
        const uint32_t halvings = shape.mips - 1;
        EXPECT_EQ(countSpied("CmdBlitImage"), blits ? size_t{halvings} * shape.images : 0u);
        EXPECT_EQ(countSpied("CmdDispatch"), blits ? 0u : (halvings + 4) / 5);
    }

    void expectNear(const gpu::OwnedImage& image, const Shape& shape, uint32_t mip,
                    const std::vector<float>& expected) {
        // A half's rounding in each halving, of values below 1; of floats likewise.
        const double tolerance = (shape.format == wide ? 0x1p-23 : 0x1p-11) * (mip + 1);
        const size_t perLayer = expected.size() / shape.layers;
        for (uint32_t layer = 0; layer < shape.layers; ++layer) {
            const std::vector<float> found =
                download(image.handle(), shape.format,
                         {shape.extent.width >> mip, shape.extent.height >> mip}, mip, layer);
            ASSERT_EQ(found.size(), perLayer);
            double worst = 0;
            for (size_t k = 0; k < perLayer; ++k) {
                ASSERT_TRUE(std::isfinite(found[k])) << "mip " << mip << ", value " << k;
                worst = std::max(worst, std::abs(double{found[k]} - double{expected[layer * perLayer + k]}));
            }
            EXPECT_LE(worst, tolerance) << "mip " << mip << ", layer " << layer;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(Types, MipChains,
                         testing::Values(VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
                         [](const auto& info) {
                             return info.param == VK_PHYSICAL_DEVICE_TYPE_CPU ? "Cpu" : "Gpu";
                         });

TEST_P(MipChains, AreMeansOfFour) {
    for (const uint32_t samples : {16u, 32u, 64u, 256u})
        expectMeans({wide, {samples, samples}, static_cast<uint32_t>(std::bit_width(samples)), 3, 3});
    expectMeans({wide, {1024, 1024}, 11, 1, 3});
    for (const uint32_t samples : {16u, 128u, 512u})
        expectMeans({narrow, {samples, samples}, static_cast<uint32_t>(std::bit_width(samples)), 2, 1});
    // As the light of caustics has it.
    expectMeans({twoChannels, {96, 160}, 6, 1, 1});
    expectMeans({twoChannels, {416, 32}, 6, 1, 1});
    expectMeans({twoChannels, {8, 8}, 1, 1, 1});
}

} // namespace
