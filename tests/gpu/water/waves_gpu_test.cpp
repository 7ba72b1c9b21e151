// Waves by compute shaders: the same sea as the CPU's, and the truth's.
#include "seaglass/water.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/rig.h"
#include "tests/unit/sea/sea_support.h"
#include "tests/unit/sea/wave_truth.h"
#include "water/body/body.h"
#include "water/interface/waves_backend.h"
#include "water/waves/waves_part.h"

namespace {

using namespace seaglass;
using tests::Maps;
using tests::WaveError;
using tests::waveError;
using tests::waveTruth;

constexpr double day = 86400;

SeaDesc seaOf(uint32_t samples) {
    SeaDesc desc;
    desc.samples = samples;
    return desc;
}

class GpuWaves : public ::tests::GpuTest {
  protected:
    void TearDown() override {
        for (Body* body : bodies_) destroyBody(body);
        GpuTest::TearDown();
    }

    Body* wavyBody(const SeaDesc& sea, WavesOn on = WavesOn::gpu) {
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesOn = on;
        Body* body = nullptr;
        EXPECT_EQ(createBody(context(), &desc, &body), Status::ok) << message();
        if (body) bodies_.push_back(body);
        return body;
    }

    void simulateAt(Body* body, double time) {
        frame([&](VkCommandBuffer commands) {
            EXPECT_EQ(simulate(commands, &body, 1, time), Status::ok) << message();
        });
    }

    Maps mapsOf(const Body& body, uint32_t cascade) {
        const WaveMaps& maps = body.find<WavesPart>()->waves.maps();
        Maps out(maps.samples);
        std::vector<float>* const targets[] = {&out.displacement, &out.derivatives, &out.moments};
        for (uint32_t m = 0; m < waveMapCount; ++m)
            *targets[m] = ::tests::download(maps.images[m].handle(), waveMapFormat,
                                            {maps.samples, maps.samples}, 0, cascade);
        return out;
    }

  private:
    std::vector<Body*> bodies_;
};

/// Each size is a shader of its own, which a CPU device takes a second to compile.
class GpuWavesOfEachSize : public GpuWaves, public testing::WithParamInterface<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Samples, GpuWavesOfEachSize, testing::Values(16, 32, 64, 128, 256, 512, 1024, 2048),
                         testing::PrintToStringParamName());

TEST_P(GpuWavesOfEachSize, AgreeWithDoubles) {
    double worst = 0;
    SeaDesc desc = seaOf(GetParam());
    if (desc.samples > 1024) desc.cascades = 2; // three ask for more than some devices bind at once
    Body* body = wavyBody(desc);
    constexpr double time = 100.125;
    simulateAt(body, time);
    // Doubles are slow: of the large ones the fullest cascade.
    const uint32_t count = cascadeCount(*sea(body));
    for (uint32_t c = GetParam() > 256 ? count - 1 : 0; c < count; ++c) {
        const Maps maps = mapsOf(*body, c);
        const WaveError error =
            waveError(waveTruth(*sea(body), c, time), maps.displacement, maps.derivatives);
        for (size_t f = 0; f < error.relative.size(); ++f) {
            EXPECT_LT(error.relative[f], 5e-7) << "cascade " << c << ", field " << f;
            worst = std::max(worst, error.relative[f]);
        }
    }
    std::printf("largest relative L2 error %.2e\n", worst);
}

TEST_F(GpuWaves, ThatExceedWhatTheDeviceBindsAreRefused) {
    SeaDesc desc = seaOf(2048);
    desc.cascades = 4;
    BodyDesc wanted;
    wanted.waves = &desc;
    wanted.wavesOn = WavesOn::gpu;
    Body* body = nullptr;
    const Status status = createBody(context(), &wanted, &body);
    destroyBody(body);
    if (status == Status::ok) GTEST_SKIP() << "this device binds what 2048 samples take";
    EXPECT_EQ(status, Status::unsupported);
    EXPECT_EQ(body, nullptr);
    EXPECT_NE(message().find("SeaDesc.samples is 2048: 4 cascades need a storage buffer of"),
              std::string::npos)
        << message();
}

/// A GPU stores to images; on a CPU they are copied.
class GpuWavesOnEachDevice : public GpuWaves, public testing::WithParamInterface<VkPhysicalDeviceType> {
  protected:
    void SetUp() override {
        GpuWaves::SetUp();
        ::tests::pretendDeviceType(GetParam());
        useOwnContext();
    }
    void TearDown() override {
        GpuWaves::TearDown();
        ::tests::pretendDeviceType(VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM);
    }
};
INSTANTIATE_TEST_SUITE_P(Types, GpuWavesOnEachDevice,
                         testing::Values(VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
                         [](const auto& info) {
                             return info.param == VK_PHYSICAL_DEVICE_TYPE_CPU ? "Cpu" : "Gpu";
                         });

TEST_P(GpuWavesOnEachDevice, AreTheCpusOnAllMaps) {
    double most = 0; // of Hs
    for (const uint32_t samples : {16u, 128u, 256u, 512u, 2048u}) {
        SeaDesc desc = seaOf(samples);
        if (samples > 512) desc.cascades = 1;
        desc.windDirection = 0.7f;
        desc.choppiness = 1.3f;
        Body* body = wavyBody(desc);
        constexpr double time = 4321.0625;
        simulateAt(body, time);
        const double tolerance = 1e-5 * significantWaveHeight(*sea(body));
        tests::Waves cpu(*sea(body));
        for (uint32_t c = 0; c < cascadeCount(*sea(body)); ++c) {
            const Maps found = mapsOf(*body, c), expected = cpu.at(c, time);
            const auto worst = [](const std::vector<float>& a, const std::vector<float>& b) {
                float most = 0;
                for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
                return most;
            };
            for (const float off :
                 {worst(found.displacement, expected.displacement),
                  worst(found.derivatives, expected.derivatives), worst(found.moments, expected.moments)}) {
                EXPECT_LT(off, tolerance) << samples << ", " << c;
                most = std::max(most, 1e-5 * static_cast<double>(off) / tolerance);
            }
        }
    }
    std::printf("largest difference %.1e Hs\n", most);
}

TEST_F(GpuWaves, StayExactAfterAMonth) {
    const SeaDesc desc = seaOf(256);
    Body* body = wavyBody(desc);
    const double height = significantWaveHeight(*sea(body));
    std::array<Maps, 2> before{Maps(256), Maps(256)};
    for (int i = 0; i < 4; ++i) {
        const double time = 30 * day + i / 60.0;
        simulateAt(body, time);
        const Maps now = mapsOf(*body, 0);
        const double worst =
            waveError(waveTruth(*sea(body), 0, time), now.displacement, now.derivatives).worst;
        EXPECT_LT(worst, 1e-3 * height);
        std::printf("%.3f s: off by %.1e Hs\n", time, worst / height);
        // Frames follow each other evenly: the height changes, and its change hardly does.
        if (i >= 2) {
            double moved = 0, jumped = 0;
            for (size_t t = 0; t < now.texels(); ++t) {
                moved = std::max(moved, std::abs(now.height(t) - before[0].height(t)));
                jumped =
                    std::max(jumped, std::abs(now.height(t) - 2 * before[0].height(t) + before[1].height(t)));
            }
            EXPECT_GT(moved, 1e-3 * height);
            EXPECT_LT(jumped, 0.2 * moved);
        }
        before[1] = before[0];
        before[0] = now;
    }
}

TEST_F(GpuWaves, SameBitsWhateverWasAskedBefore) {
    const SeaDesc desc = seaOf(128);
    Body* fresh = wavyBody(desc);
    Body* used = wavyBody(desc);
    for (const double time : {3.0, -17.0, 1e9}) simulateAt(used, time);
    simulateAt(fresh, 42.125);
    simulateAt(used, 42.125);
    for (uint32_t c = 0; c < cascadeCount(*sea(fresh)); ++c) {
        EXPECT_EQ(mapsOf(*fresh, c), mapsOf(*used, c)) << c;
        EXPECT_EQ(mapsOf(*fresh, c), mapsOf(*fresh, c)) << c;
    }
    simulateAt(used, 42.125 + 4096 * 8000.0);
    EXPECT_EQ(mapsOf(*fresh, 0), mapsOf(*used, 0));
}

/// Copies mip 0 of the first cascade's displacement to `buffer`, between the commands of two frames.
void recordCopyOut(VkCommandBuffer commands, const Body& body, const demos::Buffer& buffer) {
    const WaveMaps& maps = body.find<WavesPart>()->waves.maps();
    VkImageMemoryBarrier2 barrier = gpu::imageBarrier(
        maps.images[0].handle(), gpu::sampledByShaders,
        {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL});
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {maps.samples, maps.samples, 1};
    vkCmdCopyImageToBuffer(commands, maps.images[0].handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           buffer.buffer.get(), 1, &region);
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    std::swap(barrier.oldLayout, barrier.newLayout);
    vkCmdPipelineBarrier2(commands, &dependency);
}

TEST_F(GpuWaves, FramesInFlightDoNotMeet) {
    const SeaDesc desc = seaOf(64);
    for (uint32_t frames = 1; frames <= 4; ++frames)
        for (const WavesOn on : {WavesOn::gpu, WavesOn::cpu}) {
            std::string said;
            DeviceDesc device = ::tests::deviceDesc(&said);
            device.framesInFlight = frames;
            Context* several = nullptr;
            ASSERT_EQ(createContext(&device, &several), Status::ok) << said;
            BodyDesc bodyDesc;
            bodyDesc.waves = &desc;
            bodyDesc.wavesOn = on;
            bodyDesc.wavesBackend = fftwWaves();
            Body* body = nullptr;
            ASSERT_EQ(createBody(several, &bodyDesc, &body), Status::ok) << said;
            const size_t floats = size_t{4} * desc.samples * desc.samples;
            std::vector<demos::Buffer> found(frames);
            demos::Error error;
            for (demos::Buffer& buffer : found)
                ASSERT_TRUE(demos::createBuffer(::tests::device(), floats * sizeof(float),
                                                VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                demos::BufferPlace::readback, buffer, error))
                    << error.text;
            // All slots are recorded before the first is executed.
            ASSERT_TRUE(::tests::device().run(
                [&](VkCommandBuffer commands, demos::Error&) {
                    for (uint32_t slot = 0; slot < frames; ++slot) {
                        EXPECT_EQ(beginFrame(several, slot), Status::ok);
                        EXPECT_EQ(simulate(commands, &body, 1, 10.0 * slot), Status::ok) << said;
                        recordCopyOut(commands, *body, found[slot]);
                    }
                    return true;
                },
                error))
                << error.text;
            tests::Waves cpu(*sea(body));
            for (uint32_t slot = 0; slot < frames; ++slot) {
                const Maps expected = cpu.at(0, 10.0 * slot);
                const auto* heights = static_cast<const float*>(found[slot].mapped);
                float worst = 0;
                for (size_t i = 0; i < floats; ++i)
                    worst = std::max(worst, std::abs(heights[i] - expected.displacement[i]));
                EXPECT_LT(worst, 1e-5 * significantWaveHeight(*sea(body))) << slot << " of " << frames;
            }
            destroyBody(body);
            destroyContext(several);
        }
}

TEST_F(GpuWaves, NeedNoBackend) {
    const SeaDesc desc = seaOf(32);
    Body* body = wavyBody(desc, WavesOn::automatic);
    simulateAt(body, 5);
    const Maps maps = mapsOf(*body, 0);
    EXPECT_TRUE(std::ranges::any_of(maps.displacement, [](float v) { return v != 0; }));
}

TEST_P(GpuWavesOnEachDevice, KeepNothingOfTheOtherBackend) {
    const auto made = [&](WavesOn on, const WavesBackend* backend, uint32_t samples) {
        useOwnContext();
        const SeaDesc desc = seaOf(samples);
        ::tests::spiedCalls().clear();
        BodyDesc body;
        body.waves = &desc;
        body.wavesOn = on;
        body.wavesBackend = backend;
        Body* out = nullptr;
        EXPECT_EQ(createBody(context(), &body, &out), Status::ok) << message();
        simulateAt(out, 1);
        destroyBody(out);
    };
    const bool deviceIsCpu = GetParam() == VK_PHYSICAL_DEVICE_TYPE_CPU;
    const size_t ofMips = deviceIsCpu ? 0 : 1;
    const auto onCpu = [&] {
        EXPECT_EQ(::tests::countSpied("CreateComputePipelines"), ofMips);
        EXPECT_EQ(::tests::countSpied("CmdDispatch"), ofMips);
        EXPECT_EQ(::tests::countSpied("CmdCopyBufferToImage"), waveMapCount);
        EXPECT_EQ(::tests::countSpied("CmdCopyBuffer"), 0u);
    };
    const auto onGpu = [&] {
        EXPECT_EQ(::tests::countSpied("CreateComputePipelines"), 2 + ofMips);
        EXPECT_EQ(::tests::countSpied("CmdDispatch"), 2 + ofMips);
        EXPECT_EQ(::tests::countSpied("CmdBlitImage") > 0, deviceIsCpu);
        EXPECT_EQ(::tests::countSpied("CmdCopyBufferToImage"), deviceIsCpu ? waveMapCount : 0u);
        EXPECT_EQ(::tests::countSpied("CmdCopyBuffer"), 1u);
    };
    made(WavesOn::automatic, fftwWaves(), 16);
    deviceIsCpu ? onCpu() : onGpu();
    made(WavesOn::cpu, fftwWaves(), 16);
    onCpu();
    made(WavesOn::gpu, fftwWaves(), 32);
    onGpu();
}

TEST_F(GpuWaves, UploadTheirModesOnce) {
    const SeaDesc desc = seaOf(32);
    Body* body = wavyBody(desc);
    simulateAt(body, 1);
    ::tests::spiedCalls().clear();
    for (int i = 0; i < 3; ++i) simulateAt(body, i);
    EXPECT_EQ(::tests::countSpied("CmdCopyBuffer"), 0u);
    EXPECT_EQ(::tests::countSpied("CreateComputePipelines"), 0u);
}

} // namespace
