#include "host/vulkan/resources.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace demos {
namespace {

std::string sizeText(VkExtent2D extent) {
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

bool allocate(const Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
              VkMemoryPropertyFlags preferred, UniqueMemory& out, Error& error) {
    const uint32_t type = device.memoryType(needs.memoryTypeBits, required, preferred);
    if (type == UINT32_MAX) {
        error.text = "the device has no suitable memory";
        return false;
    }
    const VkDeviceSize limit = std::min(device.maxAllocation(), device.heapSize(type));
    if (needs.size > limit) {
        error.text = "an allocation of " + std::to_string(needs.size >> 20) +
                     " MiB is over the device's limit of " + std::to_string(limit >> 20) + " MiB";
        return false;
    }
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    if (!succeeded(vkAllocateMemory(device.handle(), &info, nullptr, &memory), "vkAllocateMemory", error))
        return false;
    out = UniqueMemory(device.handle(), memory);
    return true;
}

VkImageView makeView(const Device& device, const Image& image, VkImageViewType type, Error& error) {
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image.image.get();
    info.viewType = type;
    info.format = image.format;
    info.subresourceRange = {image.aspect, 0, image.mips, 0, image.layers};
    VkImageView view = VK_NULL_HANDLE;
    succeeded(vkCreateImageView(device.handle(), &info, nullptr, &view), "vkCreateImageView", error);
    return view;
}

bool holdsStencil(VkFormat format) {
    return format == VK_FORMAT_D16_UNORM_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT ||
           format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

VkImageAspectFlags viewedAspect(VkFormat format) {
    const bool depth = holdsStencil(format) || format == VK_FORMAT_D16_UNORM ||
                       format == VK_FORMAT_X8_D24_UNORM_PACK32 || format == VK_FORMAT_D32_SFLOAT;
    return depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkExtent2D halved(VkExtent2D extent, uint32_t level) {
    return {std::max(1u, extent.width >> level), std::max(1u, extent.height >> level)};
}

/// Half of a barrier: what happened before, or what comes next.
struct Use {
    VkImageLayout layout;
    VkPipelineStageFlags2 stage;
    VkAccessFlags2 access;
};

void barrierOn(VkCommandBuffer commands, const Image& image, const VkImageSubresourceRange& range,
               const Use& before, const Use& after) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = before.stage;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stage;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = before.layout;
    barrier.newLayout = after.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image.get();
    barrier.subresourceRange = range;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

/// Fills level 1 and on from level 0, leaving every level but the last as a transfer source.
void halveLevels(VkCommandBuffer commands, const Image& image) {
    constexpr VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    constexpr Use written = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, stage, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    constexpr Use read = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, stage, VK_ACCESS_2_TRANSFER_READ_BIT};
    constexpr Use asBefore = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, stage, VK_ACCESS_2_NONE};
    const auto levelOf = [&](uint32_t level) {
        return VkImageSubresourceRange{image.aspect, level, 1, 0, image.layers};
    };
    for (uint32_t level = 1; level < image.mips; ++level) {
        barrierOn(commands, image, levelOf(level - 1), written, read);
        const VkExtent2D from = halved(image.extent, level - 1);
        const VkExtent2D to = halved(image.extent, level);
        VkImageBlit blit{};
        blit.srcSubresource = {image.aspect, level - 1, 0, image.layers};
        blit.srcOffsets[1] = {static_cast<int32_t>(from.width), static_cast<int32_t>(from.height), 1};
        blit.dstSubresource = {image.aspect, level, 0, image.layers};
        blit.dstOffsets[1] = {static_cast<int32_t>(to.width), static_cast<int32_t>(to.height), 1};
        vkCmdBlitImage(commands, image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.image.get(),
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    }
    for (uint32_t level = 0; level + 1 < image.mips; ++level)
        barrierOn(commands, image, levelOf(level), read, asBefore);
}

} // namespace

bool createBuffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, BufferPlace place,
                  Buffer& out, Error& error) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size;
    info.usage = usage;
    VkBuffer buffer = VK_NULL_HANDLE;
    if (!succeeded(vkCreateBuffer(device.handle(), &info, nullptr, &buffer), "vkCreateBuffer", error))
        return false;
    Buffer made;
    made.buffer = UniqueBuffer(device.handle(), buffer);
    made.size = size;
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device.handle(), buffer, &needs);
    const bool visible = place != BufferPlace::device;
    const VkMemoryPropertyFlags required =
        visible ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT : 0;
    const VkMemoryPropertyFlags preferred = place == BufferPlace::readback
                                                ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                            : visible ? 0
                                                      : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    if (!allocate(device, needs, required, preferred, made.memory, error)) return false;
    if (!succeeded(vkBindBufferMemory(device.handle(), buffer, made.memory.get(), 0), "vkBindBufferMemory",
                   error))
        return false;
    if (visible &&
        !succeeded(vkMapMemory(device.handle(), made.memory.get(), 0, VK_WHOLE_SIZE, 0, &made.mapped),
                   "vkMapMemory", error))
        return false;
    out = std::move(made);
    return true;
}

bool createFilledBuffer(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                        Buffer& out, Error& error) {
    Buffer staging;
    if (!createBuffer(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferPlace::upload, staging,
                      error) ||
        !createBuffer(device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace::device,
                      out, error))
        return false;
    std::memcpy(staging.mapped, bytes.data(), bytes.size());
    return device.run(
        [&](VkCommandBuffer commands, Error&) {
            const VkBufferCopy copy = {0, 0, bytes.size()};
            vkCmdCopyBuffer(commands, staging.buffer.get(), out.buffer.get(), 1, &copy);
            return true;
        },
        error);
}

bool createImage(const Device& device, const ImageDesc& desc, Image& out, Error& error) {
    const VkPhysicalDeviceLimits& limits = device.properties().limits;
    const uint32_t limit = desc.cube ? limits.maxImageDimensionCube : limits.maxImageDimension2D;
    if (desc.extent.width == 0 || desc.extent.height == 0 || desc.extent.width > limit ||
        desc.extent.height > limit) {
        error.text = "an image of " + sizeText(desc.extent) + " pixels is not possible here, expected 1 to " +
                     std::to_string(limit) + " each way";
        return false;
    }
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    if (desc.cube) info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = desc.format;
    info.extent = {desc.extent.width, desc.extent.height, 1};
    info.mipLevels = desc.mips;
    info.arrayLayers = desc.cube ? 6 : 1;
    info.samples = desc.samples;
    info.usage = desc.usage;
    Image made;
    made.format = desc.format;
    made.extent = desc.extent;
    made.mips = desc.mips;
    made.layers = info.arrayLayers;
    made.aspect = viewedAspect(desc.format);
    VkImage image = VK_NULL_HANDLE;
    if (!succeeded(vkCreateImage(device.handle(), &info, nullptr, &image), "vkCreateImage", error))
        return false;
    made.image = UniqueImage(device.handle(), image);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device.handle(), image, &needs);
    made.bytes = needs.size;
    if (!allocate(device, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, made.memory, error)) {
        error.text = "an image of " + sizeText(desc.extent) + " pixels: " + error.text;
        return false;
    }
    if (!succeeded(vkBindImageMemory(device.handle(), image, made.memory.get(), 0), "vkBindImageMemory",
                   error))
        return false;
    made.view = UniqueImageView(
        device.handle(),
        makeView(device, made, desc.cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D, error));
    if (!made.view) return false;
    out = std::move(made);
    return true;
}

bool createArrayView(const Device& device, const Image& image, UniqueImageView& out, Error& error) {
    out = UniqueImageView(device.handle(), makeView(device, image, VK_IMAGE_VIEW_TYPE_2D_ARRAY, error));
    return static_cast<bool>(out);
}

bool createSampledImage(Device& device, ImageDesc desc, std::span<const std::span<const std::byte>> levels,
                        Image& out, Error& error) {
    const bool halving = levels.size() < desc.mips;
    desc.usage |= VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (halving) desc.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    size_t bytes = 0;
    for (const auto& level : levels) bytes += level.size();
    Buffer staging;
    if (!createBuffer(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferPlace::upload, staging, error) ||
        !createImage(device, desc, out, error))
        return false;
    std::vector<VkBufferImageCopy> copies;
    size_t offset = 0;
    for (uint32_t level = 0; level < levels.size(); ++level) {
        std::memcpy(static_cast<std::byte*>(staging.mapped) + offset, levels[level].data(),
                    levels[level].size());
        const VkExtent2D extent = halved(desc.extent, level);
        VkBufferImageCopy copy{};
        copy.bufferOffset = offset;
        copy.imageSubresource = {out.aspect, level, 0, out.layers};
        copy.imageExtent = {extent.width, extent.height, 1};
        copies.push_back(copy);
        offset += levels[level].size();
    }
    return device.run(
        [&](VkCommandBuffer commands, Error&) {
            imageBarrier(commands, out, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 0, 0,
                         VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
            vkCmdCopyBufferToImage(commands, staging.buffer.get(), out.image.get(),
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<uint32_t>(copies.size()),
                                   copies.data());
            if (halving) halveLevels(commands, out);
            imageBarrier(commands, out, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                         VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                         VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
            return true;
        },
        error);
}

void imageBarrier(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to,
                  VkPipelineStageFlags2 fromStage, VkAccessFlags2 fromAccess, VkPipelineStageFlags2 toStage,
                  VkAccessFlags2 toAccess) {
    // Depth and stencil change their layout together.
    const VkImageAspectFlags stencil = holdsStencil(image.format) ? VK_IMAGE_ASPECT_STENCIL_BIT : 0;
    barrierOn(commands, image, {image.aspect | stencil, 0, image.mips, 0, image.layers},
              {from, fromStage, fromAccess}, {to, toStage, toAccess});
}

void transferToHost(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

bool createSampler(const Device& device, const SamplerDesc& desc, UniqueSampler& out, Error& error) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = desc.larger;
    info.minFilter = desc.smaller;
    info.mipmapMode = desc.mips;
    info.addressModeU = desc.u;
    info.addressModeV = desc.v;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    // A quarter tells larger from smaller, and rounds to the first (glTF's filters without mips).
    info.maxLod = desc.largestMipAlone ? 0.25f : VK_LOD_CLAMP_NONE;
    info.anisotropyEnable = desc.anisotropic && device.anisotropy();
    info.maxAnisotropy = std::min(8.0f, device.properties().limits.maxSamplerAnisotropy);
    info.compareEnable = desc.compare;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    info.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
    VkSampler sampler = VK_NULL_HANDLE;
    if (!succeeded(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "vkCreateSampler", error))
        return false;
    out = UniqueSampler(device.handle(), sampler);
    return true;
}

uint32_t fullMipCount(VkExtent2D extent) {
    return static_cast<uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

} // namespace demos
