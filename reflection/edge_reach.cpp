#include "reflection/edge_reach.h"

#include <cstddef>

#include "reflection/mirror.h"
#include "reflection/tiles.h"
#include "spirv/edge_reach.comp.h"

namespace seaglass {

namespace {

/// The std140 block of shaders/edge_reach.comp.
struct EdgeReachUniforms {
    float reach = 0;
    float padding[3] = {};
};

} // namespace

Status EdgeReachKernel::create(Context& context) {
    if (const Status s = columns.create(context); s != Status::ok) return s;
    return kernel.create(context, edge_reach_comp, "edge reach pipeline");
}

Status recordEdgeReach(const ReflectPass& pass, EdgeReachKernel& reach, const gpu::Buffer& tiles,
                       const OwnedReflection& images) {
    Context& context = pass.context;
    const EdgeReachUniforms uniforms{pass.desc.edgeReach * static_cast<float>(pass.extent().height)};
    gpu::Slice slice;
    if (const Status s = context.frame().upload(uniforms, slice); s != Status::ok) return s;
    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    const gpu::Bound resources[] = {
        {0, gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms))},
        {1, gpu::uniformBuffer(slice.buffer, slice.offset, sizeof uniforms)},
        {2, gpu::sampledImage(nearest, depth.view, depth.layout)},
        {3, gpu::sampledImage(nearest, color.view, color.layout)},
        {4, gpu::storageImage(images.color.firstMipView())},
        {5, gpu::storageImage(images.info.view())},
        {6, gpu::storageBuffer(tiles.handle())},
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
