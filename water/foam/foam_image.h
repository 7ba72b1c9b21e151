// The foam history as shaders read it: of each cascade that breaks, what is clear of foam at the step before
// the drawn time and at the one after, and two steps of plumes, with whole mip chains. What a mip holds is
// the mean over its footprint, so cover is kept with distance.
//
// 1 - F, since halves tell it apart where F is close to 1: there 0.0005 of F are 0.05 of its odds, and what
// is lost of those in thick foam is a tenth of F when it is thin.
#pragma once

#include "gpu/context.h"
#include "gpu/memory/image.h"
#include "gpu/memory/mip_chain.h"

namespace seaglass {

struct FoamImage {
    gpu::OwnedImage image;
    gpu::MipChain mips;

    /// `filledBy` is the usage that whoever fills mip 0 needs.
    Status create(Context& context, uint32_t samples, uint32_t cascades, VkImageUsageFlags filledBy);
    static VkDeviceSize bytes(const gpu::Device& device, uint32_t samples, uint32_t cascades,
                              VkImageUsageFlags filledBy);
    /// From mip 0 `written` to all mips readable by shaders.
    Status recordMips(Context& context, VkCommandBuffer commands, const gpu::Use& written) const;
};

} // namespace seaglass
