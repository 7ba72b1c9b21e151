#include "gpu/memory/sampler.h"

#include <initializer_list>

namespace seaglass::gpu {

namespace {

Status make(const Device& device, VkFilter filter, VkSamplerMipmapMode mips, VkSamplerAddressMode address,
            VkSampler& out) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = filter;
    info.minFilter = filter;
    info.mipmapMode = mips;
    info.addressModeU = address;
    info.addressModeV = address;
    info.addressModeW = address;
    info.maxLod = VK_LOD_CLAMP_NONE;
    return device.made(device.vk().CreateSampler(device.handle(), &info, device.allocator(), &out),
                       VK_OBJECT_TYPE_SAMPLER, out, "sampler");
}

} // namespace

Samplers::~Samplers() {
    if (!device_) return;
    for (const VkSampler sampler : {nearestClamp_, trilinearClamp_, trilinearRepeat_})
        device_->vk().DestroySampler(device_->handle(), sampler, device_->allocator());
}

Status Samplers::create(const Device& device) {
    device_ = &device;
    constexpr auto clamp = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    constexpr auto repeat = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    constexpr auto nearestMip = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    constexpr auto linearMip = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    Status s = make(device, VK_FILTER_NEAREST, nearestMip, clamp, nearestClamp_);
    if (s == Status::ok) s = make(device, VK_FILTER_LINEAR, linearMip, clamp, trilinearClamp_);
    if (s == Status::ok) s = make(device, VK_FILTER_LINEAR, linearMip, repeat, trilinearRepeat_);
    return s;
}

} // namespace seaglass::gpu
