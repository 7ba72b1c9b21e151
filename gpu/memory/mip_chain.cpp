#include "gpu/memory/mip_chain.h"

#include <algorithm>
#include <array>
#include <vector>

#include "shaders/shared/mip_chain_block.h"
#include "spirv/mip_chain_rg16f.comp.h"
#include "spirv/mip_chain_rgba16f.comp.h"
#include "spirv/mip_chain_rgba32f.comp.h"

namespace seaglass::gpu {

namespace {

constexpr Use blitWritten = {VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr Use blitRead = {VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkOffset3D mipSize(const ImageDesc& desc, uint32_t mip) {
    const auto halved = [&](uint32_t size) { return static_cast<int32_t>(std::max(size >> mip, 1u)); };
    return {halved(desc.extent.width), halved(desc.extent.height), 1};
}

void blit(const Device& device, VkCommandBuffer commands, const OwnedImage& image, uint32_t mip) {
    const ImageDesc& desc = image.desc();
    VkImageBlit region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, desc.layers};
    region.srcOffsets[1] = mipSize(desc, mip - 1);
    region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, desc.layers};
    region.dstOffsets[1] = mipSize(desc, mip);
    device.vk().CmdBlitImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.handle(),
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_LINEAR);
}

/// One barrier an image and span of mips, gathered so that each step costs one command.
class Barriers {
  public:
    explicit Barriers(std::span<const OwnedImage* const> images) : images_(images) {}
    Barriers& add(const Use& before, const Use& after, uint32_t firstMip, uint32_t mips) {
        if (mips > 0)
            for (const OwnedImage* image : images_)
                list_.push_back(imageBarrier(image->handle(), before, after, firstMip, mips));
        return *this;
    }
    void record(const Device& device, VkCommandBuffer commands) {
        recordBarriers(device, commands, list_.data(), static_cast<uint32_t>(list_.size()));
        list_.clear();
    }

  private:
    std::span<const OwnedImage* const> images_;
    std::vector<VkImageMemoryBarrier2> list_;
};

void recordBlits(const Device& device, VkCommandBuffer commands, std::span<const OwnedImage* const> images,
                 const Use& written) {
    const uint32_t mips = images.front()->desc().mipLevels;
    Barriers barriers(images);
    barriers.add(written, blitRead, 0, 1)
        .add(discardedAfterSampling, blitWritten, 1, mips - 1)
        .record(device, commands);
    for (uint32_t mip = 1; mip < mips; ++mip) {
        if (mip > 1) barriers.add(blitWritten, blitRead, mip - 1, 1).record(device, commands);
        for (const OwnedImage* image : images) blit(device, commands, *image, mip);
    }
    barriers.add(blitRead, sampledByShaders, 0, mips - 1).add(blitWritten, sampledByShaders, mips - 1, 1);
    barriers.record(device, commands);
}

constexpr uint32_t halvings = 5; // of a dispatch
constexpr uint32_t groupEdge = 1 << halvings;

/// Five mips of three images at once are more than Vulkan promises.
bool byKernel(const Device& device) {
    return !device.isCpu() && device.limits().maxPerStageDescriptorStorageImages >= 3 * halvings;
}

/// A type for each format, for Context::share().
struct WideMipKernel {
    MipKernel mips;
    Status create(Context& context) {
        return mips.kernel.create(context.device, mip_chain_rgba32f_comp, "mips pipeline");
    }
};
struct NarrowMipKernel {
    MipKernel mips;
    Status create(Context& context) {
        return mips.kernel.create(context.device, mip_chain_rgba16f_comp, "mips pipeline");
    }
};

struct TwoChannelMipKernel {
    MipKernel mips;
    Status create(Context& context) {
        return mips.kernel.create(context.device, mip_chain_rg16f_comp, "mips pipeline");
    }
};

template<typename Variant>
Status shareVariant(Context& context, std::shared_ptr<MipKernel>& out) {
    std::shared_ptr<Variant> variant;
    if (const Status s = context.share(variant); s != Status::ok) return s;
    out = std::shared_ptr<MipKernel>(variant, &variant->mips);
    return Status::ok;
}

/// From `base`, ready to be sampled, to the mips after it, as many as one dispatch halves.
Status recordHalvings(Context& context, VkCommandBuffer commands, const Kernel& kernel,
                      std::span<const OwnedImage* const> images, uint32_t base) {
    const ImageDesc& desc = images.front()->desc();
    const uint32_t last = std::min(base + halvings, desc.mipLevels - 1);
    Slice slice;
    if (const Status s = context.frame().upload(MipChainBlock{last - base, 0, 0, 0}, slice); s != Status::ok)
        return s;
    std::vector<Bound> resources = {{mipChainBinding, uniformBuffer(slice)}};
    uint32_t source = firstSourceBinding;
    for (const OwnedImage* image : images)
        resources.push_back({source++, sampledImage(context.samplers.nearestClamp(), image->mipView(base))});
    // What nothing is stored to needs something to point at.
    uint32_t halved = firstHalvedBinding;
    for (const OwnedImage* image : images)
        for (uint32_t mip = base + 1; mip <= base + halvings; ++mip)
            resources.push_back({halved++, storageImage(*image, std::min(mip, last))});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    const auto groups = [&](uint32_t size) {
        return (std::max(size >> base, 1u) + groupEdge - 1) / groupEdge;
    };
    kernel.dispatch(commands, set, groups(desc.extent.width), groups(desc.extent.height),
                    desc.layers * static_cast<uint32_t>(images.size()));
    return Status::ok;
}

Status recordKernels(Context& context, VkCommandBuffer commands, const Kernel& kernel,
                     std::span<const OwnedImage* const> images, const Use& written) {
    const Device& device = context.device;
    const uint32_t mips = images.front()->desc().mipLevels;
    Barriers barriers(images);
    barriers.add(written, sampledByShaders, 0, 1)
        .add(discardedAfterSampling, storageWritten, 1, mips - 1)
        .record(device, commands);
    for (uint32_t base = 0; base + 1 < mips; base += halvings) {
        if (const Status s = recordHalvings(context, commands, kernel, images, base); s != Status::ok)
            return s;
        const uint32_t made = std::min(halvings, mips - 1 - base);
        barriers.add(storageWritten, sampledByShaders, base + 1, made).record(device, commands);
    }
    return Status::ok;
}

} // namespace

Status MipChain::create(Context& context, VkFormat format) {
    if (!byKernel(context.device)) return Status::ok;
    switch (format) {
    case VK_FORMAT_R32G32B32A32_SFLOAT:
        return shareVariant<WideMipKernel>(context, kernel_);
    case VK_FORMAT_R16G16_SFLOAT:
        return shareVariant<TwoChannelMipKernel>(context, kernel_);
    default:
        return shareVariant<NarrowMipKernel>(context, kernel_);
    }
}

VkImageUsageFlags MipChain::usage(const Device& device) {
    return byKernel(device) ? VK_IMAGE_USAGE_STORAGE_BIT
                            : VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
}

Status MipChain::record(Context& context, VkCommandBuffer commands, std::span<const OwnedImage* const> images,
                        const Use& written) const {
    if (images.front()->desc().mipLevels == 1)
        Barriers(images).add(written, sampledByShaders, 0, 1).record(context.device, commands);
    else if (kernel_)
        return recordKernels(context, commands, kernel_->kernel, images, written);
    else
        recordBlits(context.device, commands, images, written);
    return Status::ok;
}

} // namespace seaglass::gpu
