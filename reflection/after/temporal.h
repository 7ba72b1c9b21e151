// Temporal reuse: of what a technique finds in a frame, and what the frame before left, a steadier picture.
// Each pixel is looked up where the last frame showed the same image behind the mirror; what does not match
// in class and distance is not taken, and colours are kept within those found around.
#pragma once

#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"
#include "reflection/march/open_tiles.h"
#include "reflection/sspr/unseen_tiles.h"

namespace seaglass {

struct TemporalKernel {
    SeenColumnsKernel columns;
    std::shared_ptr<UnseenTilesKernel> unseen;
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// The frame that left a history, and how long that is.
struct LastFrame {
    uint32_t count = 0; ///< frames in a row that it is made of; 0: there is none
    bool bent = false;  ///< by the view's own normals
    glm::dvec3 eye{0};
    glm::dvec3 facing{0};            ///< the plane's normal, on the side that was seen
    glm::dmat4 pixelFromRelative{1}; ///< without the jitter
    bool reversedDepth = false;
};

/// What temporal reuse needs for one view besides its images.
struct TemporalScratch {
    OwnedReflection found; ///< in this frame alone: what techniques write
    OwnedReflection other; ///< the last frame's images, which take turns with the view's own
    LastFrame last;
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
};

/// Besides those of tiles that are not looked up.
constexpr uint32_t temporalDispatches = 2;

/// From scratch.found, as techniques leave it, to `images`, left alike, whose own history becomes
/// scratch.other. Only in the tiles that are looked up, by the flags in `tiles`, whose lists are lost;
/// elsewhere nothing is known.
Status recordTemporal(const ReflectPass& pass, const TemporalKernel& temporal, const gpu::Buffer& tiles,
                      TemporalScratch& scratch, OwnedReflection& images);

} // namespace seaglass
