#include "reflection/after/edge_reach.h"

#include <cstddef>

#include "reflection/core/mirror.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/edge_reach_block.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/edge_reach.comp.h"

namespace seaglass {

Status EdgeReachKernel::create(Context& context) {
    if (const Status s = columns.create(context); s != Status::ok) return s;
    return kernel.create(context, edge_reach_comp, "edge reach pipeline");
}

Status recordEdgeReach(const ReflectPass& pass, EdgeReachKernel& reach, const gpu::Buffer& tiles,
                       const OwnedReflection& images) {
    Context& context = pass.context;
    const EdgeReachBlock block{pass.desc.edgeReach * static_cast<float>(pass.extent().height), 0, 0, 0};
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {settingsBinding, gpu::uniformBuffer(slice)},
        {sceneDepthBinding, gpu::sampledImage(nearest, depth.view, depth.layout)},
        {sceneColorBinding, gpu::sampledImage(nearest, color.view, color.layout)},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
    };
    const gpu::Kernel* kernel = nullptr;
    if (const Status s = reach.kernel.of(context, color, kernel); s != Status::ok) return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel->layout(), resources, set); s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_edge_reach");
    if (const Status s = recordSeenColumns(pass, reach.columns, tiles); s != Status::ok) return s;
    images.recordToBeChanged(context.device, pass.commands);
    kernel->dispatchIndirect(pass.commands, set, tiles.handle(), offsetof(TileHeader, columnGroups));
    images.recordInfoSampled(context.device, pass.commands);
    return Status::ok;
}

} // namespace seaglass
