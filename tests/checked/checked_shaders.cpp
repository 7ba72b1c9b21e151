// A Vulkan layer under which shaders note where they do what Vulkan leaves open. When a device goes, what
// they noted is written to stderr, or to the end of the file that SEAGLASS_VIOLATIONS names.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>

#include "tests/checked/checked_shader.h"
#include "tests/layer_link.h"

namespace {

constexpr size_t noteWords = 1 << 20;

/// Of the layer below.
struct NextDevice {
    PFN_vkGetDeviceProcAddr GetDeviceProcAddr = nullptr;
    PFN_vkDestroyDevice DestroyDevice = nullptr;
    PFN_vkCreateShaderModule CreateShaderModule = nullptr;
    PFN_vkCreateBuffer CreateBuffer = nullptr;
    PFN_vkDestroyBuffer DestroyBuffer = nullptr;
    PFN_vkGetBufferMemoryRequirements GetBufferMemoryRequirements = nullptr;
    PFN_vkAllocateMemory AllocateMemory = nullptr;
    PFN_vkFreeMemory FreeMemory = nullptr;
    PFN_vkBindBufferMemory BindBufferMemory = nullptr;
    PFN_vkMapMemory MapMemory = nullptr;
    PFN_vkGetBufferDeviceAddress GetBufferDeviceAddress = nullptr;
};

struct NotedShader {
    tests::CheckedShader shader;
    size_t firstWord = 0;
};

/// A device, and the buffer that its shaders write into.
class NotedDevice {
  public:
    VkResult create(VkDevice device, const NextDevice& next, const VkPhysicalDeviceMemoryProperties& memory);
    void destroy(const VkAllocationCallbacks* allocator);
    VkResult createShaderModule(const VkShaderModuleCreateInfo& info, const VkAllocationCallbacks* allocator,
                                VkShaderModule* out);
    void report() const;
    const NextDevice& next() const { return next_; }

  private:
    const NotedShader* noted(const VkShaderModuleCreateInfo& info);

    VkDevice device_ = VK_NULL_HANDLE;
    NextDevice next_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceAddress address_ = 0;
    uint32_t* notes_ = nullptr;
    size_t wordsUsed_ = 0;
    std::mutex mutex_;
    std::map<std::vector<uint32_t>, NotedShader> shaders_; ///< by the words that the application gave
    size_t leftAlone_ = 0;
};

VkResult NotedDevice::create(VkDevice device, const NextDevice& next,
                             const VkPhysicalDeviceMemoryProperties& memory) {
    device_ = device;
    next_ = next;
    VkBufferCreateInfo bufferInfo{};
    bufferInfo.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    bufferInfo.size = noteWords * sizeof(uint32_t);
    bufferInfo.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    VkResult result = next_.CreateBuffer(device_, &bufferInfo, nullptr, &buffer_);
    if (result != VK_SUCCESS) return result;
    VkMemoryRequirements needs{};
    next_.GetBufferMemoryRequirements(device_, buffer_, &needs);
    constexpr VkMemoryPropertyFlags read =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    uint32_t type = 0;
    while (type < memory.memoryTypeCount &&
           (!(needs.memoryTypeBits >> type & 1u) || (memory.memoryTypes[type].propertyFlags & read) != read))
        ++type;
    VkMemoryAllocateFlagsInfo flags{};
    flags.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO;
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    VkMemoryAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.pNext = &flags;
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex = type;
    result = next_.AllocateMemory(device_, &allocation, nullptr, &memory_);
    if (result == VK_SUCCESS) result = next_.BindBufferMemory(device_, buffer_, memory_, 0);
    void* mapped = nullptr;
    if (result == VK_SUCCESS) result = next_.MapMemory(device_, memory_, 0, VK_WHOLE_SIZE, 0, &mapped);
    if (result != VK_SUCCESS) return result;
    std::memset(mapped, 0, noteWords * sizeof(uint32_t));
    notes_ = static_cast<uint32_t*>(mapped);
    VkBufferDeviceAddressInfo addressed{};
    addressed.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
    addressed.buffer = buffer_;
    address_ = next_.GetBufferDeviceAddress(device_, &addressed);
    return VK_SUCCESS;
}

void NotedDevice::destroy(const VkAllocationCallbacks* allocator) {
    next_.DestroyBuffer(device_, buffer_, nullptr);
    next_.FreeMemory(device_, memory_, nullptr);
    next_.DestroyDevice(device_, allocator);
}

/// Null for what cannot be checked.
const NotedShader* NotedDevice::noted(const VkShaderModuleCreateInfo& info) {
    const std::lock_guard lock(mutex_);
    const std::vector<uint32_t> words(info.pCode, info.pCode + info.codeSize / sizeof(uint32_t));
    if (const auto known = shaders_.find(words); known != shaders_.end()) return &known->second;
    const size_t first = wordsUsed_;
    bool fits = true;
    std::optional<tests::CheckedShader> shader = tests::checkedShader(words, [&](size_t count) {
        fits = wordsUsed_ + count <= noteWords;
        if (fits) wordsUsed_ += count;
        return address_ + first * sizeof(uint32_t);
    });
    if (!shader || !fits) {
        ++leftAlone_;
        return nullptr;
    }
    return &shaders_.emplace(words, NotedShader{std::move(*shader), first}).first->second;
}

VkResult NotedDevice::createShaderModule(const VkShaderModuleCreateInfo& info,
                                         const VkAllocationCallbacks* allocator, VkShaderModule* out) {
    VkShaderModuleCreateInfo checked = info;
    if (const NotedShader* const noting = noted(info)) {
        checked.codeSize = noting->shader.spirv.size() * sizeof(uint32_t);
        checked.pCode = noting->shader.spirv.data();
    }
    return next_.CreateShaderModule(device_, &checked, allocator, out);
}

void NotedDevice::report() const {
    const char* const name = std::getenv("SEAGLASS_VIOLATIONS");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(name ? std::fopen(name, "a") : nullptr,
                                                               [](std::FILE* f) { return std::fclose(f); });
    std::FILE* const out = file ? file.get() : stderr;
    size_t places = 0, violated = 0;
    for (const auto& [words, noting] : shaders_) {
        const tests::CheckedShader& shader = noting.shader;
        const std::span<const uint32_t> notes(notes_ + noting.firstWord, shader.noteWords());
        places += shader.places.size();
        for (size_t i = 0; i < shader.places.size(); ++i) {
            if (!tests::CheckedShader::noted(notes, i)) continue;
            ++violated;
            const tests::CheckedPlace& place = shader.places[i];
            std::fprintf(out, "violation: %s: %s shader, %s()%s%s; %u invocations of it had any\n",
                         place.violation.c_str(), shader.stage.c_str(), place.function.c_str(),
                         place.line.empty() ? "" : ", ", place.line.c_str(), notes[0]);
        }
    }
    std::fprintf(out, "checked %zu shaders in %zu places: %zu violated; left %zu shaders alone\n",
                 shaders_.size(), places, violated, leftAlone_);
}

std::mutex devicesMutex;
std::map<VkDevice, std::unique_ptr<NotedDevice>> devices;
// The application makes one instance at a time.
PFN_vkGetInstanceProcAddr nextInstanceProcAddr = nullptr;
PFN_vkGetPhysicalDeviceMemoryProperties nextMemoryProperties = nullptr;

NotedDevice& noted(VkDevice device) {
    const std::lock_guard lock(devicesMutex);
    return *devices.at(device);
}

template<class Info>
Info* chained(const void* next, VkStructureType type) {
    auto* at = static_cast<VkBaseOutStructure*>(const_cast<void*>(next));
    while (at && at->sType != type) at = at->pNext;
    return reinterpret_cast<Info*>(at);
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* out) {
    const auto* const link = tests::takeLink<VkLayerInstanceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    nextInstanceProcAddr = link->pfnNextGetInstanceProcAddr;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, out);
    if (result != VK_SUCCESS) return result;
    nextMemoryProperties = reinterpret_cast<PFN_vkGetPhysicalDeviceMemoryProperties>(
        nextInstanceProcAddr(*out, "vkGetPhysicalDeviceMemoryProperties"));
    return VK_SUCCESS;
}

bool load(NextDevice& next, VkDevice device, PFN_vkGetDeviceProcAddr procAddr) {
    bool found = true;
    const auto find = [&](const char* name, auto& out) {
        out = reinterpret_cast<std::remove_reference_t<decltype(out)>>(procAddr(device, name));
        found = found && out;
    };
    next.GetDeviceProcAddr = procAddr;
#define FIND(name) find("vk" #name, next.name)
    FIND(DestroyDevice);
    FIND(CreateShaderModule);
    FIND(CreateBuffer);
    FIND(DestroyBuffer);
    FIND(GetBufferMemoryRequirements);
    FIND(AllocateMemory);
    FIND(FreeMemory);
    FIND(BindBufferMemory);
    FIND(MapMemory);
    FIND(GetBufferDeviceAddress);
#undef FIND
    return found;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* out) {
    const auto* const link =
        tests::takeLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    // The application's own structs are written to: a chain cannot hold a second of a kind.
    VkDeviceCreateInfo more = *info;
    VkPhysicalDeviceFeatures features =
        info->pEnabledFeatures ? *info->pEnabledFeatures : VkPhysicalDeviceFeatures{};
    auto* const features2 =
        chained<VkPhysicalDeviceFeatures2>(info->pNext, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceFeatures& enabled = features2 ? features2->features : features;
    enabled.fragmentStoresAndAtomics = enabled.vertexPipelineStoresAndAtomics = VK_TRUE;
    if (!features2) more.pEnabledFeatures = &features;
    VkPhysicalDeviceBufferDeviceAddressFeatures addresses{};
    addresses.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES;
    addresses.pNext = const_cast<void*>(info->pNext);
    addresses.bufferDeviceAddress = VK_TRUE;
    if (auto* const features12 = chained<VkPhysicalDeviceVulkan12Features>(
            info->pNext, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES))
        features12->bufferDeviceAddress = VK_TRUE;
    else if (auto* const own =
                 chained<VkPhysicalDeviceBufferDeviceAddressFeatures>(info->pNext, addresses.sType))
        own->bufferDeviceAddress = VK_TRUE;
    else
        more.pNext = &addresses;

    const PFN_vkGetDeviceProcAddr procAddr = link->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->pfnNextGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
    VkResult result = create(physical, &more, allocator, out);
    if (result != VK_SUCCESS) return result;
    NextDevice next;
    if (!load(next, *out, procAddr)) return VK_ERROR_INITIALIZATION_FAILED;
    VkPhysicalDeviceMemoryProperties memory{};
    nextMemoryProperties(physical, &memory);
    auto device = std::make_unique<NotedDevice>();
    result = device->create(*out, next, memory);
    if (result != VK_SUCCESS) return result;
    const std::lock_guard lock(devicesMutex);
    devices[*out] = std::move(device);
    return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* allocator) {
    if (!device) return;
    std::unique_ptr<NotedDevice> gone;
    {
        const std::lock_guard lock(devicesMutex);
        const auto at = devices.find(device);
        gone = std::move(at->second);
        devices.erase(at);
    }
    gone->report();
    gone->destroy(allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator,
                                                  VkShaderModule* out) {
    return noted(device).createShaderModule(*info, allocator, out);
}

PFN_vkVoidFunction ownDeviceFunction(const char* name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
    if (const PFN_vkVoidFunction own = ownDeviceFunction(name)) return own;
    return noted(device).next().GetDeviceProcAddr(device, name);
}

PFN_vkVoidFunction ownDeviceFunction(const char* name) {
    if (!std::strcmp(name, "vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(deviceProcAddr);
    if (!std::strcmp(name, "vkDestroyDevice")) return reinterpret_cast<PFN_vkVoidFunction>(destroyDevice);
    if (!std::strcmp(name, "vkCreateShaderModule"))
        return reinterpret_cast<PFN_vkVoidFunction>(createShaderModule);
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetInstanceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(instanceProcAddr);
    if (!std::strcmp(name, "vkCreateInstance")) return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (!std::strcmp(name, "vkCreateDevice")) return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
    if (const PFN_vkVoidFunction own = ownDeviceFunction(name)) return own;
    return nextInstanceProcAddr ? nextInstanceProcAddr(instance, name) : nullptr;
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* negotiation) {
    return tests::negotiate(negotiation, instanceProcAddr, deviceProcAddr);
}
