// What frame debuggers and validation messages show: all that the library makes has a name, and each pass a
// label, where the host's instance has VK_EXT_debug_utils; elsewhere the same picture.
#include <cstring>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "tests/gpu/host/host_shape.h"
#include "tests/gpu/rig/rig.h"

namespace {

using namespace seaglass;
using namespace tests;

/// What a context's debugger has heard. One for the program: tests run one at a time.
struct Heard {
    std::map<uint64_t, std::string> made;  ///< handles that exist or did, by the call that made them
    std::map<uint64_t, std::string> named; ///< of these, since they were made
    std::vector<std::string> labels;       ///< as they began
    int open = 0;                          ///< labels that have not ended
    bool extension = true;                 ///< whether its functions are found
};

Heard& heard() {
    static Heard all;
    return all;
}

template<typename Handle>
uint64_t bitsOf(Handle handle) {
    uint64_t bits = 0;
    std::memcpy(&bits, &handle, sizeof handle);
    return bits;
}

/// Calls that make something hand it out by their last argument.
template<auto* real, class... Arguments>
struct Making {
    static inline const char* name = nullptr;
    static VkResult VKAPI_CALL call(Arguments... arguments) {
        const VkResult result = (*real)(arguments...);
        if (result != VK_SUCCESS) return result;
        const uint64_t handle = bitsOf(*std::get<sizeof...(Arguments) - 1>(std::tuple(arguments...)));
        heard().made[handle] = name;
        heard().named.erase(handle);
        return result;
    }
};

template<auto* real, class... Arguments>
PFN_vkVoidFunction listenTo(const char* name, VkResult(VKAPI_PTR*)(Arguments...)) {
    Making<real, Arguments...>::name = name;
    return reinterpret_cast<PFN_vkVoidFunction>(&Making<real, Arguments...>::call);
}

VkResult VKAPI_CALL setName(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info) {
    heard().named[info->objectHandle] = info->pObjectName;
    return vkSetDebugUtilsObjectNameEXT(device, info);
}

void VKAPI_CALL beginLabel(VkCommandBuffer commands, const VkDebugUtilsLabelEXT* label) {
    heard().labels.emplace_back(label->pLabelName);
    ++heard().open;
    vkCmdBeginDebugUtilsLabelEXT(commands, label);
}

void VKAPI_CALL endLabel(VkCommandBuffer commands) {
    --heard().open;
    vkCmdEndDebugUtilsLabelEXT(commands);
}

PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name) {
#define LISTEN(function)                                                                                     \
    if (!std::strcmp(name, "vk" #function)) return listenTo<&vk##function>(#function, vk##function);
    LISTEN(AllocateDescriptorSets)
    LISTEN(AllocateMemory)
    LISTEN(CreateBuffer)
    LISTEN(CreateComputePipelines)
    LISTEN(CreateDescriptorPool)
    LISTEN(CreateDescriptorSetLayout)
    LISTEN(CreateGraphicsPipelines)
    LISTEN(CreateImage)
    LISTEN(CreateImageView)
    LISTEN(CreatePipelineLayout)
    LISTEN(CreateSampler)
    LISTEN(CreateShaderModule)
#undef LISTEN
    return vkGetDeviceProcAddr(device, name);
}

PFN_vkVoidFunction VKAPI_CALL instanceFunction(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&deviceFunction);
    if (std::strstr(name, "DebugUtils") && !heard().extension) return nullptr;
    if (!std::strcmp(name, "vkSetDebugUtilsObjectNameEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&setName);
    if (!std::strcmp(name, "vkCmdBeginDebugUtilsLabelEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&beginLabel);
    if (!std::strcmp(name, "vkCmdEndDebugUtilsLabelEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&endLabel);
    return vkGetInstanceProcAddr(instance, name);
}

void notePass(void* user, VkCommandBuffer, const char* pass, bool begins) {
    if (begins) static_cast<std::vector<std::string>*>(user)->push_back(std::string("seaglass: ") + pass);
}

Picture pictureHeard(std::vector<std::string>& passes) {
    ShapedHost host(device(), {}, true, [&](DeviceDesc& desc) {
        desc.getInstanceProcAddr = instanceFunction;
        desc.pass = {notePass, &passes};
    });
    return host.picture(shoreCamera());
}

TEST(DebugNames, AllThatIsMadeAndEachPassHasOne) {
    device(); // loads them
    if (!vkSetDebugUtilsObjectNameEXT) GTEST_SKIP() << "the instance has no VK_EXT_debug_utils";
    heard() = {};
    std::vector<std::string> passes;
    const Picture with = pictureHeard(passes);
    EXPECT_GT(heard().made.size(), 100u);
    for (const auto& [handle, call] : heard().made)
        EXPECT_EQ(heard().named[handle].rfind("seaglass: ", 0), 0u)
            << "made by vk" << call << ", named '" << heard().named[handle] << "'";
    EXPECT_FALSE(passes.empty());
    EXPECT_EQ(heard().labels, passes);
    EXPECT_EQ(heard().open, 0);

    heard() = {};
    heard().extension = false;
    passes.clear();
    EXPECT_EQ(pictureHeard(passes), with);
    EXPECT_TRUE(heard().named.empty());
    EXPECT_TRUE(heard().labels.empty());
}

} // namespace
