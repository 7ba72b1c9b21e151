#include "host/vulkan/device.h"
#include "host/host.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "host/ascii.h"
#include "host/timing/pass_clock.h"
#include "seaglass/host.h"

namespace demos {
namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

/// Of the clock, or of what this process had of the processors.
double nowMs(bool processor) {
    if (processor) return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

const char* resultName(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialisation failed";
    case VK_ERROR_DEVICE_LOST:
        return "device lost";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "no driver";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return "format not supported";
    case VK_TIMEOUT:
        return "timed out";
    default:
        return nullptr;
    }
}

VkBool32 VKAPI_PTR onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                             const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<std::atomic<uint32_t>*>(user)->fetch_add(1);
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(std::atomic<uint32_t>* counter, bool bestPractices) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    if (bestPractices) info.messageType |= VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = counter;
    return info;
}

bool layerInstalled(const char* wanted) {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(), [&](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, wanted) == 0;
    });
}

/// Makes an instance of Vulkan 1.3; counts validation messages in `messages` where that is not null.
VkInstance makeInstance(std::atomic<uint32_t>* messages, bool bestPractices,
                        const std::vector<std::string>& windowExtensions, Error& error) {
    if (volkInitialize() != VK_SUCCESS) {
        error.text = "no Vulkan loader: libvulkan.so.1 was not found";
        return VK_NULL_HANDLE;
    }
    if (volkGetInstanceVersion() < VK_API_VERSION_1_3) {
        error.text = "the Vulkan loader is older than 1.3";
        return VK_NULL_HANDLE;
    }
    if (messages && !layerInstalled(validationLayer)) {
        error.text = "validation was asked for, but ";
        error.text.append(validationLayer).append(" is not installed");
        return VK_NULL_HANDLE;
    }
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "seaglass";
    application.apiVersion = VK_API_VERSION_1_3;

    const VkValidationFeatureEnableEXT enabled[] = {
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT,
        VK_VALIDATION_FEATURE_ENABLE_BEST_PRACTICES_EXT};
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = bestPractices ? 2 : 1;
    features.pEnabledValidationFeatures = enabled;
    const VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(messages, bestPractices);
    features.pNext = &messenger; // hears what happens in vkCreateInstance and vkDestroyInstance

    const char* const layers[] = {validationLayer};
    std::vector<const char*> extensions;
    for (const std::string& name : windowExtensions) extensions.push_back(name.c_str());
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    if (messages) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = layers;
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
        error.text = "no Vulkan driver is installed";
        return VK_NULL_HANDLE;
    }
    if (!succeeded(result, "vkCreateInstance", error)) return VK_NULL_HANDLE;
    // Loaded from the instance, not from a device: the loader's entry points dispatch by handle, so that
    // hosts on several devices can live side by side.
    volkLoadInstance(instance);
    return instance;
}

const char* typeName(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "cpu";
    default:
        return "other";
    }
}

int rank(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return 3;
    default:
        return 4;
    }
}

constexpr uint64_t nsInS = 1'000'000'000;
/// Between two looks at which pass the device is in. Drivers of GPUs wait for a hung pass for seconds.
constexpr uint64_t betweenLooksNs = nsInS / 4;

/// Seconds after which a submission is taken for one that will not end. Drivers of GPUs give up sooner as a
/// rule; a CPU device may need minutes for a large frame.
uint64_t patienceS(VkPhysicalDeviceType type) {
    return type == VK_PHYSICAL_DEVICE_TYPE_CPU ? 3600 : 30;
}

uint32_t graphicsFamily(VkPhysicalDevice physical, uint32_t& timestampBits, uint32_t passedOver = 0) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    const VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & needed) != needed || passedOver-- > 0) continue;
        timestampBits = families[i].timestampValidBits;
        return i;
    }
    return UINT32_MAX;
}

bool formatHas(VkPhysicalDevice physical, VkFormat format, VkFormatFeatureFlags needed) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(physical, format, &properties);
    return (properties.optimalTilingFeatures & needed) == needed;
}

/// What the host itself is missing on a device; empty when nothing.
std::string missingForHost(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& properties) {
    if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
    uint32_t timestampBits = 0;
    if (graphicsFamily(physical, timestampBits) == UINT32_MAX) return "a queue for graphics and compute";
    if (!formatHas(physical, VK_FORMAT_R16G16B16A16_SFLOAT,
                   VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT |
                       VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
        return "blendable, filtered RGBA16F";
    if (!formatHas(physical, VK_FORMAT_D32_SFLOAT,
                   VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT))
        return "sampled D32 depth";
    return {};
}

DeviceInfo describe(VkInstance instance, VkPhysicalDevice physical) {
    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    DeviceInfo info;
    info.name = properties.properties.deviceName;
    info.longestSide = properties.properties.limits.maxImageDimension2D;
    info.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    info.type = typeName(properties.properties.deviceType);
    info.whyNot = missingForHost(physical, properties.properties);
    if (!info.whyNot.empty()) return info;
    seaglass::MessageCallback message;
    message.user = &info.whyNot;
    message.function = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
    const seaglass::Status status =
        seaglass::checkSupport(instance, physical, vkGetInstanceProcAddr, message);
    info.supported = status == seaglass::Status::ok;
    if (!info.supported && info.whyNot.empty()) info.whyNot = seaglass::toString(status);
    return info;
}

/// Every device of the instance, best first.
std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance) {
    uint32_t count = 0;
    if (vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> devices(count);
    vkEnumeratePhysicalDevices(instance, &count, devices.data());
    std::stable_sort(devices.begin(), devices.end(), [](VkPhysicalDevice a, VkPhysicalDevice b) {
        VkPhysicalDeviceProperties pa{}, pb{};
        vkGetPhysicalDeviceProperties(a, &pa);
        vkGetPhysicalDeviceProperties(b, &pb);
        return rank(pa.deviceType) < rank(pb.deviceType);
    });
    return devices;
}

} // namespace

bool succeeded(VkResult result, const char* what, Error& error) {
    if (result == VK_SUCCESS) return true;
    const char* const name = resultName(result);
    error.text =
        std::string(what) + " failed: " + (name ? name : ("VkResult " + std::to_string(result)).c_str());
    return false;
}

std::vector<DeviceInfo> listDevices(Error& error) {
    const VkInstance instance = makeInstance(nullptr, false, {}, error);
    if (!instance) return {};
    std::vector<DeviceInfo> infos;
    for (const VkPhysicalDevice physical : physicalDevices(instance))
        infos.push_back(describe(instance, physical));
    if (infos.empty()) error.text = "no Vulkan device was found";
    vkDestroyInstance(instance, nullptr);
    return infos;
}

std::unique_ptr<Device> Device::create(const HostDesc& desc, Error& error, const DeviceShape& shape) {
    std::unique_ptr<Device> device(new Device);
    if (!device->createInstance(desc, error) || !device->choosePhysical(desc.device, error) ||
        !device->createDevice(desc, shape, error))
        return nullptr;
    return device;
}

Device::~Device() {
    if (lost_) return; // to destroy it is to wait for it
    if (device_) vkDeviceWaitIdle(device_);
    passes_ = {};
    fence_.reset();
    pool_.reset();
    if (device_) vkDestroyDevice(device_, nullptr);
    if (messenger_) {
        // By this instance: the last that was made has the function only where it validates, too.
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    if (instance_) vkDestroyInstance(instance_, nullptr);
}

bool Device::createInstance(const HostDesc& desc, Error& error) {
    instance_ = makeInstance(desc.validation ? &validationMessages_ : nullptr, desc.bestPractices,
                             desc.windowExtensions, error);
    if (!instance_) return false;
    if (!desc.validation) return true;
    const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(&validationMessages_, desc.bestPractices);
    return succeeded(vkCreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_),
                     "vkCreateDebugUtilsMessengerEXT", error);
}

bool Device::choosePhysical(const std::string& wanted, Error& error) {
    std::string others;
    for (const VkPhysicalDevice physical : physicalDevices(instance_)) {
        const DeviceInfo info = describe(instance_, physical);
        const bool named = lowerCase(info.name).find(lowerCase(wanted)) != std::string::npos;
        if (named && info.supported) {
            physical_ = physical;
            info_ = info;
            vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
            VkPhysicalDeviceMaintenance3Properties limits{
                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
            VkPhysicalDeviceProperties2 properties{
                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &limits, {}};
            vkGetPhysicalDeviceProperties2(physical_, &properties);
            properties_ = properties.properties;
            maxAllocation_ = limits.maxMemoryAllocationSize;
            return true;
        }
        others += (others.empty() ? "" : ", ") + info.name;
        if (!info.supported) others += " (lacks " + info.whyNot + ")";
    }
    if (others.empty())
        error.text = "no Vulkan device was found";
    else if (wanted.empty())
        error.text = "no usable Vulkan device among: " + others;
    else
        error.text = "no usable Vulkan device is named \"" + wanted + "\"; there are: " + others;
    return false;
}

bool Device::createDevice(const HostDesc& desc, const DeviceShape& shape, Error& error) {
    seaglass::Requirements needs = seaglass::requirements();
    VkPhysicalDeviceVulkan11Features features11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    if (shape.multiview) {
        features11.multiview = VK_TRUE;
        needs.features13.pNext = &features11;
    }
    if (!shape.onlyRequired) {
        needs.features13.dynamicRendering = VK_TRUE;
        needs.features13.synchronization2 = VK_TRUE;
        VkPhysicalDeviceFeatures available{};
        vkGetPhysicalDeviceFeatures(physical_, &available);
        anisotropy_ = available.samplerAnisotropy;
        needs.features.samplerAnisotropy = available.samplerAnisotropy;
    }
    uint32_t timestampBits = 0;
    queueFamily_ = graphicsFamily(physical_, timestampBits, shape.familiesPassedOver);
    if (queueFamily_ == UINT32_MAX) {
        error.text = "the device has no further queue family that draws and computes";
        return false;
    }
    return makeDevice(needs, !desc.windowExtensions.empty(), error) && createCommands(error) &&
           createTimer(desc.clock, timestampBits, error);
}

bool Device::makeDevice(const seaglass::Requirements& needs, bool forWindows, Error& error) {
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = queueFamily_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan13Features features13 = needs.features13;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13,
                                       needs.features};
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    const char* const swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    info.enabledExtensionCount = forWindows ? 1 : 0;
    info.ppEnabledExtensionNames = &swapchain;
    const VkResult created = vkCreateDevice(physical_, &info, nullptr, &device_);
    if (created == VK_ERROR_EXTENSION_NOT_PRESENT) {
        error.text = info_.name + " cannot draw into windows: it lacks " + swapchain;
        return false;
    }
    if (!succeeded(created, "vkCreateDevice", error)) return false;
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
    return true;
}

bool Device::createCommands(Error& error) {
    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.queueFamilyIndex = queueFamily_;
    VkCommandPool pool = VK_NULL_HANDLE;
    if (!succeeded(vkCreateCommandPool(device_, &poolInfo, nullptr, &pool), "vkCreateCommandPool", error))
        return false;
    pool_ = UniqueCommandPool(device_, pool);
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    if (!succeeded(vkAllocateCommandBuffers(device_, &allocate, &commands_), "vkAllocateCommandBuffers",
                   error))
        return false;
    const VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    if (!succeeded(vkCreateFence(device_, &fenceInfo, nullptr, &fence), "vkCreateFence", error)) return false;
    fence_ = UniqueFence(device_, fence);
    return true;
}

bool Device::createTimer(PassClock wanted, uint32_t timestampBits, Error& error) {
    hasTimestamps_ = timestampBits > 0;
    clock_ = clockOf(wanted, properties_.deviceType, hasTimestamps_);
    const double tickNs = hasTimestamps_ ? static_cast<double>(properties_.limits.timestampPeriod) : 0;
    return passes_.create(device_, tickNs, timestampBits,
                          properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU, error);
}

uint32_t Device::memoryType(uint32_t allowed, VkMemoryPropertyFlags required,
                            VkMemoryPropertyFlags preferred) const {
    uint32_t found = UINT32_MAX;
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        const VkMemoryPropertyFlags flags = memory_.memoryTypes[i].propertyFlags;
        if (!(allowed & (1u << i)) || (flags & required) != required) continue;
        if ((flags & preferred) == preferred) return i;
        if (found == UINT32_MAX) found = i;
    }
    return found;
}

VkDeviceSize Device::heapSize(uint32_t memoryType) const {
    return memory_.memoryHeaps[memory_.memoryTypes[memoryType].heapIndex].size;
}

VkDeviceSize Device::largestHeap() const {
    VkDeviceSize largest = 0;
    for (uint32_t i = 0; i < memory_.memoryHeapCount; ++i)
        if (memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            largest = std::max(largest, memory_.memoryHeaps[i].size);
    return largest;
}

bool Device::run(const std::function<bool(VkCommandBuffer, Error&)>& record, Error& error) {
    if (!checked(vkResetCommandPool(device_, pool_.get(), 0), "vkResetCommandPool", error)) return false;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    if (!succeeded(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer", error)) return false;
    passes_.begin(commands_);
    const bool recorded = record(commands_, error);
    passes_.end();
    const VkResult ended = vkEndCommandBuffer(commands_);
    return recorded && succeeded(ended, "vkEndCommandBuffer", error) && submit(error);
}

bool Device::submit(Error& error) {
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    const bool processor = clock_ == PassClock::processor;
    const double start = nowMs(processor);
    if (!checked(vkQueueSubmit2(queue_, 1, &submit, fence_.get()), "vkQueueSubmit2", error)) return false;
    const bool done = waitFor(fence_.get(), error);
    lastRunMs_ = nowMs(processor) - start;
    return done;
}

// Of a lost device queries may be out of reach, so they are read while it still works.
bool Device::waitFor(VkFence fence, Error& error) {
    seenIn_.clear();
    VkResult waited = VK_TIMEOUT;
    for (uint64_t ns = 0; waited == VK_TIMEOUT && ns < patienceNs(); ns += betweenLooksNs) {
        waited = vkWaitForFences(device_, 1, &fence, VK_TRUE, betweenLooksNs);
        if (waited == VK_TIMEOUT) seenIn_ = passes_.unfinished().value_or(seenIn_);
    }
    return checked(waited, "vkWaitForFences", error) &&
           succeeded(vkResetFences(device_, 1, &fence), "vkResetFences", error);
}

uint64_t Device::patienceNs() const {
    return nsInS * patienceS(properties_.deviceType);
}

bool Device::checked(VkResult result, const char* what, Error& error) {
    lost_ |= result == VK_ERROR_DEVICE_LOST || result == VK_TIMEOUT;
    if (!lost_) return succeeded(result, what, error);
    error.text = info_.name + (result == VK_TIMEOUT ? " hung" : " was lost") + " in " + whereItStopped();
    if (result == VK_TIMEOUT)
        error.text += ": not done after " + std::to_string(patienceS(properties_.deviceType)) + " s";
    return false;
}

std::string Device::whereItStopped() const {
    constexpr const char* unknown = "no pass that is known";
    if (const std::optional<std::string> pass = passes_.unfinished()) return pass->empty() ? unknown : *pass;
    if (!seenIn_.empty()) return seenIn_ + ", where it was last seen";
    const std::string submitted = passes_.outermost();
    return submitted.empty() ? unknown : submitted + "; the device no longer tells in which pass of it";
}

} // namespace demos
