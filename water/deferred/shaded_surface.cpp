#include "water/deferred/shaded_surface.h"

#include "shaders/shared/water_bindings.h"
#include "spirv/shaded_surface.comp.h"

namespace seaglass {

namespace {

gpu::ImageDesc colorDesc(VkExtent2D extent, SurfaceOutput output) {
    return {.format = output == SurfaceOutput::shaded ? VK_FORMAT_R16G16B16A16_SFLOAT
                                                      : VK_FORMAT_R32G32B32A32_SFLOAT,
            .extent = extent,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
}

} // namespace

Status ShadingKernels::get(const SurfaceVariant& variant, const gpu::Kernel*& out) {
    return kernels_.get(
        variant,
        [&](gpu::Kernel& kernel) {
            SurfaceVariant made = variant;
            // A barrier of the whole group costs CPU devices most: all that is alive goes to memory. Of those
            // that there are, subgroups are full, and of four or eight.
            made.quadsInStep = device_->isCpu();
            return kernel.create(*device_, shaded_surface_comp, "shaded surface", made.constants());
        },
        out);
}

SurfaceVariant shadingVariant(const SurfaceVariant& all) {
    SurfaceVariant v = all;
    v.shape = 0;
    v.exclusionVolumes = 0;
    return v;
}

Status getListed(ShadingKernels& kernels, const SurfaceVariant& variant, const TileSorting& sorting,
                 ListedKernels& out) {
    for (uint32_t list = 0; list < foundLists; ++list) {
        out[list] = nullptr;
        if (!sorting.uses(list)) continue;
        SurfaceVariant needed = shadingVariant(variant);
        needed.hasReflection = list & foundMirrors;
        needed.hasRefraction = list & foundSeesBed;
        if (const Status s = kernels.get(needed, out[list]); s != Status::ok) return s;
    }
    return Status::ok;
}

Status ShadedSurface::create(const gpu::Device& device, VkExtent2D extent, SurfaceOutput output) {
    if (const Status s = color.create(device, colorDesc(extent, output), "shaded surface"); s != Status::ok)
        return s;
    return tiles.create(device, extent);
}

VkDeviceSize ShadedSurface::bytes(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, colorDesc(extent, SurfaceOutput::shaded)) +
           SurfaceTiles::bytes(device, extent);
}

Status ShadedSurface::record(Context& context, VkCommandBuffer commands, const TilesKernels& listing,
                             const ListedKernels& shading, const FoundSurface& found, Resources resources,
                             VkExtent2D region) const {
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    resources.push_back({foundDepthBinding, gpu::sampledImage(nearest, found.depth())});
    resources.push_back({foundAsideBinding, gpu::sampledImage(nearest, found.beside())});
    resources.push_back({foundTilesBinding, gpu::storageBuffer(tiles.handle())});
    resources.push_back({shadedBinding, gpu::storageImage(color.view())});
    if (const Status s = tiles.record(context, commands, listing, resources, region); s != Status::ok)
        return s;
    const gpu::PassScope pass(device, commands, "shaded_surface");
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(color.handle(), gpu::discardedAfterSampling, gpu::storageWritten);
    gpu::recordBarriers(device, commands, &before, 1);
    for (uint32_t list = 0; list < foundLists; ++list) {
        if (!shading[list]) continue;
        VkDescriptorSet set = VK_NULL_HANDLE;
        if (const Status s = context.frame().allocateSet(shading[list]->layout(), resources, set);
            s != Status::ok)
            return s;
        shading[list]->dispatchIndirect(commands, set, tiles.handle(), SurfaceTiles::groupsOffset(list));
    }
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(color.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

} // namespace seaglass
