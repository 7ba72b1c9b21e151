#include "reflection/sspr/resolve.h"

#include <cstddef>

#include "gpu/pipeline/constants.h"
#include "reflection/core/mirror.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/miss.comp.h"
#include "spirv/resolve.comp.h"
#include "spirv/resolve_overhangs.comp.h"

namespace seaglass {

namespace {

struct MissConstants {
#define CONSTANTS "shaders/shared/miss_constants.h"
#include "gpu/pipeline/constants.inl"
};

Status createResolve(Context& context, std::span<const uint32_t> shader, ResolveKernel& out) {
    if (const Status s = out.kernel.create(context, shader, "resolve pipeline"); s != Status::ok) return s;
    if (const Status s = shareUnseenTiles(context, out.unseen); s != Status::ok) return s;
    MissConstants miss;
    miss.colorIsCleared = !out.unseen;
    return out.miss.create(context.device, miss_comp, "miss pipeline", miss.constants());
}

} // namespace

Status ResolveKernel::create(Context& context) {
    return createResolve(context, resolve_comp, *this);
}

Status OverhangsResolveKernel::create(Context& context) {
    return createResolve(context, resolve_overhangs_comp, resolve);
}

Status recordResolve(const ReflectPass& pass, ResolveKernel& resolve, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles, const OwnedReflection& images) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
        {sceneDepthBinding, gpu::sampledImage(nearest, depth.view, depth.layout)},
        {keysBinding, gpu::storageBuffer(keys.handle())},
        {sceneColorBinding, gpu::sampledImage(nearest, color.view, color.layout)},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
    };
    const gpu::Kernel* kernel = nullptr;
    if (const Status s = resolve.kernel.of(context, color, kernel); s != Status::ok) return s;
    VkDescriptorSet resolveSet = VK_NULL_HANDLE;
    VkDescriptorSet missSet = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel->layout(), resources, resolveSet);
        s != Status::ok)
        return s;
    if (const Status s = context.frame().allocateSet(resolve.miss.layout(), resources, missSet);
        s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    if (const Status s = recordUnseenTiles(pass, resolve.unseen.get(), tiles, images); s != Status::ok)
        return s;
    const gpu::PassScope scope(device, commands, "sspr_resolve");
    kernel->dispatchIndirect(commands, resolveSet, tiles.handle(), offsetof(TileHeader, resolveGroups));
    resolve.miss.dispatchIndirect(commands, missSet, tiles.handle(), offsetof(TileHeader, columnGroups));
    images.recordInfoSampled(device, commands);
    return Status::ok;
}

} // namespace seaglass
