#include "reflection/march/open_tiles.h"

#include "reflection/core/mirror.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/open_tiles.comp.h"
#include "spirv/seen_columns.comp.h"
#include "spirv/seen_tiles.comp.h"

namespace seaglass {

namespace {

/// By the flags that stand before the lists.
Status recordByOwnFlags(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Buffer& tiles) {
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {sortedTilesBinding, gpu::storageBuffer(tiles.handle())},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = pass.context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    recordTileLists(pass, kernel, set);
    return Status::ok;
}

} // namespace

Status SeenTilesKernel::create(Context& context) {
    return kernel.create(context.device, seen_tiles_comp, "seen tiles pipeline");
}

Status SeenColumnsKernel::create(Context& context) {
    return kernel.create(context.device, seen_columns_comp, "seen columns pipeline");
}

Status OpenTilesKernel::create(Context& context) {
    return kernel.create(context.device, open_tiles_comp, "open tiles pipeline");
}

Status recordSeenTiles(const ReflectPass& pass, const SeenTilesKernel& kernel, const gpu::Buffer& tiles) {
    const gpu::PassScope scope(pass.context.device, pass.commands, "ssr_tiles");
    return recordByOwnFlags(pass, kernel.kernel, tiles);
}

Status recordSeenColumns(const ReflectPass& pass, const SeenColumnsKernel& kernel, const gpu::Buffer& tiles) {
    gpu::recordBuffersCleared(pass.context.device, pass.commands, {tiles.handle()}, sizeof(TileHeader));
    return recordByOwnFlags(pass, kernel.kernel, tiles);
}

Status recordOpenTiles(const ReflectPass& pass, const OpenTilesKernel& kernel, const gpu::Buffer& sorted,
                       const OwnedReflection& images, const gpu::Buffer& open) {
    Context& context = pass.context;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {sortedTilesBinding, gpu::storageBuffer(sorted.handle())},
        {tilesBinding, gpu::storageBuffer(open.handle())},
        {reflectionInfoBinding, gpu::sampledImage(context.samplers.nearestClamp(), images.info.view())},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.kernel.layout(), resources, set); s != Status::ok)
        return s;
    gpu::recordBuffersCleared(context.device, pass.commands, {open.handle()}, sizeof(TileHeader));
    recordTileLists(pass, kernel.kernel, set);
    return Status::ok;
}

} // namespace seaglass
