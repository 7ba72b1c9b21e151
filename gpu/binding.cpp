#include "gpu/binding.h"

#include <utility>

namespace seaglass::gpu {

Layout& Layout::operator=(Layout&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    what_ = std::move(other.what_);
    set_ = std::exchange(other.set_, VK_NULL_HANDLE);
    pipeline_ = std::exchange(other.pipeline_, VK_NULL_HANDLE);
    return *this;
}

void Layout::release() {
    if (!device_) return;
    device_->vk().DestroyPipelineLayout(device_->handle(), pipeline_, device_->allocator());
    device_->vk().DestroyDescriptorSetLayout(device_->handle(), set_, device_->allocator());
    device_ = nullptr;
    set_ = VK_NULL_HANDLE;
    pipeline_ = VK_NULL_HANDLE;
}

Status Layout::create(const Device& device, std::span<const VkDescriptorType> bindings,
                      VkShaderStageFlags stages, uint32_t pushConstantBytes, const char* what) {
    release();
    device_ = &device;
    what_ = what;
    std::vector<VkDescriptorSetLayoutBinding> list(bindings.size());
    for (uint32_t i = 0; i < list.size(); ++i) list[i] = {i, bindings[i], 1, stages, nullptr};
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = static_cast<uint32_t>(list.size());
    setInfo.pBindings = list.data();
    const DeviceTable& vk = device.vk();
    if (const Status s =
            device.made(vk.CreateDescriptorSetLayout(device.handle(), &setInfo, device.allocator(), &set_),
                        VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, set_, what);
        s != Status::ok)
        return s;
    const VkPushConstantRange push{stages, 0, pushConstantBytes};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_;
    info.pushConstantRangeCount = pushConstantBytes ? 1 : 0;
    info.pPushConstantRanges = &push;
    return device.made(vk.CreatePipelineLayout(device.handle(), &info, device.allocator(), &pipeline_),
                       VK_OBJECT_TYPE_PIPELINE_LAYOUT, pipeline_, what);
}

} // namespace seaglass::gpu
