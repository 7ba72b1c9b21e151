#include "reflection/sspr/sspr.h"

#include "reflection/core/mirror.h"
#include "reflection/core/technique.h"
#include "reflection/sspr/unseen_tiles.h"

namespace seaglass {

namespace {

VkDeviceSize keyBytes(VkExtent2D extent, const ReflectionDesc& desc) {
    const VkExtent2D grid = scaledDown(extent, keyScale(desc));
    return VkDeviceSize{grid.width} * grid.height * sizeof(uint32_t);
}

constexpr VkBufferUsageFlags keyUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

template<typename Variant, typename Kernel>
Status shareVariant(Context& context, Kernel Variant::*of, std::shared_ptr<Kernel>& out) {
    std::shared_ptr<Variant> variant;
    if (const Status s = context.share(variant); s != Status::ok) return s;
    out = std::shared_ptr<Kernel>(variant, &(variant.get()->*of));
    return Status::ok;
}

/// Where the reflection's height is given, a view's size says which it takes.
Status shareScatter(Context& context, const ReflectionDesc& desc, SsprKernels& out) {
    const bool either = desc.height > 0 && !desc.coarseKeys, coarse = keyScale(desc) > 1;
    if (either || !coarse)
        if (const Status s = context.share(out.scatter); s != Status::ok) return s;
    if (!either && !coarse) return Status::ok;
    return shareVariant(context, &CoarseScatterKernel::scatter, out.coarseScatter);
}

Status shareTiles(Context& context, const ReflectionDesc& desc, std::shared_ptr<TilesKernel>& out) {
    return looksForOverhangs(desc) ? shareVariant(context, &OverhangsTilesKernel::tiles, out)
                                   : context.share(out);
}

Status shareResolve(Context& context, const ReflectionDesc& desc, std::shared_ptr<ResolveKernel>& out) {
    return looksForOverhangs(desc) ? shareVariant(context, &OverhangsResolveKernel::resolve, out)
                                   : context.share(out);
}

} // namespace

Status SsprKernels::create(Context& context, const ReflectionDesc& desc) {
    if (const Status s = shareScatter(context, desc, *this); s != Status::ok) return s;
    if (const Status s = shareTiles(context, desc, tiles); s != Status::ok) return s;
    return shareResolve(context, desc, resolve);
}

VkDeviceSize SsprScratch::bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    return gpu::heldBytes(device, keyBytes(extent, desc), keyUsage) +
           heldByTiles(device, scaledDown(extent, desc));
}

Status SsprScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    const VkDeviceSize wanted = keyBytes(extent, desc);
    if (wanted > device.limits().maxStorageBufferRange)
        return device.fail(Status::unsupported,
                           "reflect: %u x %u pixels need a storage buffer of %llu bytes, the device has %u",
                           extent.width, extent.height, static_cast<unsigned long long>(wanted),
                           device.limits().maxStorageBufferRange);
    if (const Status s = keys.create(device, wanted, keyUsage, "SSPR keys"); s != Status::ok) return s;
    return createTiles(device, scaledDown(extent, desc), "SSPR tiles", tiles);
}

Status recordSspr(const ReflectPass& pass, SsprKernels& kernels, SsprScratch& scratch,
                  const OwnedReflection& images) {
    const ScatterKernel& scatter = keyScale(pass.desc) > 1 ? *kernels.coarseScatter : *kernels.scatter;
    if (const Status s = recordScatter(pass, scatter, scratch.keys, scratch.tiles); s != Status::ok) return s;
    if (const Status s = recordTiles(pass, *kernels.tiles, scratch.keys, scratch.tiles); s != Status::ok)
        return s;
    return recordResolve(pass, *kernels.resolve, scratch.keys, scratch.tiles, images);
}

Technique ssprTechnique() {
    Technique technique = techniqueFrom<SsprKernels, SsprScratch, recordSspr>(
        [](const gpu::Device& device, const ReflectionDesc&) {
            return ssprDispatches + unseenTilesDispatches(device);
        });
    technique.tiles = [](const void* scratch) -> const gpu::Buffer& {
        return static_cast<const SsprScratch*>(scratch)->tiles;
    };
    return technique;
}

} // namespace seaglass
