// The context: what it demands of the host, and that the rig would see a hazard.
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

TEST_F(GpuTest, APlantedHazardIsSeen) {
    expectValidationMessages();
    demos::Buffer buffer;
    demos::Error error;
    ASSERT_TRUE(demos::createBuffer(device(), 1024, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                    demos::BufferPlace::device, buffer, error))
        << error.text;
    const uint32_t before = device().validationMessages();
    frame([&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, buffer.buffer.get(), 0, 1024, 1);
        vkCmdFillBuffer(commands, buffer.buffer.get(), 0, 1024, 2); // no barrier: write after write
    });
    EXPECT_GT(device().validationMessages(), before);
}

TEST_F(GpuTest, RefusesIncompleteDeviceDescriptions) {
    const auto refused = [&](auto&& spoil) {
        std::string text;
        DeviceDesc desc = deviceDesc(&text);
        spoil(desc);
        Context* made = nullptr;
        EXPECT_EQ(createContext(&desc, &made), Status::invalidArgument);
        EXPECT_EQ(made, nullptr);
        return text;
    };
    EXPECT_NE(refused([](DeviceDesc& d) { d.instance = nullptr; }).find("instance"), std::string::npos);
    EXPECT_NE(refused([](DeviceDesc& d) { d.physicalDevice = nullptr; }).find("physicalDevice"),
              std::string::npos);
    EXPECT_NE(refused([](DeviceDesc& d) { d.device = nullptr; }).find("device"), std::string::npos);
    EXPECT_NE(refused([](DeviceDesc& d) { d.getInstanceProcAddr = nullptr; }).find("getInstanceProcAddr"),
              std::string::npos);
    EXPECT_NE(refused([](DeviceDesc& d) { d.framesInFlight = 0; }).find("framesInFlight"), std::string::npos);
    EXPECT_NE(refused([](DeviceDesc& d) { d.framesInFlight = 5; }).find("framesInFlight"), std::string::npos);
}

TEST_F(GpuTest, RefusesHeadersOfAnotherVersionBeforeReadingOn) {
    EXPECT_EQ(version(), uint32_t{SEAGLASS_VERSION});
    std::string text;
    DeviceDesc desc = deviceDesc(&text);
    Context* made = nullptr;
    desc.headerVersion = SEAGLASS_VERSION ^ 1u; // a patch changes no struct
    ASSERT_EQ(createContext(&desc, &made), Status::ok) << text;
    destroyContext(made);
    for (const uint32_t bit : {12u, 22u}) {
        desc.headerVersion = SEAGLASS_VERSION ^ 1u << bit;
        EXPECT_EQ(createContext(&desc, &made), Status::unsupported);
        EXPECT_EQ(made, nullptr);
    }
    EXPECT_EQ(text, "");
}

TEST_F(GpuTest, RefusesASlotThatDoesNotExist) {
    EXPECT_MISUSE(beginFrame(context(), 2), "beginFrame: slot is 2, expected 0 to 1", message());
}

TEST_F(GpuTest, SeveralContextsShareADevice) {
    std::string text;
    const DeviceDesc desc = deviceDesc(&text);
    Context* second = nullptr;
    ASSERT_EQ(createContext(&desc, &second), Status::ok) << text;
    destroyContext(second);
}

} // namespace
