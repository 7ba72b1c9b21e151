#include "gpu/memory/buffer.h"

namespace seaglass::gpu {

namespace {

VkBufferCreateInfo createInfo(VkDeviceSize size, VkBufferUsageFlags usage) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size;
    info.usage = usage;
    return info;
}

} // namespace

VkDeviceSize heldBytes(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage) {
    if (size == 0) return 0;
    const VkBufferCreateInfo info = createInfo(size, usage);
    VkDeviceBufferMemoryRequirements buffer{VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS};
    buffer.pCreateInfo = &info;
    VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    device.vk().GetDeviceBufferMemoryRequirements(device.handle(), &buffer, &needs);
    return needs.memoryRequirements.size;
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    buffer_ = std::exchange(other.buffer_, VK_NULL_HANDLE);
    memory_ = std::exchange(other.memory_, {});
    size_ = std::exchange(other.size_, 0);
    return *this;
}

void Buffer::release() {
    if (!device_) return;
    device_->vk().DestroyBuffer(device_->handle(), buffer_, device_->allocator());
    device_->free(memory_);
    device_ = nullptr;
}

Status Buffer::allocate(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage,
                        VkMemoryPropertyFlags memory, const char* what) {
    release();
    device_ = &device;
    buffer_ = VK_NULL_HANDLE;
    size_ = size;
    const VkBufferCreateInfo info = createInfo(size, usage);
    const DeviceTable& vk = device.vk();
    if (const Status s = device.made(vk.CreateBuffer(device.handle(), &info, device.allocator(), &buffer_),
                                     VK_OBJECT_TYPE_BUFFER, buffer_, what);
        s != Status::ok)
        return s;
    VkMemoryRequirements needs{};
    vk.GetBufferMemoryRequirements(device.handle(), buffer_, &needs);
    if (const Status s = device.allocate(needs, memory, false, what, memory_); s != Status::ok) return s;
    return device.check(vk.BindBufferMemory(device.handle(), buffer_, memory_.memory, memory_.offset), what);
}

Status Buffer::create(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, const char* what) {
    return allocate(device, size, usage, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, what);
}

Status Buffer::createMapped(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage,
                            const char* what) {
    const VkMemoryPropertyFlags memory =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    return allocate(device, size, usage, memory, what);
}

void recordBarrier(const Device& device, VkCommandBuffer commands, const BufferUse& before,
                   const BufferUse& after) {
    VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    memory.srcStageMask = before.stage;
    memory.srcAccessMask = before.access;
    memory.dstStageMask = after.stage;
    memory.dstAccessMask = after.access;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    device.vk().CmdPipelineBarrier2(commands, &dependency);
}

void recordBuffersFilled(const Device& device, VkCommandBuffer commands,
                         std::initializer_list<VkBuffer> buffers, VkDeviceSize bytes, uint32_t value) {
    constexpr BufferUse written = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    recordBarrier(
        device, commands,
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_NONE},
        written);
    for (const VkBuffer buffer : buffers) device.vk().CmdFillBuffer(commands, buffer, 0, bytes, value);
    recordBarrier(device, commands, written,
                  {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT});
}

} // namespace seaglass::gpu
