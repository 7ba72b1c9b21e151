#include "gpu/pipeline/binding.h"

#include <algorithm>
#include <utility>

namespace seaglass::gpu {

Layout& Layout::operator=(Layout&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    what_ = std::move(other.what_);
    interface_ = std::move(other.interface_);
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

Status Layout::create(const Device& device, std::span<const std::span<const uint32_t>> modules,
                      uint32_t pushConstantBytes, const char* what) {
    release();
    device_ = &device;
    what_ = what;
    std::optional<ShaderInterface> declared = interfaceOf(modules);
    if (!declared)
        return device.misused("%s: its shaders declare a binding in two ways, or of no known type", what);
    interface_ = std::move(*declared);
    std::vector<VkDescriptorSetLayoutBinding> list;
    for (const ShaderBinding& b : interface_.bindings)
        list.push_back({b.number, b.type, 1, b.stages, nullptr});
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = static_cast<uint32_t>(list.size());
    setInfo.pBindings = list.data();
    const DeviceTable& vk = device.vk();
    if (const Status s =
            device.made(vk.CreateDescriptorSetLayout(device.handle(), &setInfo, device.allocator(), &set_),
                        VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, set_, what);
        s != Status::ok)
        return s;
    const VkPushConstantRange push{interface_.pushedTo, 0, pushConstantBytes};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_;
    info.pushConstantRangeCount = interface_.pushedTo ? 1 : 0;
    info.pPushConstantRanges = &push;
    return device.made(vk.CreatePipelineLayout(device.handle(), &info, device.allocator(), &pipeline_),
                       VK_OBJECT_TYPE_PIPELINE_LAYOUT, pipeline_, what);
}

const ShaderBinding* Layout::find(uint32_t number) const {
    const auto found = std::ranges::find(interface_.bindings, number, &ShaderBinding::number);
    return found == interface_.bindings.end() ? nullptr : &*found;
}

Status Layout::check(std::span<const Bound> resources) const {
    for (const Bound& bound : resources) {
        const ShaderBinding* const declared = find(bound.number);
        if (declared && declared->type != bound.resource.type)
            return device_->misused("%s: binding %u is of descriptor type %d, expected %d", what(),
                                    bound.number, bound.resource.type, declared->type);
        if (declared && declared->format != VK_FORMAT_UNDEFINED && declared->format != bound.resource.format)
            return device_->misused("%s: the image of binding %u is of format %d, expected %d", what(),
                                    bound.number, bound.resource.format, declared->format);
    }
    for (const ShaderBinding& binding : interface_.bindings)
        if (std::ranges::count(resources, binding.number, &Bound::number) != 1)
            return device_->misused("%s: binding %u is bound twice or never, expected once", what(),
                                    binding.number);
    return Status::ok;
}

} // namespace seaglass::gpu
