#include "reflection/march/march.h"

#include <cstddef>
#include <vector>

#include "reflection/core/mirror.h"
#include "reflection/sspr/tiles.h"
#include "shaders/shared/march_block.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/march_cells.comp.h"
#include "spirv/march_cells_open.comp.h"
#include "spirv/march_strides.comp.h"
#include "spirv/march_strides_open.comp.h"

namespace seaglass {

namespace {

MarchBlock blockOf(const ReflectPass& pass) {
    const ViewGeometry& view = pass.geometry;
    const ReflectionDesc& desc = pass.desc;
    MarchBlock out{};
    out.pixelFromRelative = glm::mat4(scenePixelFromRelative(view));
    out.forwardRow = glm::vec4(glm::dvec4(view.forward, 0) * relativeFromScenePixel(view));
    out.thickness = desc.marchThickness;
    out.longest = desc.marchDistance;
    out.jitter = desc.marchJitter;
    out.steps = static_cast<int32_t>(desc.marchSteps);
    out.hasNormals = pass.view.surfaceNormals ? 1 : 0;
    return out;
}

std::span<const uint32_t> spirvOf(bool cells, bool open) {
    if (cells) return open ? std::span<const uint32_t>(march_cells_open_comp) : march_cells_comp;
    return open ? std::span<const uint32_t>(march_strides_open_comp) : march_strides_comp;
}

template<bool cells, bool open>
Status shareVariant(Context& context, std::shared_ptr<MarchKernel>& out) {
    std::shared_ptr<SharedMarch<cells, open>> shared;
    if (const Status s = context.share(shared); s != Status::ok) return s;
    out = std::shared_ptr<MarchKernel>(shared, &shared->march);
    return Status::ok;
}

Status allocateSet(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::Buffer& tiles,
                   const gpu::Buffer* cells, const OwnedReflection& images, VkDescriptorSet& out) {
    gpu::Frame& frame = pass.context.frame();
    const MarchBlock block = blockOf(pass);
    gpu::Slice settings;
    if (const Status s = frame.upload(block, settings); s != Status::ok) return s;

    const VkSampler nearest = pass.context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    // The colour stands in for normals that nobody reads.
    const Image& normals = pass.view.surfaceNormals ? *pass.view.surfaceNormals : color;
    std::vector<gpu::Bound> resources = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {sceneDepthBinding, gpu::sampledImage(nearest, depth.view, depth.layout)},
        {settingsBinding, gpu::uniformBuffer(settings)},
        {sceneColorBinding, gpu::sampledImage(nearest, color.view, color.layout)},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
        {surfaceNormalsBinding, gpu::sampledImage(nearest, normals.view, normals.layout)},
    };
    if (cells) resources.push_back({cellsBinding, gpu::storageBuffer(cells->handle())});
    return frame.allocateSet(kernel.layout(), resources, out);
}

} // namespace

Status MarchKernel::create(Context& context, bool cells, bool open) {
    takesNormals = !open;
    return kernel.create(context, spirvOf(cells, open), "march pipeline");
}

Status shareMarch(Context& context, bool cells, bool open, std::shared_ptr<MarchKernel>& out) {
    if (cells) return open ? shareVariant<true, true>(context, out) : shareVariant<true, false>(context, out);
    return open ? shareVariant<false, true>(context, out) : shareVariant<false, false>(context, out);
}

Status recordMarch(const ReflectPass& pass, MarchKernel& march, const gpu::Buffer& tiles,
                   const gpu::Buffer* cells, const OwnedReflection& images) {
    const gpu::Kernel* kernel = nullptr;
    if (const Status s = march.kernel.of(pass.context, pass.view.sceneColor, kernel); s != Status::ok)
        return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = allocateSet(pass, *kernel, tiles, cells, images, set); s != Status::ok) return s;
    const gpu::Device& device = pass.context.device;
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(images.color.handle(), gpu::storageWritten, gpu::storageWritten, 0, 1),
        gpu::imageBarrier(images.info.handle(), gpu::sampledByShaders, gpu::storageChanged)};
    gpu::recordBarriers(device, pass.commands, before, 2);
    kernel->dispatchIndirect(pass.commands, set, tiles.handle(), offsetof(TileHeader, resolveGroups));
    images.recordInfoSampled(device, pass.commands);
    return Status::ok;
}

} // namespace seaglass
