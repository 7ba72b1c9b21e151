#include "water/shading/shaded_surface.h"

#include <algorithm>

#include "shaders/shared/water_bindings.h"
#include "spirv/completed_surface.comp.h"
#include "spirv/shaded_surface.comp.h"

namespace seaglass {

namespace {

/// Where one of several pixels is shaded, the one beside it has a texel, too.
gpu::ImageDesc colorDesc(VkExtent2D extent, SurfaceOutput output) {
    extent.width += extent.width % 2;
    return {.format = output == SurfaceOutput::shaded ? VK_FORMAT_R16G16B16A16_SFLOAT
                                                      : VK_FORMAT_R32G32B32A32_SFLOAT,
            .extent = extent,
            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
}

gpu::ImageDesc mirroredDesc(VkExtent2D extent) {
    return {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent, .usage = VK_IMAGE_USAGE_STORAGE_BIT};
}

/// The colour that a kernel stored is read and stored by the next.
void recordWritten(const gpu::Device& device, VkCommandBuffer commands) {
    gpu::recordBarrier(device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT});
}

} // namespace

Status buildShading(const gpu::Device& device, const SurfaceVariant& variant, gpu::Kernel& out) {
    SurfaceVariant made = variant;
    // A barrier of the whole group costs CPU devices most: all that is alive goes to memory. Of those that
    // there are, subgroups are full, and of four or eight.
    made.quadsInStep = device.isCpu();
    return out.create(device, shaded_surface_comp, "shaded surface", made.constants());
}

SurfaceVariant shadingVariant(const SurfaceVariant& all) {
    SurfaceVariant v = all;
    v.shape = 0;
    v.exclusionVolumes = 0;
    return v;
}

SurfaceVariant stepVariant(const SurfaceVariant& all, ShadingStep step) {
    SurfaceVariant v = shadingVariant(all);
    v.shadingStep = static_cast<uint32_t>(step);
    if (step == ShadingStep::all || step == ShadingStep::rest) return v;
    // Kernels that do alike are one.
    const SurfaceVariant usual;
    v.hasFoam = v.hasSunShadow = v.hasSubsurfaceScattering = v.hasGlitter = false;
    v.foamCascades = usual.foamCascades;
    if (step == ShadingStep::bed) {
        v.waveShadowSteps = usual.waveShadowSteps;
        v.reflectionSamples = usual.reflectionSamples;
    } else {
        v.refractionSamples = usual.refractionSamples;
        v.bedDownscale = usual.bedDownscale;
    }
    return v;
}

bool isAny(const ListedKernels& of) {
    return std::ranges::any_of(of, [](const gpu::Kernel* kernel) { return kernel; });
}

bool takesSteps(const gpu::Device& device) {
    return !device.isCpu();
}

Status getListed(ShadingKernels& kernels, const SurfaceVariant& variant, const TileSorting& sorting,
                 bool apart, SteppedKernels& out) {
    out = {};
    // Of both sides the rest alone takes as many registers as all at once, and it shades each pixel, for
    // which what is mirrored would want an image of its own.
    const bool hasSteps = apart && variant.surfaceOutput == static_cast<uint32_t>(SurfaceOutput::shaded) &&
                          variant.sidesSeen == static_cast<uint32_t>(SidesSeen::above);
    for (uint32_t list = 0; list < foundLists; ++list) {
        if (!sorting.uses(list)) continue;
        SurfaceVariant needed = variant;
        needed.hasReflection = list & foundMirrors;
        needed.hasRefraction = list & foundSeesBed;
        const auto get = [&](ShadingStep step, const gpu::Kernel*& kernel) {
            return kernels.get(stepVariant(needed, step), kernel);
        };
        if (hasSteps && needed.hasRefraction)
            if (const Status s = get(ShadingStep::bed, out.beds[list]); s != Status::ok) return s;
        if (hasSteps && needed.hasReflection && needed.hasWaves)
            if (const Status s = get(ShadingStep::mirror, out.mirrors[list]); s != Status::ok) return s;
        const bool isRest = out.beds[list] || out.mirrors[list];
        if (const Status s = get(isRest ? ShadingStep::rest : ShadingStep::all, out.rest[list]);
            s != Status::ok)
            return s;
    }
    return Status::ok;
}

Status buildCompleting(const gpu::Device& device, const uint32_t& pixelsPerShading, gpu::Kernel& out) {
    TilesConstants constants;
    constants.pixelsPerShading = pixelsPerShading;
    return out.create(device, completed_surface_comp, "completed surface", constants.constants());
}

Status ShadedSurface::create(const gpu::Device& device, VkExtent2D extent, SurfaceOutput output,
                             bool mirrorsApart) {
    if (const Status s = color.create(device, colorDesc(extent, output), "shaded surface"); s != Status::ok)
        return s;
    if (mirrorsApart)
        if (const Status s = mirrored.create(device, mirroredDesc(extent), "mirrored by the surface");
            s != Status::ok)
            return s;
    return tiles.create(device, extent);
}

VkDeviceSize ShadedSurface::bytes(const gpu::Device& device, VkExtent2D extent, bool mirrorsApart) {
    return gpu::heldBytes(device, colorDesc(extent, SurfaceOutput::shaded)) +
           (mirrorsApart ? gpu::heldBytes(device, mirroredDesc(extent)) : 0) +
           SurfaceTiles::bytes(device, extent);
}

Status ShadedSurface::recordListed(Context& context, VkCommandBuffer commands, const ListedKernels& kernels,
                                   const Resources& resources) const {
    for (uint32_t list = 0; list < foundLists; ++list) {
        if (!kernels[list]) continue;
        VkDescriptorSet set = VK_NULL_HANDLE;
        if (const Status s = context.frame().allocateSet(kernels[list]->layout(), resources, set);
            s != Status::ok)
            return s;
        kernels[list]->dispatchIndirect(commands, set, tiles.handle(), SurfaceTiles::groupsOffset(list));
    }
    return Status::ok;
}

Status ShadedSurface::recordShading(Context& context, VkCommandBuffer commands, const SteppedKernels& kernels,
                                    const Resources& resources) const {
    if (const Status s = recordListed(context, commands, kernels.beds, resources); s != Status::ok) return s;
    if (const Status s = recordListed(context, commands, kernels.mirrors, resources); s != Status::ok)
        return s;
    if (isAny(kernels.beds) || isAny(kernels.mirrors)) recordWritten(context.device, commands);
    return recordListed(context, commands, kernels.rest, resources);
}

Status ShadedSurface::recordCompleting(Context& context, VkCommandBuffer commands, const gpu::Kernel& kernel,
                                       const Resources& resources, uint32_t tileCount) const {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands, "completed_surface");
    recordWritten(context.device, commands);
    kernel.dispatch(commands, set, std::min(tileCount, foundGroupsPerRow),
                    (tileCount + foundGroupsPerRow - 1) / foundGroupsPerRow);
    return Status::ok;
}

Status ShadedSurface::record(Context& context, VkCommandBuffer commands, const ShadedBy& kernels,
                             const FoundSurface& found, Resources resources, VkExtent2D region) const {
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    resources.push_back({foundDepthBinding, gpu::sampledImage(nearest, found.depth())});
    resources.push_back({foundAsideBinding, gpu::sampledImage(nearest, found.beside())});
    resources.push_back({foundTilesBinding, gpu::storageBuffer(tiles.handle())});
    resources.push_back({shadedBinding, gpu::storageImage(color)});
    if (mirrored.handle()) resources.push_back({mirroredBinding, gpu::storageImage(mirrored)});
    const uint32_t count = tileCount(region, kernels.pixelsPerShading);
    if (const Status s = tiles.record(context, commands, *kernels.listing, resources, count); s != Status::ok)
        return s;
    const gpu::PassScope pass(device, commands, "shaded_surface");
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(color.handle(), gpu::discardedAfterSampling, gpu::storageWritten),
        gpu::imageBarrier(mirrored.handle(), gpu::discardedAfterSampling, gpu::storageWritten)};
    gpu::recordBarriers(device, commands, before, mirrored.handle() ? 2 : 1);
    if (const Status s = recordShading(context, commands, kernels.shading, resources); s != Status::ok)
        return s;
    if (kernels.completing)
        if (const Status s = recordCompleting(context, commands, *kernels.completing, resources, count);
            s != Status::ok)
            return s;
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(color.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

} // namespace seaglass
