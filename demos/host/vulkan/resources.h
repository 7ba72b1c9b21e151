// Buffers and images with memory of their own, and how bytes get into them.
#pragma once

#include <cstddef>
#include <span>

#include "host/vulkan/device.h"

namespace demos {

struct Buffer {
    UniqueMemory memory;
    UniqueBuffer buffer;
    VkDeviceSize size = 0;
    void* mapped = nullptr; ///< null when not visible to the CPU
};

enum class BufferPlace { device, upload, readback };

bool createBuffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, BufferPlace place,
                  Buffer& out, Error& error);
/// A device buffer filled with `bytes`.
bool createFilledBuffer(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                        Buffer& out, Error& error);

struct Image {
    UniqueMemory memory;
    UniqueImage image;
    UniqueImageView view;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent = {0, 0};
    uint32_t mips = 1;
    uint32_t layers = 1;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT; ///< of the view and of copies: never stencil
    VkDeviceSize bytes = 0;                                ///< of its memory
};

struct ImageDesc {
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent = {1, 1};
    uint32_t mips = 1;
    bool cube = false;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageUsageFlags usage = 0;
};

/// An image too large for the device is an error that names the limit.
bool createImage(const Device& device, const ImageDesc& desc, Image& out, Error& error);

/// Of a 2D image, as an array of its layers.
bool createArrayView(const Device& device, const Image& image, UniqueImageView& out, Error& error);

/// A sampled image with all its mips: `levels` holds them largest first, the faces of a cube one after
/// another in each. With one level given and more in the image, the rest is made by halving. Ends in
/// SHADER_READ_ONLY_OPTIMAL.
bool createSampledImage(Device& device, ImageDesc desc, std::span<const std::span<const std::byte>> levels,
                        Image& out, Error& error);

/// One whole-image barrier.
void imageBarrier(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to,
                  VkPipelineStageFlags2 fromStage, VkAccessFlags2 fromAccess, VkPipelineStageFlags2 toStage,
                  VkAccessFlags2 toAccess);

/// What was copied is for the CPU to read.
void transferToHost(VkCommandBuffer commands);

struct SamplerDesc {
    VkSamplerAddressMode u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSamplerAddressMode v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkFilter larger = VK_FILTER_LINEAR, smaller = VK_FILTER_LINEAR; ///< than texels; smaller
    VkSamplerMipmapMode mips = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    bool largestMipAlone = false;
    bool anisotropic = false;
    bool compare = false; ///< less or equal, white outside
};

bool createSampler(const Device& device, const SamplerDesc& desc, UniqueSampler& out, Error& error);

uint32_t fullMipCount(VkExtent2D extent);

} // namespace demos
