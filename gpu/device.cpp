#include "gpu/device.h"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace seaglass::gpu {

Status Device::init(const DeviceDesc& desc) {
    device_ = desc.device;
    physical_ = desc.physicalDevice;
    pipelineCache_ = desc.pipelineCache;
    memoryCallbacks_ = desc.memory;
    message_ = desc.message;
    pass_ = desc.pass;
    if (desc.allocator) {
        allocator_ = *desc.allocator;
        hasAllocator_ = true;
    }
    if (const char* missing = load(instanceTable_, desc.instance, desc.getInstanceProcAddr))
        return fail(Status::unsupported, "the Vulkan loader has no %s", missing);
    if (const char* missing = load(table_, desc.device, instanceTable_.GetDeviceProcAddr))
        // checkSupport() has seen that the device itself is of Vulkan 1.3.
        return fail(Status::unsupported,
                    "the device has no %s: its instance was made for an earlier Vulkan, expected "
                    "VkApplicationInfo::apiVersion of 1.3 or later",
                    missing);
    names_.load(desc.instance, desc.getInstanceProcAddr);
    VkPhysicalDeviceProperties properties{};
    instanceTable_.GetPhysicalDeviceProperties(desc.physicalDevice, &properties);
    limits_ = properties.limits;
    isCpu_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    instanceTable_.GetPhysicalDeviceMemoryProperties(desc.physicalDevice, &memory_);
    return Status::ok;
}

uint32_t Device::memoryType(uint32_t allowedBits, VkMemoryPropertyFlags wanted) const {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
        if ((allowedBits >> i & 1u) && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return ~0u;
}

VkFormatFeatureFlags Device::optimalFeatures(VkFormat format) const {
    VkFormatProperties properties{};
    instanceTable_.GetPhysicalDeviceFormatProperties(physical_, format, &properties);
    return properties.optimalTilingFeatures;
}

Status Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, bool image,
                        const char* what, MemoryPiece& out) const {
    return memoryCallbacks_.allocate ? allocateHosts(needs, wanted, image, what, out)
                                     : allocateOwn(needs, wanted, what, out);
}

Status Device::allocateOwn(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, const char* what,
                           MemoryPiece& out) const {
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = memoryType(needs.memoryTypeBits, wanted);
    if (info.memoryTypeIndex == ~0u) return fail(Status::unsupported, "%s: no fitting memory type", what);
    if (const Status s = made(table_.AllocateMemory(device_, &info, allocator(), &out.memory),
                              VK_OBJECT_TYPE_DEVICE_MEMORY, out.memory, what);
        s != Status::ok)
        return s;
    if (!(wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)) return Status::ok;
    const Status s = check(table_.MapMemory(device_, out.memory, 0, VK_WHOLE_SIZE, 0, &out.mapped), what);
    if (s != Status::ok) out.mapped = nullptr;
    return s;
}

Status Device::allocateHosts(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, bool image,
                             const char* what, MemoryPiece& out) const {
    MemoryPiece piece;
    const VkResult result = memoryCallbacks_.allocate(memoryCallbacks_.user, &needs, wanted, image, &piece);
    if (const Status s = check(result, what); s != Status::ok) return s;
    out = piece;
    if (!piece.memory || piece.offset % needs.alignment != 0)
        return fail(Status::invalidArgument,
                    "%s: MemoryCallbacks.allocate gave no memory, or an offset that is not aligned", what);
    if ((wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) && !piece.mapped)
        return fail(Status::invalidArgument,
                    "%s: MemoryCallbacks.allocate was asked for host-visible memory and gave none mapped",
                    what);
    return Status::ok;
}

void Device::free(MemoryPiece& piece) const {
    if (!memoryCallbacks_.allocate)
        table_.FreeMemory(device_, piece.memory, allocator());
    else if (piece.memory)
        memoryCallbacks_.release(memoryCallbacks_.user, &piece);
    piece = {};
}

Status Device::fail(Status status, const char* format, ...) const {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
    return status;
}

void Device::warn(const char* format, ...) const {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
}

Status Device::misused(const char* format, ...) const {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
#ifdef SEAGLASS_ASSERTS
    va_start(arguments, format);
    std::vfprintf(stderr, format, arguments);
    va_end(arguments);
    std::fputc('\n', stderr);
    std::abort();
#endif
    return Status::invalidArgument;
}

void Device::say(const char* format, va_list arguments) const {
    if (!message_.function) return;
    char text[512];
    std::vsnprintf(text, sizeof text, format, arguments);
    message_.function(message_.user, text);
}

Status Device::check(VkResult result, const char* what) const {
    switch (result) {
    case VK_SUCCESS:
        return Status::ok;
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return fail(Status::outOfHostMemory, "%s: out of host memory", what);
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return fail(Status::outOfDeviceMemory, "%s: out of device memory", what);
    case VK_ERROR_DEVICE_LOST:
        return fail(Status::deviceLost, "%s: device lost", what);
    default:
        return fail(Status::vulkanError, "%s: VkResult %d", what, static_cast<int>(result));
    }
}

void Device::passBegins(VkCommandBuffer commands, const char* pass) const {
    names_.beginPass(commands, pass);
    if (pass_.function) pass_.function(pass_.user, commands, pass, true);
}

void Device::passEnds(VkCommandBuffer commands, const char* pass) const {
    if (pass_.function) pass_.function(pass_.user, commands, pass, false);
    names_.endPass(commands);
}

} // namespace seaglass::gpu
