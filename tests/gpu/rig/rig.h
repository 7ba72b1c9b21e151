// A headless device with every validation switched on, a Seaglass context on it, and ways to move pixels.
#pragma once

#include <functional>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/vulkan/device.h"
#include "host/vulkan/resources.h"
#include "seaglass/host.h"

namespace tests {

/// The device is made once for a program: a validated instance takes long to start.
demos::Device& device();

/// A limit that lavapipe meets, and a wider one for drivers that round as Vulkan lets them. Why stands where
/// it is asked for.
double limitOnDriver(double lavapipe, double others);

/// A limit where vertices are snapped to 1/256 of a pixel or finer, as on lavapipe and on GPUs, and a wider
/// one for coarser grids: Vulkan asks for 1/16, which is SwiftShader's.
double limitOnGrid(double fine, double coarse);

/// How often something is done that is done on devices alone that are no CPU.
size_t onGpus(size_t count);
/// Dispatches that make the mips of all maps of waves there.
inline size_t wavesMips() {
    return onGpus(2);
}

/// Every test that uses it fails on a validation message, unless it says how many it expects. The tests of a
/// process have one context, which keeps the pipelines that they ask for.
class GpuTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// From here on one of the test's own, which has made no pipeline. Nothing is held of the other.
    void useOwnContext();

    seaglass::Context* context() const { return context_->made; }
    /// What the library said last.
    const std::string& message() const { return context_->message; }
    void expectValidationMessages() { messagesExpected_ = true; }

    /// Begins the next frame slot, records and waits.
    void frame(const std::function<void(VkCommandBuffer)>& record);

  private:
    struct HeldContext {
        seaglass::Context* made = nullptr;
        std::string message;
        ~HeldContext() { seaglass::destroyContext(made); }
    };
    static std::unique_ptr<HeldContext> makeContext();

    std::shared_ptr<HeldContext> context_;
    uint32_t messagesBefore_ = 0;
    uint32_t slot_ = 0;
    bool messagesExpected_ = false;
};

seaglass::DeviceDesc deviceDesc(std::string* message);

/// A call that breaks a rule of docs/contract.md is refused with words that `heard`, a string, then holds;
/// where asserts are on, it ends the program with them.
#ifdef SEAGLASS_ASSERTS
#define EXPECT_MISUSE(call, words, heard)                                                                    \
    do {                                                                                                     \
        testing::GTEST_FLAG(death_test_style) = "fast";                                                      \
        EXPECT_DEATH((void)(call), words);                                                                   \
    } while (false)
#else
#define EXPECT_MISUSE(call, words, heard)                                                                    \
    do {                                                                                                     \
        EXPECT_EQ(call, seaglass::Status::invalidArgument);                                                  \
        EXPECT_TRUE(std::regex_search((heard), std::regex(words))) << (heard);                               \
    } while (false)
#endif

/// Sampled in SHADER_READ_ONLY_OPTIMAL; rows from the top, `channels` floats a pixel. R32_SFLOAT or
/// RGBA32_SFLOAT.
demos::Image uploadFloats(uint32_t width, uint32_t height, uint32_t channels,
                          const std::vector<float>& values);
seaglass::Image asSeaglass(const demos::Image& image);

/// Mip `mip`, layer `layer` of an image in SHADER_READ_ONLY_OPTIMAL as floats. RGBA16F, RG32F, RGBA32F
/// and D32F.
std::vector<float> download(VkImage image, VkFormat format, VkExtent2D extent, uint32_t mip = 0,
                            uint32_t layer = 0);

/// The first words of a buffer that was last written by a compute shader.
std::vector<uint32_t> downloadWords(VkBuffer buffer, size_t count);

} // namespace tests
