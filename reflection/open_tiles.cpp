#include "reflection/open_tiles.h"

#include "reflection/mirror.h"
#include "spirv/open_tiles.comp.h"
#include "spirv/seen_columns.comp.h"
#include "spirv/seen_tiles.comp.h"

namespace seaglass {

namespace {

constexpr VkDescriptorType bindings[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                         VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                         VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};

gpu::Resource mirrorOf(const ReflectPass& pass) {
    return gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms));
}

/// By the flags that stand before the lists.
Status recordByOwnFlags(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Buffer& tiles) {
    const gpu::Resource resources[] = {mirrorOf(pass), gpu::storageBuffer(tiles.handle()),
                                       gpu::storageBuffer(tiles.handle())};
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = pass.context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    recordTileLists(pass, kernel, set);
    return Status::ok;
}

} // namespace

Status SeenTilesKernel::create(Context& context) {
    return kernel.create(context.device, seen_tiles_comp, std::span(bindings).first<3>(),
                         "seen tiles pipeline");
}

Status SeenColumnsKernel::create(Context& context) {
    return kernel.create(context.device, seen_columns_comp, std::span(bindings).first<3>(),
                         "seen columns pipeline");
}

Status OpenTilesKernel::create(Context& context) {
    return kernel.create(context.device, open_tiles_comp, bindings, "open tiles pipeline");
}

Status recordSeenTiles(const ReflectPass& pass, const SeenTilesKernel& kernel, const gpu::Buffer& tiles) {
    const gpu::PassScope scope(pass.context.device, pass.commands, "ssr_tiles");
    return recordByOwnFlags(pass, kernel.kernel, tiles);
}

Status recordSeenColumns(const ReflectPass& pass, const SeenColumnsKernel& kernel, const gpu::Buffer& tiles) {
    recordBuffersCleared(pass.context.device, pass.commands, {tiles.handle()}, sizeof(TileHeader));
    return recordByOwnFlags(pass, kernel.kernel, tiles);
}

Status recordOpenTiles(const ReflectPass& pass, const OpenTilesKernel& kernel, const gpu::Buffer& sorted,
                       const OwnedReflection& images, const gpu::Buffer& open) {
    Context& context = pass.context;
    const gpu::Resource resources[] = {
        mirrorOf(pass), gpu::storageBuffer(sorted.handle()), gpu::storageBuffer(open.handle()),
        gpu::sampledImage(context.samplers.nearestClamp(), images.info.view())};
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.kernel.layout(), resources, set); s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "hybrid_open_tiles");
    recordBuffersCleared(context.device, pass.commands, {open.handle()}, sizeof(TileHeader));
    recordTileLists(pass, kernel.kernel, set);
    return Status::ok;
}

} // namespace seaglass
