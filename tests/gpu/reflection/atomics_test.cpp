// Atomics: of the kind that every Vulkan device has, and none where rays find the same without the scatter.
#include <set>

#include "tests/gpu/host/spy.h"
#include "tests/gpu/rig/poses.h"
#include "tests/gpu/rig/reflection_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

// The SPIR-V specification, 3.32 and 3.31.
constexpr uint32_t opCapability = 17, opTypeInt = 21, opImageTexelPointer = 60, opAtomicUMax = 239;
constexpr uint32_t capabilityShader = 1, capabilityStorageImageExtendedFormats = 49,
                   capabilityImageQuery = 50;

class Atomics : public ReflectionTest {};

/// What a module asks of a device, and which operations it is made of.
struct Module {
    std::set<uint32_t> capabilities;
    std::set<uint32_t> operations;
    std::set<uint32_t> widths; ///< of integers [bit]
};

Module read(const std::vector<uint32_t>& spirv) {
    Module module;
    for (size_t i = 5; i < spirv.size(); i += spirv[i] >> 16) {
        const uint32_t operation = spirv[i] & 0xffffu;
        module.operations.insert(operation);
        if (operation == opCapability) module.capabilities.insert(spirv[i + 1]);
        if (operation == opTypeInt) module.widths.insert(spirv[i + 2]);
    }
    return module;
}

TEST_F(Atomics, AreThoseOfBuffersThatEveryDeviceHas) {
    if (requirements().features.shaderFloat64) GTEST_SKIP() << "hostile arithmetic, which takes doubles";
    bool scatters = false;
    for (const ReflectionTechnique technique :
         {ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid}) {
        Reflector* reflector = nullptr;
        const ReflectorDesc desc = with(technique);
        spiedCalls().clear();
        ASSERT_EQ(createReflector(context(), &desc, &reflector), Status::ok) << message();
        size_t modules = 0;
        for (const SpiedCall& call : spiedCalls()) {
            if (call.name != "CreateShaderModule") continue;
            ++modules;
            const Module module = read(call.spirv);
            scatters = scatters || module.operations.contains(opAtomicUMax);
            // An atomic on an image would take one of these, a wider or a float one a capability.
            EXPECT_FALSE(module.operations.contains(opImageTexelPointer));
            EXPECT_FALSE(module.widths.contains(64));
            for (const uint32_t capability : module.capabilities)
                EXPECT_TRUE(capability == capabilityShader || capability == capabilityImageQuery ||
                            capability == capabilityStorageImageExtendedFormats)
                    << capability;
        }
        EXPECT_GT(modules, 0u);
        destroyReflector(reflector);
        frame([](VkCommandBuffer) {});
        frame([](VkCommandBuffer) {});
    }
    EXPECT_TRUE(scatters); // else nothing was looked at
}

TEST_F(Atomics, GatheringAlongRaysFindsWhatScatteringFinds) {
    for (const Pose& pose : poses()) {
        if (pose.name == std::string("steep")) continue; // where strides are two pixels off
        const TracedView traced = Tracer(pose.camera, harbourOfBoxes()).run();
        const Reflected scattered = reflectScene(pose.camera, traced, with(ReflectionTechnique::sspr));
        const Reflected gathered = reflectScene(pose.camera, traced, with(ReflectionTechnique::ssr));
        const glm::vec2 size(traced.width, traced.height);
        const auto place = [&](const Reflected& r, size_t i) {
            return glm::vec2(r.color[i * 4], r.color[i * 4 + 1]) / r.color[i * 4 + 3] * size;
        };
        size_t scatteredHits = 0, both = 0, apart = 0;
        for (size_t i = 0; i < traced.truth.size(); ++i) {
            if (traced.truth[i] != Truth::recoverable || !(scattered.color[i * 4 + 3] > 0.1f)) continue;
            ++scatteredHits;
            if (!(gathered.color[i * 4 + 3] > 0.1f)) continue;
            ++both;
            apart += glm::length(place(scattered, i) - place(gathered, i)) > 1.5f;
        }
        std::printf("%s: of %zu hits %zu in both, %zu apart\n", pose.name, scatteredHits, both, apart);
        EXPECT_GT(static_cast<double>(both), 0.96 * static_cast<double>(scatteredHits)) << pose.name;
        EXPECT_LT(static_cast<double>(apart), 0.02 * static_cast<double>(both)) << pose.name;
    }
}

} // namespace
