// What hosts get wrong: named by the library where it can know, and by the validation layers where only they
// can.
#include <cstdlib>

#include "gpu/context.h"
#include "gpu/pipeline/kernel.h"
#include "seaglass/record.h"
#include "spirv/beyond_the_end.comp.h"
#include "tests/gpu/host/host_shape.h"
#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Mistakes : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        const BodyDesc bodyDesc;
        ASSERT_EQ(createBody(context(), &bodyDesc, &body), Status::ok) << message();
        ASSERT_EQ(createTarget(context(), &targetDesc, &target), Status::ok) << message();
        const ReflectorDesc reflectorDesc;
        ASSERT_EQ(createReflector(context(), &reflectorDesc, &reflector), Status::ok) << message();
        color_ = uploadFloats(4, 4, 4, std::vector<float>(64));
        depth_ = uploadFloats(4, 4, 1, std::vector<float>(16));
        std::vector<float> faces(24, 1.0f);
        cube_.format = VK_FORMAT_R32G32B32A32_SFLOAT;
        cube_.cube = true;
        const std::span<const std::byte> level = std::as_bytes(std::span(faces));
        demos::Error error;
        ASSERT_TRUE(demos::createSampledImage(device(), cube_, {&level, 1}, sky_, error)) << error.text;
        lighting.skyCube = sky_.view.get();
        Camera camera = shoreCamera();
        camera.width = camera.height = 4;
        view = viewDesc(camera);
        view.sceneColor = asSeaglass(color_);
        view.sceneDepth = asSeaglass(depth_);
    }
    void TearDown() override {
        destroyReflector(reflector);
        destroyTarget(target);
        destroyBody(body);
        GpuTest::TearDown();
    }
    void expectMessage(const std::string& text) {
        EXPECT_NE(message().find(text), std::string::npos) << message();
    }
    /// Begins a frame, and records what is never submitted.
    void recordOnly(const std::function<void(VkCommandBuffer)>& record) {
        ASSERT_EQ(beginFrame(context(), 0), Status::ok);
        demos::Error error;
        EXPECT_FALSE(device().run(
            [&](VkCommandBuffer commands, demos::Error&) {
                record(commands);
                return false;
            },
            error));
    }

    TargetDesc targetDesc = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_D32_SFLOAT};
    Body* body = nullptr;
    Target* target = nullptr;
    Reflector* reflector = nullptr;
    ViewDesc view;
    LightingDesc lighting;

    demos::Image color_, depth_;

  private:
    demos::ImageDesc cube_;
    demos::Image sky_;
};

TEST_F(Mistakes, NullsAreNamed) {
    const auto expectRefused = [&](Status status, const char* text) {
        EXPECT_EQ(status, Status::invalidArgument) << text;
        expectMessage(text);
    };
    Body* noBody = nullptr;
    Target* noTarget = nullptr;
    Reflector* noReflector = nullptr;
    const BodyDesc bodyDesc;
    const ReflectionDesc reflectionDesc;
    const ReflectorDesc reflectorDesc;
    Estimate costs;
    PlanarView mirrored;
    const OverlayDesc overlay;
    expectRefused(createBody(context(), nullptr, &noBody), "createBody: desc is null");
    expectRefused(createBody(context(), &bodyDesc, nullptr), "createBody: out is null");
    expectRefused(createTarget(context(), nullptr, &noTarget), "createTarget: desc is null");
    expectRefused(createReflector(context(), &reflectorDesc, nullptr), "createReflector: out is null");
    expectRefused(estimate(context(), &bodyDesc, {4, 4}, nullptr), "estimate: out is null");
    expectRefused(estimate(context(), static_cast<ReflectionDesc*>(nullptr), {4, 4}, &costs),
                  "estimate: desc is null");
    expectRefused(planarView(reflector, nullptr, &mirrored), "planarView: view is null");
    expectRefused(planarView(body, &view, nullptr), "planarView: out is null");
    expectRefused(planarView(body, &view, &mirrored), "planarView: the body's reflection is the sky alone");
    Body* const bodies[] = {body, nullptr};
    Body* const twice[] = {body, body};
    Reflector* const reflectors[] = {nullptr, reflector};
    Reflector* const twoAlike[] = {reflector, reflector};
    recordOnly([&](VkCommandBuffer commands) {
        expectRefused(simulate(nullptr, &body, 1, 0), "simulate: commands is null");
        expectRefused(simulate(commands, bodies, 2, 0), "simulate: bodies[1] is null");
        expectRefused(reflect(commands, bodies, 2, &view), "reflect: bodies[1] is null");
        expectRefused(simulate(commands, twice, 2, 0), "simulate: bodies[1] is bodies[0] once more");
        expectRefused(reflect(commands, twice, 2, &view), "reflect: bodies[1] is bodies[0] once more");
        expectRefused(reflect(commands, twoAlike, 2, &view),
                      "reflect: reflectors[1] is reflectors[0] once more");
        expectRefused(shade(commands, twice, 2, &view, &lighting), "shade: bodies[1] is bodies[0] once more");
        expectRefused(draw(commands, target, twice, 2, &view, &lighting),
                      "draw: bodies[1] is bodies[0] once more");
        expectRefused(reflect(commands, &body, 1, nullptr), "reflect: view is null");
        expectRefused(reflect(commands, reflectors, 2, &view), "reflect: reflectors[0] is null");
        expectRefused(recordOverlay(commands, reflector, &view, nullptr), "recordOverlay: desc is null");
        expectRefused(recordOverlay(nullptr, body, &view, &overlay), "recordOverlay: commands is null");
        expectRefused(recordOverlay(commands, body, &view, &overlay),
                      "recordOverlay: the body's reflection is the sky alone");
        expectRefused(draw(commands, target, nullptr, 1, &view, &lighting), "draw: bodies is null");
        expectRefused(draw(commands, nullptr, &body, 1, &view, &lighting), "draw: target is null");
        expectRefused(draw(commands, target, &body, 1, &view, nullptr), "draw: lighting is null");
        expectRefused(shade(commands, bodies, 2, &view, &lighting), "shade: bodies[1] is null");
        expectRefused(shade(commands, &body, 1, &view, nullptr), "shade: lighting is null");
        expectRefused(castCaustics(commands, bodies, 2, &view, &lighting), "castCaustics: bodies[1]");
        expectRefused(castCaustics(commands, &body, 1, &view, nullptr), "castCaustics: lighting is null");
        expectRefused(drawCaustics(commands, target, bodies, 2, &view, &lighting), "drawCaustics: bodies[1]");
        // With nobody to tell.
        EXPECT_EQ(simulate(commands, &noBody, 1, 0), Status::invalidArgument);
        EXPECT_EQ(reflect(commands, &noReflector, 1, &view), Status::invalidArgument);
    });
    EXPECT_EQ(createBody(nullptr, &bodyDesc, &noBody), Status::invalidArgument);
    EXPECT_EQ(estimate(nullptr, &reflectionDesc, {4, 4}, &costs), Status::invalidArgument);
}

TEST_F(Mistakes, LightThatMeansNothingIsNamed) {
    const auto expectRefused = [&](const char* text, auto&& spoil) {
        LightingDesc bad = lighting;
        spoil(bad);
        recordOnly([&](VkCommandBuffer commands) {
            spiedCalls().clear();
            EXPECT_EQ(draw(commands, target, &body, 1, &view, &bad), Status::invalidArgument) << text;
            EXPECT_EQ(spiedCalls().size(), 0u) << text;
        });
        expectMessage(text);
    };
    for (const uint32_t bad : {0u, 17u})
        expectRefused("LightingDesc.skyCubeMipLevels", [&](LightingDesc& l) { l.skyCubeMipLevels = bad; });
    for (const VkImageLayout bad :
         {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
          VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL})
        expectRefused("LightingDesc.skyCubeLayout", [&](LightingDesc& l) { l.skyCubeLayout = bad; });
    float(LightingDesc::*const skyColors[])[3] = {&LightingDesc::skyZenith, &LightingDesc::skyHorizon,
                                                  &LightingDesc::skyGround};
    const char* const skyNames[] = {"LightingDesc.skyZenith", "LightingDesc.skyHorizon",
                                    "LightingDesc.skyGround"};
    for (int i = 0; i < 3; ++i)
        for (const float bad : {-1.0f, NAN, INFINITY})
            expectRefused(skyNames[i], [&](LightingDesc& l) {
                l.skyCube = VK_NULL_HANDLE;
                (l.*skyColors[i])[1] = bad;
            });
    for (const double bad : {0.0, 1.1, double{NAN}, double{INFINITY}})
        expectRefused("LightingDesc.toSun", [&](LightingDesc& l) { l.toSun[1] = bad; });
    for (const float bad : {-1.0f, NAN, INFINITY})
        for (int channel = 0; channel < 3; ++channel) {
            expectRefused("LightingDesc.sunIrradiance",
                          [&](LightingDesc& l) { l.sunIrradiance[channel] = bad; });
            expectRefused("LightingDesc.skyIrradiance",
                          [&](LightingDesc& l) { l.skyIrradiance[channel] = bad; });
        }
}

TEST_F(Mistakes, TargetsThatTheDeviceCannotDrawAreRefused) {
    const auto expectRefused = [&](Status status, const char* field, auto&& spoil) {
        TargetDesc desc = targetDesc;
        spoil(desc);
        Target* made = nullptr;
        EXPECT_EQ(createTarget(context(), &desc, &made), status) << field;
        EXPECT_EQ(made, nullptr);
        expectMessage(field);
    };
    expectRefused(Status::unsupported, "TargetDesc.colorFormat",
                  [](TargetDesc& d) { d.colorFormat = VK_FORMAT_D32_SFLOAT; });
    expectRefused(Status::unsupported, "TargetDesc.depthFormat",
                  [](TargetDesc& d) { d.depthFormat = VK_FORMAT_R8G8B8A8_UNORM; });
    expectRefused(Status::unsupported, "TargetDesc.stencilFormat",
                  [](TargetDesc& d) { d.stencilFormat = VK_FORMAT_R8_UNORM; });
    expectRefused(Status::unsupported, "TargetDesc.samples",
                  [](TargetDesc& d) { d.samples = VK_SAMPLE_COUNT_64_BIT; });
    expectRefused(Status::invalidArgument, "TargetDesc.viewMask", [](TargetDesc& d) { d.viewMask = 0x100; });
}

TEST_F(Mistakes, ViewsThatAMultiviewPassLacksAreRefused) {
    targetDesc.viewMask = 5;
    Target* several = nullptr;
    ASSERT_EQ(createTarget(context(), &targetDesc, &several), Status::ok) << message();
    view.viewIndex = 1;
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(draw(commands, several, &body, 1, &view, &lighting), Status::invalidArgument);
    });
    expectMessage("ViewDesc.viewIndex is 1");
    destroyTarget(several);
}

TEST_F(Mistakes, ObjectsOfAnotherContextAreRefused) {
    std::string text;
    const DeviceDesc desc = deviceDesc(&text);
    Context* other = nullptr;
    ASSERT_EQ(createContext(&desc, &other), Status::ok) << text;
    Target* foreign = nullptr;
    ASSERT_EQ(createTarget(other, &targetDesc, &foreign), Status::ok) << text;
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(draw(commands, foreign, &body, 1, &view, &lighting), Status::invalidArgument);
    });
    EXPECT_NE(text.find("draw: bodies[0] and the target are of different contexts"), std::string::npos)
        << text;
    EXPECT_EQ(prepare(target, body, &view, &lighting), Status::ok) << message();
    EXPECT_EQ(prepare(foreign, body, &view, &lighting), Status::invalidArgument);
    EXPECT_NE(text.find("prepare: the body and the target are of different contexts"), std::string::npos)
        << text;
    destroyTarget(foreign);
    destroyContext(other);
}

TEST_F(Mistakes, CausticsWantATargetThatHoldsMoreThanOne) {
    SeaDesc sea;
    sea.samples = 64;
    const RefractionDesc refraction;
    const CausticsDesc caustics;
    BodyDesc desc;
    desc.waves = &sea;
    desc.refraction = &refraction;
    desc.caustics = &caustics;
    Body* lit = nullptr;
    ASSERT_EQ(createBody(context(), &desc, &lit), Status::ok) << message();
    targetDesc.colorFormat = VK_FORMAT_R8G8B8A8_UNORM;
    Target* narrow = nullptr;
    ASSERT_EQ(createTarget(context(), &targetDesc, &narrow), Status::ok) << message();
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(drawCaustics(commands, narrow, &lit, 1, &view, &lighting), Status::invalidArgument);
        expectMessage("TargetDesc.colorFormat holds no floats");
        EXPECT_EQ(drawCaustics(commands, narrow, &body, 1, &view, &lighting), Status::ok) << "it has none";
    });
    destroyTarget(narrow);
    destroyBody(lit);
}

TEST_F(Mistakes, AContextInUseIsKept) {
    std::string text;
    const DeviceDesc desc = deviceDesc(&text);
    Context* kept = nullptr;
    ASSERT_EQ(createContext(&desc, &kept), Status::ok) << text;
    Target* in = nullptr;
    ASSERT_EQ(createTarget(kept, &targetDesc, &in), Status::ok) << text;
#ifdef SEAGLASS_ASSERTS
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_DEATH(destroyContext(kept), "destroyed before it");
#else
    destroyContext(kept);
    EXPECT_NE(text.find("destroyContext"), std::string::npos) << text;
#endif
    destroyTarget(in);
    text.clear();
    destroyContext(kept);
    EXPECT_EQ(text, "");
}

TEST_F(Mistakes, WhatWasDestroyedIsNamedWhileItIsKept) {
    Body* gone = nullptr;
    const BodyDesc bodyDesc;
    ASSERT_EQ(createBody(context(), &bodyDesc, &gone), Status::ok) << message();
    Target* lost = nullptr;
    ASSERT_EQ(createTarget(context(), &targetDesc, &lost), Status::ok) << message();
    Reflector* broken = nullptr;
    const ReflectorDesc reflectorDesc;
    ASSERT_EQ(createReflector(context(), &reflectorDesc, &broken), Status::ok) << message();
    recordOnly([&](VkCommandBuffer commands) {
        destroyBody(gone);
        destroyTarget(lost);
        destroyReflector(broken);
        Body* const bodies[] = {body, gone};
        PlanarView mirrored;
        const OverlayDesc overlay;
        EXPECT_MISUSE(simulate(commands, bodies, 2, 0), "simulate: bodies.1. was destroyed", message());
        EXPECT_MISUSE(reflect(commands, &gone, 1, &view), "reflect: bodies.0. was destroyed", message());
        EXPECT_MISUSE(draw(commands, target, &gone, 1, &view, &lighting), "draw: bodies.0. was", message());
        EXPECT_MISUSE(draw(commands, lost, &body, 1, &view, &lighting), "draw: target was destr", message());
        EXPECT_MISUSE(reflect(commands, &broken, 1, &view), "reflect: reflectors.0. was", message());
        EXPECT_MISUSE(planarView(gone, &view, &mirrored), "planarView: body was destroyed", message());
        EXPECT_MISUSE(planarView(broken, &view, &mirrored), "planarView: reflector was", message());
        EXPECT_MISUSE(recordOverlay(commands, gone, &view, &overlay), "recordOverlay: body was", message());
        EXPECT_MISUSE(recordOverlay(commands, broken, &view, &overlay), "recordOverlay: refl", message());
#ifdef SEAGLASS_ASSERTS
        EXPECT_DEATH(destroyBody(gone), "destroyBody: it was destroyed before");
#else
        destroyBody(gone);
        expectMessage("destroyBody: it was destroyed before");
#endif
    });
}

TEST_F(Mistakes, NothingIsRecordedBeforeAFrameIsBegun) {
    std::string text;
    const DeviceDesc desc = deviceDesc(&text);
    Context* idle = nullptr;
    ASSERT_EQ(createContext(&desc, &idle), Status::ok) << text;
    Body* early = nullptr;
    const BodyDesc bodyDesc;
    ASSERT_EQ(createBody(idle, &bodyDesc, &early), Status::ok) << text;
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_MISUSE(simulate(commands, &early, 1, 0), "was never called", text);
        EXPECT_MISUSE(reflect(commands, &early, 1, &view), "was never called", text);
        EXPECT_EQ(beginFrame(idle, 0), Status::ok);
        EXPECT_EQ(simulate(commands, &early, 1, 0), Status::ok) << text;
    });
    destroyBody(early);
    destroyContext(idle);
}

TEST_F(Mistakes, CallsTwiceOrTooLateInAFrameAreNamed) {
    expectValidationMessages(); // of draws outside a pass, which are never submitted
    SeaDesc sea;
    sea.samples = 64;
    const ReflectionDesc reflection;
    BodyDesc desc;
    desc.waves = &sea;
    desc.reflection = &reflection;
    Body* waves = nullptr;
    ASSERT_EQ(createBody(context(), &desc, &waves), Status::ok) << message();
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_MISUSE(draw(commands, target, &waves, 1, &view, &lighting), "was never called", message());
        EXPECT_EQ(simulate(commands, &waves, 1, 0), Status::ok) << message();
        EXPECT_MISUSE(simulate(commands, &waves, 1, 1), "simulate: it was called for the body in this frame",
                      message());
        EXPECT_EQ(reflect(commands, &waves, 1, &view), Status::ok) << message();
        EXPECT_EQ(shade(commands, &waves, 1, &view, &lighting), Status::ok) << message();
        EXPECT_EQ(draw(commands, target, &waves, 1, &view, &lighting), Status::ok) << message();
        EXPECT_EQ(reflect(commands, &waves, 1, &view), Status::ok) << "of another camera with this index";
    });
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(shade(commands, &waves, 1, &view, &lighting), Status::ok) << "waves stand still";
        EXPECT_EQ(draw(commands, target, &waves, 1, &view, &lighting), Status::ok) << message();
        EXPECT_MISUSE(simulate(commands, &waves, 1, 1), "simulate: the body was drawn in this frame",
                      message());
        EXPECT_MISUSE(reflect(commands, &waves, 1, &view), "reflect: the body was drawn in this view",
                      message());
        view.viewIndex = 1;
        EXPECT_EQ(reflect(commands, &waves, 1, &view), Status::ok) << message();
    });
    destroyBody(waves);
}

/// A device that is told less than it has.
struct Pretended {
    static inline uint32_t version = 0;
    static inline bool synchronization2 = true, demotes = true, extendedFormats = true;
    static void VKAPI_CALL properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* out) {
        vkGetPhysicalDeviceProperties(physical, out);
        out->apiVersion = version;
    }
    static void VKAPI_CALL features(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* out) {
        vkGetPhysicalDeviceFeatures2(physical, out);
        out->features.shaderStorageImageExtendedFormats = extendedFormats;
        auto* const features13 = static_cast<VkPhysicalDeviceVulkan13Features*>(out->pNext);
        features13->synchronization2 = synchronization2;
        features13->shaderDemoteToHelperInvocation = demotes;
    }
    static PFN_vkVoidFunction VKAPI_CALL loader(VkInstance instance, const char* name) {
        if (!std::strcmp(name, "vkGetPhysicalDeviceProperties"))
            return reinterpret_cast<PFN_vkVoidFunction>(&properties);
        if (!std::strcmp(name, "vkGetPhysicalDeviceFeatures2"))
            return reinterpret_cast<PFN_vkVoidFunction>(&features);
        return vkGetInstanceProcAddr(instance, name);
    }
};

/// By what looks first, and by what would be made. `desc` speaks to `text`.
void expectUnsupported(const DeviceDesc& desc, std::string& text, const char* lacking) {
    EXPECT_EQ(checkSupport(desc.instance, desc.physicalDevice, desc.getInstanceProcAddr, desc.message),
              Status::unsupported);
    EXPECT_NE(text.find(lacking), std::string::npos) << text;
    text.clear();
    Context* made = nullptr;
    EXPECT_EQ(createContext(&desc, &made), Status::unsupported);
    EXPECT_EQ(made, nullptr);
    EXPECT_NE(text.find(lacking), std::string::npos) << text;
}

TEST_F(Mistakes, DevicesThatLackSomethingAreRefusedByItsName) {
    const auto expectRefused = [&](const char* lacking) {
        std::string text;
        DeviceDesc desc = deviceDesc(&text);
        desc.getInstanceProcAddr = &Pretended::loader;
        expectUnsupported(desc, text, lacking);
    };
    Pretended::version = VK_API_VERSION_1_2;
    expectRefused("has Vulkan 1.2, expected 1.3");
    Pretended::version = VK_API_VERSION_1_3;
    Pretended::synchronization2 = false;
    expectRefused("synchronization2");
    Pretended::synchronization2 = true;
    Pretended::demotes = false;
    expectRefused("shaderDemoteToHelperInvocation");
    Pretended::demotes = true;
    Pretended::extendedFormats = false;
    expectRefused("shaderStorageImageExtendedFormats");
    Pretended::extendedFormats = true;
}

TEST_F(Mistakes, ALoaderThatLacksACallIsRefusedByItsName) {
    std::string text;
    DeviceDesc desc = deviceDesc(&text);
    desc.getInstanceProcAddr = [](VkInstance instance, const char* name) {
        return std::strcmp(name, "vkGetPhysicalDeviceMemoryProperties")
                   ? vkGetInstanceProcAddr(instance, name)
                   : nullptr;
    };
    expectUnsupported(desc, text, "the Vulkan loader has no vkGetPhysicalDeviceMemoryProperties");
    EXPECT_EQ(checkSupport(desc.instance, VK_NULL_HANDLE, desc.getInstanceProcAddr, desc.message),
              Status::invalidArgument);
    EXPECT_NE(text.find("checkSupport: instance, physicalDevice and getInstanceProcAddr must not be null"),
              std::string::npos)
        << text;
}

TEST_F(Mistakes, WhatCannotBeCopiedIsRefusedByItsName) {
    SceneCopy right;
    right.from = color_.image.get();
    right.to = depth_.image.get();
    right.layout = VK_IMAGE_LAYOUT_GENERAL;
    right.extent = {8, 8};
    const auto expectRefused = [&](const SceneCopy& copy, const char* named) {
        recordOnly([&](VkCommandBuffer commands) {
            EXPECT_EQ(recordSceneCopy(context(), commands, copy), Status::invalidArgument);
            EXPECT_NE(message().find(named), std::string::npos) << message();
        });
    };
    SceneCopy wrong = right;
    wrong.from = VK_NULL_HANDLE;
    expectRefused(wrong, "SceneCopy.from");
    wrong = right;
    wrong.to = VK_NULL_HANDLE;
    expectRefused(wrong, "SceneCopy.to");
    wrong = right;
    wrong.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    expectRefused(wrong, "SceneCopy.layout");
    wrong = right;
    wrong.aspect = VK_IMAGE_ASPECT_STENCIL_BIT;
    expectRefused(wrong, "SceneCopy.aspect");
    wrong.aspect = VK_IMAGE_ASPECT_COLOR_BIT | VK_IMAGE_ASPECT_DEPTH_BIT;
    expectRefused(wrong, "SceneCopy.aspect");
    wrong = right;
    wrong.extent = {8, 0};
    expectRefused(wrong, "SceneCopy.extent");
    EXPECT_EQ(recordSceneCopy(nullptr, VK_NULL_HANDLE, right), Status::invalidArgument);
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(recordDrawnUse(context(), commands, {}, DrawnUse::sampled, DrawnUse::attached),
                  Status::invalidArgument);
        EXPECT_NE(message().find("PlanarView"), std::string::npos) << message();
    });
}

TEST_F(Mistakes, InstancesOfAnEarlierVulkanAreNamedAsTheCause) {
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_2;
    VkInstanceCreateInfo instanceInfo{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    instanceInfo.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreateInstance(&instanceInfo, nullptr, &instance), VK_SUCCESS);
    // volk's own are of the tests' instance.
    const auto function = [&]<typename F>(const char* name, F) {
        return reinterpret_cast<F>(vkGetInstanceProcAddr(instance, name));
    };
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    uint32_t count = 1;
    function("vkEnumeratePhysicalDevices", vkEnumeratePhysicalDevices)(instance, &count, &physical);
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo deviceInfo{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    deviceInfo.queueCreateInfoCount = 1;
    deviceInfo.pQueueCreateInfos = &queue;
    VkDevice made = VK_NULL_HANDLE;
    ASSERT_EQ(function("vkCreateDevice", vkCreateDevice)(physical, &deviceInfo, nullptr, &made), VK_SUCCESS);
    if (function("vkGetDeviceProcAddr", vkGetDeviceProcAddr)(made, "vkCmdPipelineBarrier2")) {
        function("vkDestroyDevice", vkDestroyDevice)(made, nullptr);
        function("vkDestroyInstance", vkDestroyInstance)(instance, nullptr);
        GTEST_SKIP() << "the driver gives Vulkan 1.3's calls to an instance of 1.2, so nothing is missing";
    }

    std::string text;
    DeviceDesc desc = deviceDesc(&text);
    desc.instance = instance;
    desc.physicalDevice = physical;
    desc.device = made;
    desc.getInstanceProcAddr = vkGetInstanceProcAddr; // spied functions are always there
    Context* context = nullptr;
    EXPECT_EQ(createContext(&desc, &context), Status::unsupported);
    EXPECT_EQ(context, nullptr);
    EXPECT_NE(text.find("VkApplicationInfo::apiVersion"), std::string::npos) << text;
    function("vkDestroyDevice", vkDestroyDevice)(made, nullptr);
    function("vkDestroyInstance", vkDestroyInstance)(instance, nullptr);
}

TEST_F(Mistakes, DrawingOutsideAPassIsHeardByValidation) {
    expectValidationMessages();
    const uint32_t before = device().validationMessages();
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(shade(commands, &body, 1, &view, &lighting), Status::ok) << message();
        EXPECT_EQ(draw(commands, target, &body, 1, &view, &lighting), Status::ok)
            << "a command buffer does not tell";
    });
    EXPECT_GT(device().validationMessages(), before);
}

TEST_F(Mistakes, ImagesThatCannotBeSampledAreHeardByValidation) {
    expectValidationMessages();
    demos::ImageDesc desc;
    desc.format = VK_FORMAT_R32_SFLOAT;
    desc.extent = {4, 4};
    desc.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    demos::Image unsampled;
    demos::Error error;
    ASSERT_TRUE(demos::createImage(device(), desc, unsampled, error)) << error.text;
    view.sceneDepth = asSeaglass(unsampled);
    const uint32_t before = device().validationMessages();
    recordOnly([&](VkCommandBuffer commands) {
        EXPECT_EQ(reflect(commands, &reflector, 1, &view), Status::ok) << "a view does not tell";
    });
    EXPECT_GT(device().validationMessages(), before);
}

TEST_F(Mistakes, GpuAssistedValidationHearsAWriteBeyondTheEnd) {
    const char* enabled = std::getenv("VK_LAYER_ENABLES");
    if (!enabled || !std::strstr(enabled, "GPU_ASSISTED"))
        GTEST_SKIP() << "VK_LAYER_ENABLES does not switch on GPU-assisted validation";
    expectValidationMessages();
    gpu::Buffer words;
    ASSERT_EQ(words.create(context()->device, 64, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "words"), Status::ok);
    gpu::Kernel kernel;
    ASSERT_EQ(kernel.create(context()->device, beyond_the_end_comp, "beyond the end"), Status::ok);
    const uint32_t before = device().validationMessages();
    frame([&](VkCommandBuffer commands) {
        const gpu::Bound resources[] = {
            {0, gpu::storageBuffer(words.handle())},
        };
        VkDescriptorSet set = VK_NULL_HANDLE;
        ASSERT_EQ(context()->frame().allocateSet(kernel.layout(), resources, set), Status::ok);
        kernel.dispatch(commands, set, 1, 1);
    });
    EXPECT_GT(device().validationMessages(), before);
}

} // namespace
