// What a technique is to a reflector: how it finds the reflection of one view. Each lies in a folder of its
// own; techniques.cpp lists them.
#pragma once

#include <memory>

#include "gpu/type_erased.h"
#include "reflection/core/reflect_pass.h"
#include "reflection/core/reflection_images.h"
#include "seaglass/reflection.h"

namespace seaglass {

struct Technique {
    bool readsScene = true;      ///< its colour is of the view's images; else the host draws it
    bool followsNormals = false; ///< of the view's surfaceNormals: its image is bent already
    bool followsRays = false;    ///< afterwards, where nothing is proven
    /// Kernels, shared with all who need them.
    Status (*createKernels)(Context& context, const ReflectionDesc& desc,
                            std::shared_ptr<void>& out) = nullptr;
    /// What one view needs besides its images, and how much that is.
    Status (*createScratch)(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc,
                            std::shared_ptr<void>& out) = nullptr;
    VkDeviceSize (*bytes)(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) = nullptr;
    uint32_t (*dispatches)(const gpu::Device& device, const ReflectionDesc& desc) = nullptr;
    /// Writes mip 0 of `images.color`, left as gpu::storageWritten says, and `images.info`, left to be
    /// sampled. Null: there is nothing to find, the sky alone is mirrored.
    Status (*record)(const ReflectPass& pass, void* kernels, void* scratch,
                     const OwnedReflection& images) = nullptr;
    /// Whose flags say where its images are looked up. Null: they may be anywhere.
    const gpu::Buffer& (*tiles)(const void* scratch) = nullptr;
};

const Technique& techniqueOf(ReflectionTechnique which);

/// Of kernels with create(context, desc), of what a view needs with create(device, extent, desc) and bytes(),
/// of `recordOf`, and of how much that dispatches.
template<typename Kernels, typename Scratch,
         Status (*recordOf)(const ReflectPass&, Kernels&, Scratch&, const OwnedReflection&)>
constexpr Technique techniqueFrom(uint32_t (*dispatches)(const gpu::Device&, const ReflectionDesc&)) {
    Technique technique;
    technique.dispatches = dispatches;
    technique.createKernels = [](Context& context, const ReflectionDesc& desc, std::shared_ptr<void>& out) {
        return gpu::makeShared<Kernels>(out).create(context, desc);
    };
    technique.createScratch = [](const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc,
                                 std::shared_ptr<void>& out) {
        return gpu::makeShared<Scratch>(out).create(device, extent, desc);
    };
    technique.bytes = &Scratch::bytes;
    technique.record = [](const ReflectPass& pass, void* kernels, void* scratch,
                          const OwnedReflection& images) {
        return recordOf(pass, *static_cast<Kernels*>(kernels), *static_cast<Scratch*>(scratch), images);
    };
    return technique;
}

} // namespace seaglass
