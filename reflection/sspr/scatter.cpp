#include "reflection/sspr/scatter.h"

#include <algorithm>

#include "reflection/core/depth_scan.h"
#include "reflection/core/mirror.h"
#include "reflection/core/reflection_images.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/scatter.comp.h"
#include "spirv/scatter_coarse.comp.h"

namespace seaglass {

namespace {

void recordClear(const gpu::Device& device, VkCommandBuffer commands, const gpu::Buffer& keys,
                 const gpu::Buffer& tiles) {
    const gpu::PassScope scope(device, commands, "sspr_clear");
    gpu::recordBuffersCleared(device, commands, {keys.handle(), tiles.handle()});
}

} // namespace

Status ScatterKernel::create(Context& context) {
    return kernel.create(context.device, scatter_comp, "scatter pipeline");
}

Status CoarseScatterKernel::create(Context& context) {
    return scatter.kernel.create(context.device, scatter_coarse_comp, "scatter pipeline");
}

Status recordScatter(const ReflectPass& pass, const ScatterKernel& scatter, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles) {
    const gpu::Device& device = pass.context.device;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = allocateDepthScan(pass, scatter.kernel,
                                           {keysBinding, gpu::storageBuffer(keys.handle())}, tiles, set);
        s != Status::ok)
        return s;
    recordClear(device, pass.commands, keys, tiles);

    const gpu::PassScope scope(device, pass.commands, "sspr_scatter");
    const VkExtent2D grid = scaledDown(pass.extent(), std::max(keyScale(pass.desc), 2u));
    const uint32_t tileRows = (scaledDown(pass.extent(), pass.desc).height + tileEdge - 1) / tileEdge;
    scatter.kernel.dispatchAlong(pass.commands, set, grid.width, tileRows);
    recordScanned(pass);
    return Status::ok;
}

} // namespace seaglass
