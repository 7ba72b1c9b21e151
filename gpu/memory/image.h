// A 2D image, or an array of them, with its own memory and one view of all of it.
#pragma once

#include <utility>
#include <vector>

#include "gpu/device.h"

namespace seaglass::gpu {

struct ImageDesc {
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent = {1, 1};
    VkImageUsageFlags usage = 0;
    uint32_t mipLevels = 1;
    uint32_t layers = 1;
    bool arrayView = false;                                ///< view as an array even with one layer
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT; ///< of its view
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

inline bool isSame(VkExtent2D a, VkExtent2D b) {
    return a.width == b.width && a.height == b.height;
}

/// Of all mips and layers, as tightly as the format allows.
VkDeviceSize imageBytes(const ImageDesc& desc);
/// Of the memory that this device wants for it.
VkDeviceSize heldBytes(const Device& device, const ImageDesc& desc);

class OwnedImage {
  public:
    OwnedImage() = default;
    ~OwnedImage() { release(); }
    OwnedImage(OwnedImage&& other) noexcept { *this = std::move(other); }
    OwnedImage& operator=(OwnedImage&& other) noexcept;

    Status create(const Device& device, const ImageDesc& desc, const char* what);

    VkImage handle() const { return image_; }
    VkImageView view() const { return view_; }
    /// As storage images are bound; the same as view() where there is no other mip.
    VkImageView firstMipView() const { return mipView(0); }
    /// One mip alone, of an image that shaders write to.
    VkImageView mipView(uint32_t mip) const { return mipViews_.empty() ? view_ : mipViews_[mip]; }
    const ImageDesc& desc() const { return desc_; }
    /// Whether it is there, and of this size.
    bool isOf(VkExtent2D extent) const { return image_ && isSame(desc_.extent, extent); }

  private:
    void release();

    const Device* device_ = nullptr;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    std::vector<VkImageView> mipViews_;
    MemoryPiece memory_;
    ImageDesc desc_;
};

/// Half of a barrier: what happened before, or what comes next.
struct Use {
    VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

constexpr Use sampledByShaders = {
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
        VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
    VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
/// What shaders sampled is to be overwritten: wait for them, keep nothing.
constexpr Use discardedAfterSampling = {sampledByShaders.stage, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
constexpr Use storageWritten = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                VK_IMAGE_LAYOUT_GENERAL};

constexpr Use copyWritten = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

/// Read and written by a kernel that changes it in place.
constexpr Use storageChanged = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                VK_IMAGE_LAYOUT_GENERAL};

/// By the host, as its attachments.
constexpr Use drawnColor = {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                            VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr Use drawnDepth = {
    VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};

/// A barrier on mip levels [firstMip, firstMip + mips) of a colour image, all layers.
VkImageMemoryBarrier2 imageBarrier(VkImage image, const Use& before, const Use& after, uint32_t firstMip = 0,
                                   uint32_t mips = VK_REMAINING_MIP_LEVELS);
void recordBarriers(const Device& device, VkCommandBuffer commands, const VkImageMemoryBarrier2* barriers,
                    uint32_t count);

} // namespace seaglass::gpu
