// Planar reflection: the host draws its scene once more with a mirrored camera; what it drew becomes colour,
// class and hit distance.
#pragma once

#include "reflection/core/color_kernel.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"
#include "reflection/interface/drawn_images.h"

namespace seaglass {

/// Where the host's colour is, by the samples of a pixel.
enum class PlanarForm {
    inPlace,      ///< in the reflection's own colour, depth with one sample
    apart,        ///< in an image of its own, both with one sample
    resolved,     ///< likewise, depth with many
    multisampled, ///< likewise, both with many
};

PlanarForm planarForm(const DrawnDesc& drawn);
/// The host draws into mip 0 of what the technique leaves.
inline bool drawnInPlace(const ReflectionDesc& desc) {
    return desc.technique == ReflectionTechnique::planar && planarForm(desc.drawn) == PlanarForm::inPlace;
}

struct PlanarKernel {
    ColorKernel kernel;
};
template<PlanarForm form>
struct PlanarKernelOf : PlanarKernel {
    Status create(Context& context);
};
struct PlanarKernels {
    std::shared_ptr<PlanarKernel> planar;
    Status create(Context& context, const ReflectionDesc& desc);
};

/// What planar reflection needs for one view besides its images.
struct PlanarScratch {
    gpu::OwnedImage color; ///< empty where the host draws in place
    gpu::OwnedImage depth;
    bool handedOut = false; ///< the host was told what to draw since the last reflect()
    Status create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc);
    const gpu::OwnedImage& drawnColor(const OwnedReflection& images) const {
        return color.handle() ? color : images.color;
    }
};

/// The camera behind the mirror. Its view is the host's view times the Householder reflection, so a mirrored
/// point lands on the pixel where the plane shows it.
struct MirroredCamera {
    glm::dmat4 view{1};
    glm::dmat4 projection{1};
    bool obliqueClip = false;
    glm::dvec4 heightRow{
        0}; ///< a drawn point's height is heightRow.p / weightRow.p for p = (x, y, its depth, 1)
    glm::dvec4 weightRow{0};
};

MirroredCamera mirroredCamera(const ViewDesc& view, const ViewGeometry& geometry,
                              const glm::dvec4& worldPlane);

PlanarView describe(const MirroredCamera& camera, const ViewDesc& view, const ViewGeometry& geometry,
                    uint32_t downscale, const PlanarScratch& scratch, const OwnedReflection& images);

} // namespace seaglass
