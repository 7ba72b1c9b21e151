#include "tests/null/null_device.h"

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "seaglass/host.h"

namespace tests {

namespace {

constexpr const char* family = "navi21"; ///< RDNA 2, of consoles and of cards from 2020 on

/// While it lives.
class EnvironmentVariable {
  public:
    EnvironmentVariable(const char* name, const std::string& value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~EnvironmentVariable() {
        if (before_)
            setenv(name_, before_->c_str(), 1);
        else
            unsetenv(name_);
    }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

/// Where the loader looks for drivers on Linux.
std::string driverFile() {
    for (const char* const folder :
         {"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d"}) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(folder, none))
            if (entry.path().filename().string().starts_with("radeon_icd")) return entry.path();
    }
    return {};
}

} // namespace

std::unique_ptr<NullDevice> NullDevice::create(std::string& whyNot) {
    const std::string driver = driverFile();
    if (driver.empty()) {
        whyNot = "no radeon_icd*.json among /usr/share/vulkan/icd.d, expected Mesa's Vulkan drivers";
        return nullptr;
    }
    std::unique_ptr<NullDevice> device(new NullDevice);
    const EnvironmentVariable files("VK_DRIVER_FILES", driver), olderLoaders("VK_ICD_FILENAMES", driver),
        forced("RADV_FORCE_FAMILY", family);
    if (!device->createInstance(whyNot) || !device->createDevice(whyNot)) return nullptr;
    return device;
}

NullDevice::~NullDevice() {
    if (device_) table_.vkDestroyDevice(device_, nullptr);
    if (instance_) load<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, nullptr);
}

bool NullDevice::createInstance(std::string& whyNot) {
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    if (volkInitialize() != VK_SUCCESS || vkCreateInstance(&info, nullptr, &instance_) != VK_SUCCESS) {
        whyNot = "Mesa's driver for AMD makes no instance";
        return false;
    }
    uint32_t count = 1;
    load<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices")(instance_, &count, &physical_);
    if (count == 0) {
        whyNot = std::string("Mesa's driver for AMD knows nothing of RADV_FORCE_FAMILY=") + family;
        return false;
    }
    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    load<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(physical_, &properties);
    name_ = std::string(properties.properties.deviceName) + ", " + driver.driverInfo;
    type_ = properties.properties.deviceType;
    return true;
}

bool NullDevice::createDevice(std::string& whyNot) {
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
    statistics.pipelineExecutableInfo = VK_TRUE;
    VkPhysicalDeviceVulkan11Features features11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES,
                                                &statistics};
    features11.multiview = VK_TRUE;
    seaglass::Requirements needs = seaglass::requirements();
    needs.features13.dynamicRendering = VK_TRUE;
    needs.features13.pNext = &features11;
    const VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &needs.features13,
                                             needs.features};
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    if (load<PFN_vkCreateDevice>("vkCreateDevice")(physical_, &info, nullptr, &device_) != VK_SUCCESS) {
        whyNot = name_ + " lacks what seaglass::requirements() names, or " + extension;
        return false;
    }
    // volk's own loader of tables asks the instance that it was last given.
    const auto get = load<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
#define LOAD(function) table_.function = reinterpret_cast<PFN_##function>(get(device_, #function))
    LOAD(vkDestroyDevice);
    LOAD(vkCreateShaderModule);
    LOAD(vkDestroyShaderModule);
    LOAD(vkCreateDescriptorSetLayout);
    LOAD(vkDestroyDescriptorSetLayout);
    LOAD(vkCreatePipelineLayout);
    LOAD(vkDestroyPipelineLayout);
    LOAD(vkCreateComputePipelines);
    LOAD(vkCreateGraphicsPipelines);
    LOAD(vkDestroyPipeline);
    LOAD(vkGetPipelineExecutablePropertiesKHR);
    LOAD(vkGetPipelineExecutableStatisticsKHR);
#undef LOAD
    return true;
}

} // namespace tests
