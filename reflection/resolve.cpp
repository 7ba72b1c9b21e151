#include "reflection/resolve.h"

#include "reflection/mirror.h"
#include "spirv/resolve.comp.h"

namespace seaglass {

namespace {

constexpr uint32_t groupEdge = 8;

} // namespace

Status ResolveKernel::create(Context& context) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
        VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,  VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    return kernel.create(context.device, resolve_comp, bindings, "resolve pipeline");
}

Status recordResolve(Context& context, const ResolveKernel& resolve, VkCommandBuffer commands,
                     const gpu::Slice& uniforms, const ViewDesc& view, const gpu::Buffer& keys,
                     const gpu::OwnedImage& color, const gpu::OwnedImage& info) {
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(uniforms.buffer, uniforms.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(nearest, view.sceneDepth.view, view.sceneDepth.layout),
        gpu::storageBuffer(keys.handle()),
        gpu::sampledImage(nearest, view.sceneColor.view, view.sceneColor.layout),
        gpu::storageImage(color.firstMipView()),
        gpu::storageImage(info.view()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(resolve.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;

    const gpu::PassScope pass(device, commands, "sspr_resolve");
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(color.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1),
        gpu::imageBarrier(info.handle(), gpu::discardedAfterSampling, gpu::storageWritten)};
    gpu::recordBarriers(device, commands, before, 2);
    const VkExtent2D extent = color.desc().extent;
    resolve.kernel.dispatch(commands, set, (extent.width + groupEdge - 1) / groupEdge,
                            (extent.height + groupEdge - 1) / groupEdge);
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(info.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

} // namespace seaglass
