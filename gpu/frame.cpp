#include "gpu/frame.h"

#include <algorithm>

namespace seaglass::gpu {

namespace {

constexpr uint32_t setsPerPool = 64;
constexpr VkDeviceSize blockBytes = 256 * 1024;

VkDeviceSize alignUp(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

} // namespace

Frame::~Frame() {
    for (const VkDescriptorPool pool : pools_)
        device_->vk().DestroyDescriptorPool(device_->handle(), pool, device_->allocator());
}

Status Frame::begin() {
    for (const VkDescriptorPool pool : pools_)
        if (const Status s = device_->check(device_->vk().ResetDescriptorPool(device_->handle(), pool, 0),
                                            "frame descriptors");
            s != Status::ok)
            return s;
    poolInUse_ = 0;
    blockInUse_ = 0;
    blockOffset_ = 0;
    releaseRetired();
    return Status::ok;
}

Erased& Frame::keptNext() {
    return retired_.emplace_back(nullptr, nullptr);
}

Status Frame::addPool() {
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, setsPerPool},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, setsPerPool},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, setsPerPool * 8},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, setsPerPool * 2},
    };
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = setsPerPool;
    info.poolSizeCount = static_cast<uint32_t>(std::size(sizes));
    info.pPoolSizes = sizes;
    VkDescriptorPool& pool = pools_.emplace_back(VK_NULL_HANDLE);
    const Status s = device_->made(
        device_->vk().CreateDescriptorPool(device_->handle(), &info, device_->allocator(), &pool),
        VK_OBJECT_TYPE_DESCRIPTOR_POOL, pool, "frame descriptors");
    if (s != Status::ok) pools_.pop_back();
    return s;
}

Status Frame::allocateSet(const Layout& layout, std::span<const Bound> resources, VkDescriptorSet& out) {
    if (const Status s = layout.check(resources); s != Status::ok) return s;
    const DeviceTable& vk = device_->vk();
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorSetCount = 1;
    const VkDescriptorSetLayout set = layout.set();
    info.pSetLayouts = &set;
    for (;; ++poolInUse_) {
        const bool fresh = poolInUse_ == pools_.size();
        if (fresh)
            if (const Status s = addPool(); s != Status::ok) return s;
        info.descriptorPool = pools_[poolInUse_];
        const VkResult result = vk.AllocateDescriptorSets(device_->handle(), &info, &out);
        const bool full = result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
        if (full && !fresh) continue;
        if (const Status s = device_->made(result, VK_OBJECT_TYPE_DESCRIPTOR_SET, out, layout.what());
            s != Status::ok)
            return s;
        break;
    }
    std::vector<VkWriteDescriptorSet> writes;
    for (const Bound& bound : resources) {
        if (!layout.has(bound.number)) continue;
        VkWriteDescriptorSet& write = writes.emplace_back();
        write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = out;
        write.dstBinding = bound.number;
        write.descriptorCount = 1;
        write.descriptorType = bound.resource.type;
        write.pBufferInfo = &bound.resource.buffer;
        write.pImageInfo = &bound.resource.image;
    }
    vk.UpdateDescriptorSets(device_->handle(), static_cast<uint32_t>(writes.size()), writes.data(), 0,
                            nullptr);
    return Status::ok;
}

Status Frame::allocate(VkDeviceSize size, Slice& out) {
    const VkDeviceSize alignment = std::max(device_->limits().minUniformBufferOffsetAlignment,
                                            device_->limits().minStorageBufferOffsetAlignment);
    while (blockInUse_ < blocks_.size() && blockOffset_ + size > blocks_[blockInUse_].size()) {
        ++blockInUse_;
        blockOffset_ = 0;
    }
    if (blockInUse_ == blocks_.size()) {
        Buffer block;
        const VkBufferUsageFlags usage =
            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        if (const Status s = block.createMapped(*device_, std::max(size, blockBytes), usage, "frame memory");
            s != Status::ok)
            return s;
        blocks_.push_back(std::move(block));
        blockOffset_ = 0;
    }
    const Buffer& block = blocks_[blockInUse_];
    out = {block.handle(), blockOffset_, size, static_cast<char*>(block.mapped()) + blockOffset_};
    blockOffset_ = alignUp(blockOffset_ + size, alignment);
    return Status::ok;
}

} // namespace seaglass::gpu
