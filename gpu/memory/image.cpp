#include "gpu/memory/image.h"

#include <algorithm>

namespace seaglass::gpu {

namespace {

VkDeviceSize texelBytes(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8_UNORM:
        return 1;
    case VK_FORMAT_R16_SFLOAT:
        return 2;
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
        return 16;
    default: // D32, R32, RGBA8, B10G11R11
        return 4;
    }
}

VkImageCreateInfo createInfo(const ImageDesc& desc) {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = desc.format;
    info.extent = {desc.extent.width, desc.extent.height, 1};
    info.mipLevels = desc.mipLevels;
    info.arrayLayers = desc.layers;
    info.samples = desc.samples;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = desc.usage;
    return info;
}

/// Views may be larger than any image that is drawn into: a scissor cuts them.
Status checkExtent(const Device& device, const ImageDesc& desc, const char* what) {
    const uint32_t most = device.limits().maxImageDimension2D;
    if (std::max(desc.extent.width, desc.extent.height) <= most) return Status::ok;
    return device.fail(Status::unsupported, "%s: %u x %u pixels, the device's images have up to %u each way",
                       what, desc.extent.width, desc.extent.height, most);
}

} // namespace

VkDeviceSize imageBytes(const ImageDesc& desc) {
    VkDeviceSize texels = 0;
    for (uint32_t mip = 0; mip < desc.mipLevels; ++mip)
        texels +=
            VkDeviceSize{std::max(desc.extent.width >> mip, 1u)} * std::max(desc.extent.height >> mip, 1u);
    return texels * desc.layers * texelBytes(desc.format);
}

VkDeviceSize heldBytes(const Device& device, const ImageDesc& desc) {
    const VkImageCreateInfo info = createInfo(desc);
    VkDeviceImageMemoryRequirements image{VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS};
    image.pCreateInfo = &info;
    VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    device.vk().GetDeviceImageMemoryRequirements(device.handle(), &image, &needs);
    return needs.memoryRequirements.size;
}

OwnedImage& OwnedImage::operator=(OwnedImage&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    image_ = std::exchange(other.image_, VK_NULL_HANDLE);
    view_ = std::exchange(other.view_, VK_NULL_HANDLE);
    mipViews_ = std::exchange(other.mipViews_, {});
    memory_ = std::exchange(other.memory_, {});
    desc_ = std::exchange(other.desc_, ImageDesc{});
    return *this;
}

void OwnedImage::release() {
    if (!device_) return;
    const DeviceTable& vk = device_->vk();
    for (const VkImageView view : mipViews_)
        vk.DestroyImageView(device_->handle(), view, device_->allocator());
    vk.DestroyImageView(device_->handle(), view_, device_->allocator());
    vk.DestroyImage(device_->handle(), image_, device_->allocator());
    device_->free(memory_);
    device_ = nullptr;
    image_ = VK_NULL_HANDLE;
    view_ = VK_NULL_HANDLE;
    mipViews_.clear();
}

Status OwnedImage::create(const Device& device, const ImageDesc& desc, const char* what) {
    release();
    if (const Status s = checkExtent(device, desc, what); s != Status::ok) return s;
    device_ = &device;
    desc_ = desc;
    const VkImageCreateInfo info = createInfo(desc);
    const DeviceTable& vk = device.vk();
    if (const Status s = device.made(vk.CreateImage(device.handle(), &info, device.allocator(), &image_),
                                     VK_OBJECT_TYPE_IMAGE, image_, what);
        s != Status::ok)
        return s;
    VkMemoryRequirements needs{};
    vk.GetImageMemoryRequirements(device.handle(), image_, &needs);
    if (const Status s = device.allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, true, what, memory_);
        s != Status::ok)
        return s;
    if (const Status s =
            device.check(vk.BindImageMemory(device.handle(), image_, memory_.memory, memory_.offset), what);
        s != Status::ok)
        return s;
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image_;
    view.viewType = desc.layers > 1 || desc.arrayView ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    view.format = desc.format;
    view.subresourceRange = {desc.aspect, 0, desc.mipLevels, 0, desc.layers};
    if (const Status s = device.made(vk.CreateImageView(device.handle(), &view, device.allocator(), &view_),
                                     VK_OBJECT_TYPE_IMAGE_VIEW, view_, what);
        s != Status::ok)
        return s;
    if (desc.mipLevels == 1 || !(desc.usage & VK_IMAGE_USAGE_STORAGE_BIT)) return Status::ok;
    view.subresourceRange.levelCount = 1;
    for (uint32_t mip = 0; mip < desc.mipLevels; ++mip) {
        view.subresourceRange.baseMipLevel = mip;
        VkImageView& made = mipViews_.emplace_back(VK_NULL_HANDLE);
        if (const Status s =
                device.made(vk.CreateImageView(device.handle(), &view, device.allocator(), &made),
                            VK_OBJECT_TYPE_IMAGE_VIEW, made, what);
            s != Status::ok)
            return s;
    }
    return Status::ok;
}

VkImageMemoryBarrier2 imageBarrier(VkImage image, const Use& before, const Use& after, uint32_t firstMip,
                                   uint32_t mips) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = before.stage;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stage;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = before.layout;
    barrier.newLayout = after.layout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, firstMip, mips, 0, VK_REMAINING_ARRAY_LAYERS};
    return barrier;
}

void recordBarriers(const Device& device, VkCommandBuffer commands, const VkImageMemoryBarrier2* barriers,
                    uint32_t count) {
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = count;
    dependency.pImageMemoryBarriers = barriers;
    device.vk().CmdPipelineBarrier2(commands, &dependency);
}

} // namespace seaglass::gpu
