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

Status recordResolve(const ReflectPass& pass, const ResolveKernel& resolve, const gpu::Buffer& keys,
                     const OwnedReflection& images) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& sceneDepth = pass.view.sceneDepth;
    const Image& sceneColor = pass.view.sceneColor;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(nearest, sceneDepth.view, sceneDepth.layout),
        gpu::storageBuffer(keys.handle()),
        gpu::sampledImage(nearest, sceneColor.view, sceneColor.layout),
        gpu::storageImage(images.color.firstMipView()),
        gpu::storageImage(images.info.view()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(resolve.kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    const gpu::PassScope scope(device, commands, "sspr_resolve");
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(images.color.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1),
        gpu::imageBarrier(images.info.handle(), gpu::discardedAfterSampling, gpu::storageWritten)};
    gpu::recordBarriers(device, commands, before, 2);
    const VkExtent2D extent = images.color.desc().extent;
    resolve.kernel.dispatch(commands, set, (extent.width + groupEdge - 1) / groupEdge,
                            (extent.height + groupEdge - 1) / groupEdge);
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(images.info.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

} // namespace seaglass
