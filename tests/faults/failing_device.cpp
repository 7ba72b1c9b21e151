#include "tests/faults/failing_device.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace tests {

namespace {

/// Of memory, which has two types: the device's own, and what the CPU sees.
constexpr uint32_t visibleType = 1;
/// Of what images and buffers ask for.
constexpr VkDeviceSize alignment = 256;
/// At whose multiples shaders' parts of a buffer begin. CPU devices ask for less than what blocks are long.
constexpr VkDeviceSize offsetAlignment = 64;

template<typename Handle>
constexpr const char* kindOf = nullptr;
template<>
constexpr const char* kindOf<VkBuffer> = "buffer";
template<>
constexpr const char* kindOf<VkImage> = "image";
template<>
constexpr const char* kindOf<VkImageView> = "image view";
template<>
constexpr const char* kindOf<VkSampler> = "sampler";
template<>
constexpr const char* kindOf<VkShaderModule> = "shader module";
template<>
constexpr const char* kindOf<VkDescriptorSetLayout> = "descriptor set layout";
template<>
constexpr const char* kindOf<VkPipelineLayout> = "pipeline layout";
template<>
constexpr const char* kindOf<VkPipeline> = "pipeline";
template<>
constexpr const char* kindOf<VkDescriptorPool> = "descriptor pool";
template<>
constexpr const char* kindOf<VkDeviceMemory> = "memory";
template<>
constexpr const char* kindOf<VkRenderPass> = "render pass";
template<>
constexpr const char* kindOf<VkFramebuffer> = "framebuffer";

/// A command that nothing is checked of.
template<typename Function>
struct Ignored;
template<typename... Arguments>
struct Ignored<void(VKAPI_PTR*)(Arguments...)> {
    static void VKAPI_CALL call(Arguments...) {}
};

VkMemoryRequirements needsOf(VkDeviceSize size) {
    return {(size + alignment - 1) / alignment * alignment, alignment, 3};
}

/// Four bytes a texel: enough for what is only counted.
VkDeviceSize bytesOf(const VkImageCreateInfo& info) {
    return VkDeviceSize{4} * info.extent.width * info.extent.height * info.arrayLayers;
}

} // namespace

const char* toString(Fault fault) {
    switch (fault) {
    case Fault::hostMemory:
        return "out of host memory";
    case Fault::deviceMemory:
        return "out of device memory";
    case Fault::deviceLost:
        return "device lost";
    case Fault::another:
        return "another error";
    }
    return "";
}

seaglass::Status statusOf(Fault fault) {
    switch (fault) {
    case Fault::hostMemory:
        return seaglass::Status::outOfHostMemory;
    case Fault::deviceMemory:
        return seaglass::Status::outOfDeviceMemory;
    case Fault::deviceLost:
        return seaglass::Status::deviceLost;
    case Fault::another:
        break;
    }
    return seaglass::Status::vulkanError;
}

void FailingDevice::failAt(uint64_t call, Fault fault, bool sticky) {
    const Lock lock(*this);
    calls_.clear();
    failAt_ = call;
    fault_ = fault;
    sticky_ = sticky;
    failed_.clear();
}

size_t FailingDevice::held() const {
    const Lock lock(*this);
    return static_cast<size_t>(std::ranges::count_if(
        objects_, [](const auto& each) { return std::strcmp(each.second.kind, "the host's") != 0; }));
}

size_t FailingDevice::heldButPipelines() const {
    const Lock lock(*this);
    const auto isKept = [](std::string_view kind) {
        return kind == kindOf<VkPipeline> || kind == kindOf<VkPipelineLayout> ||
               kind == kindOf<VkDescriptorSetLayout>;
    };
    return static_cast<size_t>(std::ranges::count_if(objects_, [&](const auto& each) {
        const std::string_view kind = each.second.kind;
        return kind != "the host's" && !isKept(kind);
    }));
}

VkResult FailingDevice::next(const char* function, VkResult another) {
    const uint64_t call = calls_.size();
    calls_.push_back(function);
    if (call < failAt_ || (call > failAt_ && !sticky_)) return VK_SUCCESS;
    if (failed_.empty()) failed_ = function;
    switch (fault_) {
    case Fault::hostMemory:
        return VK_ERROR_OUT_OF_HOST_MEMORY;
    case Fault::deviceMemory:
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    case Fault::deviceLost:
        return VK_ERROR_DEVICE_LOST;
    case Fault::another:
        break;
    }
    return another;
}

uint64_t FailingDevice::add(const char* kind, const VkAllocationCallbacks* allocator, uint64_t owner) {
    const uint64_t bits = 0x1000 + 16 * ++given_;
    Object& object = objects_[bits];
    object.kind = kind;
    object.owner = owner;
    if (allocator) object.allocator = *allocator;
    return bits;
}

VkResult FailingDevice::make(const char* function, VkResult another, const char* kind,
                             const VkAllocationCallbacks* allocator, uint64_t& bits, uint64_t owner) {
    const Lock lock(*this);
    bits = garbage();
    if (const VkResult failed = next(function, another); failed != VK_SUCCESS) return failed;
    void* own = nullptr;
    if (allocator) {
        own = allocator->pfnAllocation(allocator->pUserData, 64, 16, VK_SYSTEM_ALLOCATION_SCOPE_OBJECT);
        if (!own) return VK_ERROR_OUT_OF_HOST_MEMORY;
    }
    bits = add(kind, allocator, owner);
    objects_[bits].own = own;
    return VK_SUCCESS;
}

void FailingDevice::complain(size_t& count, const char* what, const char* where) {
    ++count;
    complaint_ = std::string(where) + ": " + what;
}

void FailingDevice::remove(const char* kind, uint64_t bits, const VkAllocationCallbacks* allocator) {
    if (!bits) return;
    const Lock lock(*this);
    const auto found = objects_.find(bits);
    if (found == objects_.end() || std::strcmp(found->second.kind, kind) != 0)
        return complain(garbageDestroyed_, "destroyed, but not made or not any more", kind);
    const Object& object = found->second;
    const auto freedBy = allocator ? allocator->pfnFree : nullptr;
    if (object.allocator.pfnFree != freedBy ||
        (allocator && object.allocator.pUserData != allocator->pUserData))
        complain(wrongAllocators_, "destroyed with other callbacks than it was made with", kind);
    if (object.own) object.allocator.pfnFree(object.allocator.pUserData, object.own);
    heldBytes_ -= object.bytes;
    objects_.erase(found);
}

void FailingDevice::removeOwned(uint64_t owner) {
    const Lock lock(*this);
    std::erase_if(objects_, [&](const auto& each) { return each.second.owner == owner; });
}

void FailingDevice::setBytes(uint64_t bits, size_t bytes) {
    const Lock lock(*this);
    objects_[bits].bytes = bytes;
    heldBytes_ += bytes;
}

void FailingDevice::setRoom(uint64_t pool, uint32_t sets) {
    const Lock lock(*this);
    objects_[pool].sets = objects_[pool].room = sets;
}

bool FailingDevice::takeRoom(uint64_t pool, uint32_t sets) {
    const Lock lock(*this);
    const auto found = objects_.find(pool);
    if (found == objects_.end()) return true; // a garbage handle, which use() has counted
    if (found->second.room < sets) return false;
    found->second.room -= sets;
    return true;
}

void FailingDevice::emptyPool(uint64_t pool) {
    const Lock lock(*this);
    const auto found = objects_.find(pool);
    if (found != objects_.end()) found->second.room = found->second.sets;
}

size_t FailingDevice::bytes(uint64_t bits) const {
    const Lock lock(*this);
    const auto found = objects_.find(bits);
    return found == objects_.end() ? 0 : found->second.bytes;
}

void FailingDevice::use(const char* function, uint64_t bits) {
    if (!bits) return;
    const Lock lock(*this);
    if (!objects_.contains(bits)) complain(garbageUsed_, "used, but not made or not any more", function);
}

void FailingDevice::usePart(const VkDescriptorBufferInfo& part) {
    const VkDeviceSize size = bytes(bitsOf(part.buffer));
    const Lock lock(*this);
    const bool fits = part.offset < size && (part.range == VK_WHOLE_SIZE || part.range <= size - part.offset);
    if (part.offset % offsetAlignment != 0 || !fits)
        complain(garbageUsed_, "a part of a buffer that is not aligned, or not in it",
                 "vkUpdateDescriptorSets");
}

struct FailingDevice::Calls {
    static FailingDevice& of(const void* handle) {
        return *static_cast<FailingDevice*>(const_cast<void*>(handle));
    }

    template<typename Info, typename Handle>
    static VkResult VKAPI_CALL create(VkDevice device, const Info* info,
                                      const VkAllocationCallbacks* allocator, Handle* out) {
        FailingDevice& self = of(device);
        useAll(self, *info);
        uint64_t bits = 0;
        const VkResult result =
            self.make(kindOf<Handle>, VK_ERROR_INITIALIZATION_FAILED, kindOf<Handle>, allocator, bits);
        *out = toHandle<Handle>(bits);
        if constexpr (std::is_same_v<Handle, VkBuffer>)
            if (result == VK_SUCCESS) self.setBytes(bits, static_cast<size_t>(info->size));
        if constexpr (std::is_same_v<Handle, VkImage>)
            if (result == VK_SUCCESS) self.setBytes(bits, static_cast<size_t>(bytesOf(*info)));
        if constexpr (std::is_same_v<Handle, VkDescriptorPool>)
            if (result == VK_SUCCESS) self.setRoom(bits, info->maxSets);
        return result;
    }
    template<typename Info>
    static VkResult VKAPI_CALL createPipelines(VkDevice device, VkPipelineCache, uint32_t count,
                                               const Info* infos, const VkAllocationCallbacks* allocator,
                                               VkPipeline* out) {
        FailingDevice& self = of(device);
        VkResult result = VK_SUCCESS;
        for (uint32_t i = 0; i < count; ++i) {
            self.use("vkCreatePipelines", bitsOf(infos[i].layout));
            uint64_t bits = 0;
            const VkResult each = self.make("pipeline", VK_ERROR_UNKNOWN, "pipeline", allocator, bits);
            if (each != VK_SUCCESS) result = each;
            out[i] = toHandle<VkPipeline>(bits);
        }
        return result;
    }
    template<typename Handle>
    static void VKAPI_CALL destroy(VkDevice device, Handle handle, const VkAllocationCallbacks* allocator) {
        of(device).remove(kindOf<Handle>, bitsOf(handle), allocator);
        if constexpr (std::is_same_v<Handle, VkDescriptorPool>)
            if (handle) of(device).removeOwned(bitsOf(handle));
    }

    template<typename Info>
    static void useAll(FailingDevice& self, const Info& info) {
        if constexpr (std::is_same_v<Info, VkImageViewCreateInfo>)
            self.use("vkCreateImageView", bitsOf(info.image));
        if constexpr (std::is_same_v<Info, VkPipelineLayoutCreateInfo>)
            for (uint32_t i = 0; i < info.setLayoutCount; ++i)
                self.use("vkCreatePipelineLayout", bitsOf(info.pSetLayouts[i]));
        if constexpr (std::is_same_v<Info, VkFramebufferCreateInfo>) {
            self.use("vkCreateFramebuffer", bitsOf(info.renderPass));
            for (uint32_t i = 0; i < info.attachmentCount; ++i)
                self.use("vkCreateFramebuffer", bitsOf(info.pAttachments[i]));
        }
    }

    static VkResult VKAPI_CALL allocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkDeviceMemory* out) {
        FailingDevice& self = of(device);
        uint64_t bits = 0;
        const VkResult result =
            self.make("vkAllocateMemory", VK_ERROR_INVALID_EXTERNAL_HANDLE, "memory", allocator, bits);
        *out = toHandle<VkDeviceMemory>(bits);
        if (result == VK_SUCCESS && info->memoryTypeIndex == visibleType) {
            const Lock lock(self);
            self.objects_[bits].mapped.resize(info->allocationSize);
        }
        return result;
    }
    static VkResult VKAPI_CALL mapMemory(VkDevice device, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize,
                                         VkMemoryMapFlags, void** out) {
        FailingDevice& self = of(device);
        self.use("vkMapMemory", bitsOf(memory));
        const Lock lock(self);
        *out = reinterpret_cast<void*>(static_cast<uintptr_t>(self.garbage()));
        if (const VkResult failed = self.next("vkMapMemory", VK_ERROR_MEMORY_MAP_FAILED)) return failed;
        *out = self.objects_[bitsOf(memory)].mapped.data();
        return VK_SUCCESS;
    }
    template<typename Handle>
    static VkResult VKAPI_CALL bind(VkDevice device, Handle handle, VkDeviceMemory memory, VkDeviceSize) {
        FailingDevice& self = of(device);
        self.use("vkBindMemory", bitsOf(handle));
        self.use("vkBindMemory", bitsOf(memory));
        const Lock lock(self);
        return self.next("vkBindMemory", VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS);
    }

    static VkResult VKAPI_CALL allocateSets(VkDevice device, const VkDescriptorSetAllocateInfo* info,
                                            VkDescriptorSet* out) {
        FailingDevice& self = of(device);
        self.use("vkAllocateDescriptorSets", bitsOf(info->descriptorPool));
        if (!self.takeRoom(bitsOf(info->descriptorPool), info->descriptorSetCount))
            return VK_ERROR_OUT_OF_POOL_MEMORY;
        for (uint32_t i = 0; i < info->descriptorSetCount; ++i) {
            self.use("vkAllocateDescriptorSets", bitsOf(info->pSetLayouts[i]));
            uint64_t bits = 0;
            const VkResult result = self.make("vkAllocateDescriptorSets", VK_ERROR_UNKNOWN, "descriptor set",
                                              nullptr, bits, bitsOf(info->descriptorPool));
            out[i] = toHandle<VkDescriptorSet>(bits);
            if (result != VK_SUCCESS) return result;
        }
        return VK_SUCCESS;
    }
    static VkResult VKAPI_CALL resetPool(VkDevice device, VkDescriptorPool pool, VkDescriptorPoolResetFlags) {
        FailingDevice& self = of(device);
        self.use("vkResetDescriptorPool", bitsOf(pool));
        {
            const Lock lock(self);
            if (const VkResult failed = self.next("vkResetDescriptorPool", VK_ERROR_UNKNOWN)) return failed;
        }
        self.removeOwned(bitsOf(pool));
        self.emptyPool(bitsOf(pool));
        return VK_SUCCESS;
    }
    static void VKAPI_CALL updateSets(VkDevice device, uint32_t count, const VkWriteDescriptorSet* writes,
                                      uint32_t, const VkCopyDescriptorSet*) {
        FailingDevice& self = of(device);
        for (uint32_t i = 0; i < count; ++i) {
            const VkWriteDescriptorSet& write = writes[i];
            self.use("vkUpdateDescriptorSets", bitsOf(write.dstSet));
            const bool buffer = write.descriptorType == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER ||
                                write.descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            if (buffer) {
                self.use("vkUpdateDescriptorSets", bitsOf(write.pBufferInfo->buffer));
                self.usePart(*write.pBufferInfo);
                continue;
            }
            self.use("vkUpdateDescriptorSets", bitsOf(write.pImageInfo->imageView));
            self.use("vkUpdateDescriptorSets", bitsOf(write.pImageInfo->sampler));
        }
    }

    static void VKAPI_CALL bindPipeline(VkCommandBuffer commands, VkPipelineBindPoint, VkPipeline pipeline) {
        of(commands).use("vkCmdBindPipeline", bitsOf(pipeline));
    }
    static void VKAPI_CALL bindSets(VkCommandBuffer commands, VkPipelineBindPoint, VkPipelineLayout layout,
                                    uint32_t, uint32_t count, const VkDescriptorSet* sets, uint32_t,
                                    const uint32_t*) {
        of(commands).use("vkCmdBindDescriptorSets", bitsOf(layout));
        for (uint32_t i = 0; i < count; ++i) of(commands).use("vkCmdBindDescriptorSets", bitsOf(sets[i]));
    }
    static void VKAPI_CALL barrier(VkCommandBuffer commands, const VkDependencyInfo* info) {
        for (uint32_t i = 0; i < info->imageMemoryBarrierCount; ++i)
            of(commands).use("vkCmdPipelineBarrier2", bitsOf(info->pImageMemoryBarriers[i].image));
    }
    static void VKAPI_CALL fill(VkCommandBuffer commands, VkBuffer buffer, VkDeviceSize, VkDeviceSize,
                                uint32_t) {
        of(commands).use("vkCmdFillBuffer", bitsOf(buffer));
    }

    static void VKAPI_CALL bufferNeeds(VkDevice device, VkBuffer buffer, VkMemoryRequirements* out) {
        of(device).use("vkGetBufferMemoryRequirements", bitsOf(buffer));
        *out = needsOf(of(device).bytes(bitsOf(buffer)));
    }
    static void VKAPI_CALL imageNeeds(VkDevice device, VkImage image, VkMemoryRequirements* out) {
        of(device).use("vkGetImageMemoryRequirements", bitsOf(image));
        *out = needsOf(of(device).bytes(bitsOf(image)));
    }
    static void VKAPI_CALL bufferNeedsBefore(VkDevice, const VkDeviceBufferMemoryRequirements* info,
                                             VkMemoryRequirements2* out) {
        out->memoryRequirements = needsOf(info->pCreateInfo->size);
    }
    static void VKAPI_CALL imageNeedsBefore(VkDevice, const VkDeviceImageMemoryRequirements* info,
                                            VkMemoryRequirements2* out) {
        out->memoryRequirements = needsOf(bytesOf(*info->pCreateInfo));
    }

    static void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties* out) {
        *out = {};
        out->apiVersion = VK_API_VERSION_1_3;
        out->deviceType = of(device).type_;
        std::strcpy(out->deviceName, "a device of nothing");
        VkPhysicalDeviceLimits& limits = out->limits;
        limits.maxImageDimension2D = 16384;
        limits.maxStorageBufferRange = 1u << 30;
        limits.maxComputeWorkGroupInvocations = limits.maxComputeWorkGroupSize[0] = 1024;
        limits.maxComputeSharedMemorySize = 32768;
        limits.minUniformBufferOffsetAlignment = limits.minStorageBufferOffsetAlignment = offsetAlignment;
        limits.maxPerStageDescriptorStorageImages = 64;
        constexpr VkSampleCountFlags samples = 0x1f;
        limits.framebufferColorSampleCounts = limits.framebufferDepthSampleCounts = samples;
        limits.framebufferStencilSampleCounts = limits.sampledImageColorSampleCounts = samples;
        limits.sampledImageDepthSampleCounts = samples;
    }
    static void VKAPI_CALL features(VkPhysicalDevice, VkPhysicalDeviceFeatures2* out) {
        const seaglass::Requirements needs = seaglass::requirements();
        out->features = needs.features;
        auto& features13 = *static_cast<VkPhysicalDeviceVulkan13Features*>(out->pNext);
        features13.synchronization2 = needs.features13.synchronization2;
        features13.shaderDemoteToHelperInvocation = needs.features13.shaderDemoteToHelperInvocation;
    }
    static void VKAPI_CALL memory(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* out) {
        *out = {};
        out->memoryTypeCount = 2;
        out->memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
        out->memoryTypes[visibleType].propertyFlags =
            VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        out->memoryHeapCount = 1;
    }
    static void VKAPI_CALL format(VkPhysicalDevice, VkFormat, VkFormatProperties* out) {
        out->linearTilingFeatures = out->optimalTilingFeatures = out->bufferFeatures = ~0u;
    }

    template<typename Function>
    static PFN_vkVoidFunction erased(Function function) {
        return reinterpret_cast<PFN_vkVoidFunction>(function);
    }
    static PFN_vkVoidFunction find(std::string_view name);
    static PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice, const char* name) { return find(name); }
    static PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance, const char* name) {
        return find(name);
    }
};

PFN_vkVoidFunction FailingDevice::Calls::find(std::string_view name) {
#define IS(function, by)                                                                                     \
    if (name == "vk" #function) return erased(static_cast<PFN_vk##function>(by));
    IS(AllocateDescriptorSets, allocateSets)
    IS(AllocateMemory, allocateMemory)
    IS(BindBufferMemory, bind<VkBuffer>)
    IS(BindImageMemory, bind<VkImage>)
    IS(CmdBindDescriptorSets, bindSets)
    IS(CmdBindPipeline, bindPipeline)
    IS(CmdFillBuffer, fill)
    IS(CmdPipelineBarrier2, barrier)
    IS(CreateBuffer, create)
    IS(CreateComputePipelines, createPipelines)
    IS(CreateDescriptorPool, create)
    IS(CreateDescriptorSetLayout, create)
    IS(CreateFramebuffer, create)
    IS(CreateGraphicsPipelines, createPipelines)
    IS(CreateImage, create)
    IS(CreateImageView, create)
    IS(CreatePipelineLayout, create)
    IS(CreateRenderPass, create)
    IS(CreateSampler, create)
    IS(CreateShaderModule, create)
    IS(DestroyBuffer, destroy)
    IS(DestroyDescriptorPool, destroy)
    IS(DestroyDescriptorSetLayout, destroy)
    IS(DestroyFramebuffer, destroy)
    IS(DestroyImage, destroy)
    IS(DestroyImageView, destroy)
    IS(DestroyPipeline, destroy)
    IS(DestroyPipelineLayout, destroy)
    IS(DestroyRenderPass, destroy)
    IS(DestroySampler, destroy)
    IS(DestroyShaderModule, destroy)
    IS(FreeMemory, destroy)
    IS(GetBufferMemoryRequirements, bufferNeeds)
    IS(GetDeviceBufferMemoryRequirements, bufferNeedsBefore)
    IS(GetDeviceImageMemoryRequirements, imageNeedsBefore)
    IS(GetDeviceProcAddr, getDeviceProcAddr)
    IS(GetImageMemoryRequirements, imageNeeds)
    IS(GetPhysicalDeviceFeatures2, features)
    IS(GetPhysicalDeviceFormatProperties, format)
    IS(GetPhysicalDeviceMemoryProperties, memory)
    IS(GetPhysicalDeviceProperties, properties)
    IS(MapMemory, mapMemory)
    IS(ResetDescriptorPool, resetPool)
    IS(UpdateDescriptorSets, updateSets)
#undef IS
#define IGNORED(function)                                                                                    \
    if (name == "vk" #function) return erased(&Ignored<PFN_vk##function>::call);
    IGNORED(CmdBeginRenderPass)
    IGNORED(CmdBindIndexBuffer)
    IGNORED(CmdBlitImage)
    IGNORED(CmdClearColorImage)
    IGNORED(CmdCopyBuffer)
    IGNORED(CmdCopyBufferToImage)
    IGNORED(CmdCopyImage)
    IGNORED(CmdDispatch)
    IGNORED(CmdDispatchIndirect)
    IGNORED(CmdDraw)
    IGNORED(CmdDrawIndexed)
    IGNORED(CmdEndRenderPass)
    IGNORED(CmdPushConstants)
    IGNORED(CmdSetScissor)
    IGNORED(CmdSetViewport)
#undef IGNORED
    return nullptr;
}

seaglass::DeviceDesc FailingDevice::desc() {
    seaglass::DeviceDesc desc;
    desc.instance = reinterpret_cast<VkInstance>(this);
    desc.physicalDevice = reinterpret_cast<VkPhysicalDevice>(this);
    desc.device = reinterpret_cast<VkDevice>(this);
    desc.getInstanceProcAddr = &Calls::getInstanceProcAddr;
    return desc;
}

} // namespace tests
