#include "gpu/dispatch.h"

namespace seaglass::gpu {

const char* load(InstanceTable& table, VkInstance instance, PFN_vkGetInstanceProcAddr getInstanceProcAddr) {
#define SEAGLASS_LOAD(name)                                                                                  \
    table.name = reinterpret_cast<PFN_vk##name>(getInstanceProcAddr(instance, "vk" #name));                  \
    if (!table.name) return "vk" #name;
    SEAGLASS_INSTANCE_FUNCTIONS(SEAGLASS_LOAD)
    SEAGLASS_LOAD(GetDeviceProcAddr)
#undef SEAGLASS_LOAD
    return nullptr;
}

const char* load(DeviceTable& table, VkDevice device, PFN_vkGetDeviceProcAddr getDeviceProcAddr) {
#define SEAGLASS_LOAD(name)                                                                                  \
    table.name = reinterpret_cast<PFN_vk##name>(getDeviceProcAddr(device, "vk" #name));                      \
    if (!table.name) return "vk" #name;
    SEAGLASS_DEVICE_FUNCTIONS(SEAGLASS_LOAD)
#undef SEAGLASS_LOAD
    return nullptr;
}

} // namespace seaglass::gpu
