// The images that a host draws its scene into once more, in formats and with samples of its own: for a planar
// reflection, or of a bed.
#pragma once

#include "gpu/memory/image.h"
#include "seaglass/reflection.h"

namespace seaglass {

/// Says what of `drawn` cannot be drawn into and sampled; `owner` is the struct that holds it.
Status checkDrawn(const gpu::Device& device, const DrawnDesc& drawn, const char* owner);

gpu::ImageDesc drawnColorDesc(const DrawnDesc& drawn, VkExtent2D extent);
gpu::ImageDesc drawnDepthDesc(const DrawnDesc& drawn, VkExtent2D extent);

/// Says in `out` what a host is to draw into.
void setImages(const gpu::OwnedImage& color, const gpu::OwnedImage& depth, double farDepth, PlanarView& out);

/// From attachments, as the host has left them.
VkImageMemoryBarrier2 colorDrawn(const gpu::OwnedImage& color, const gpu::Use& next);
VkImageMemoryBarrier2 depthDrawn(const gpu::OwnedImage& depth);

} // namespace seaglass
