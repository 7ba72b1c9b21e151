// Planar reflection: the host draws its scene once more with a mirrored camera; what it drew becomes colour,
// class and hit distance.
#pragma once

#include "gpu/kernel.h"
#include "reflection/reflect_pass.h"
#include "reflection/reflection_images.h"

namespace seaglass {

struct PlanarKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// A depth image that a host draws into and shaders sample.
gpu::ImageDesc drawnDepthDesc(VkExtent2D extent);

/// Says in `out` what a host is to draw into.
void setImages(const gpu::OwnedImage& color, const gpu::OwnedImage& depth, double farDepth, PlanarView& out);

/// What planar reflection needs for one view besides its images.
struct PlanarScratch {
    gpu::OwnedImage depth;
    bool handedOut = false; ///< the host was told what to draw since the last reflect()
    Status create(const gpu::Device& device, VkExtent2D extent);
    static VkDeviceSize bytes(const gpu::Device& device, VkExtent2D extent);
};

constexpr uint32_t planarDispatches = 1;

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

/// Takes mip 0 of `images.color` and the depth from attachments, as the host has left them. Leaves the images
/// as recordSspr() does.
Status recordPlanar(const ReflectPass& pass, const PlanarKernel& planar, const PlanarScratch& scratch,
                    const glm::dvec4& worldPlane, const OwnedReflection& images);

} // namespace seaglass
