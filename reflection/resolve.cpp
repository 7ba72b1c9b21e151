#include "reflection/resolve.h"

#include <cstddef>

#include "reflection/mirror.h"
#include "reflection/tiles.h"
#include "spirv/miss.comp.h"
#include "spirv/resolve.comp.h"

namespace seaglass {

namespace {

constexpr VkDescriptorType uniforms = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType buffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType sampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

constexpr gpu::Use cleared = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_GENERAL};

/// Both to nothing known.
void recordClear(const gpu::Device& device, VkCommandBuffer commands, const OwnedReflection& images) {
    const gpu::PassScope scope(device, commands, "reflection_clear");
    const VkImage handles[] = {images.color.handle(), images.info.handle()};
    VkImageMemoryBarrier2 barriers[2];
    for (int i = 0; i < 2; ++i)
        barriers[i] = gpu::imageBarrier(handles[i], gpu::discardedAfterSampling, cleared, 0, 1);
    gpu::recordBarriers(device, commands, barriers, 2);
    const VkClearColorValue zero{};
    const VkImageSubresourceRange mip0 = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    for (const VkImage image : handles)
        device.vk().CmdClearColorImage(commands, image, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &mip0);
    for (int i = 0; i < 2; ++i)
        barriers[i] = gpu::imageBarrier(handles[i], cleared, gpu::storageWritten, 0, 1);
    gpu::recordBarriers(device, commands, barriers, 2);
}

} // namespace

Status ResolveKernel::create(Context& context) {
    constexpr VkDescriptorType resolveBindings[] = {uniforms, buffer,  sampled, buffer,
                                                    sampled,  storage, storage};
    if (const Status s = kernel.create(context.device, resolve_comp, resolveBindings, "resolve pipeline");
        s != Status::ok)
        return s;
    constexpr VkDescriptorType missBindings[] = {uniforms, buffer, sampled, storage};
    return miss.create(context.device, miss_comp, missBindings, "miss pipeline");
}

Status recordResolve(const ReflectPass& pass, const ResolveKernel& resolve, const gpu::Buffer& keys,
                     const gpu::Buffer& tiles, const OwnedReflection& images) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const VkSampler nearest = context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    const gpu::Resource mirror =
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms));
    const gpu::Resource sceneDepth = gpu::sampledImage(nearest, depth.view, depth.layout);
    const gpu::Resource resolveResources[] = {
        mirror,
        gpu::storageBuffer(tiles.handle()),
        sceneDepth,
        gpu::storageBuffer(keys.handle()),
        gpu::sampledImage(nearest, color.view, color.layout),
        gpu::storageImage(images.color.firstMipView()),
        gpu::storageImage(images.info.view()),
    };
    const gpu::Resource missResources[] = {mirror, gpu::storageBuffer(tiles.handle()), sceneDepth,
                                           gpu::storageImage(images.info.view())};
    VkDescriptorSet resolveSet = VK_NULL_HANDLE;
    VkDescriptorSet missSet = VK_NULL_HANDLE;
    if (const Status s =
            context.frame().allocateSet(resolve.kernel.layout().set(), resolveResources, resolveSet);
        s != Status::ok)
        return s;
    if (const Status s = context.frame().allocateSet(resolve.miss.layout().set(), missResources, missSet);
        s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    recordClear(device, commands, images);
    const gpu::PassScope scope(device, commands, "sspr_resolve");
    resolve.kernel.dispatchIndirect(commands, resolveSet, tiles.handle(),
                                    offsetof(TileHeader, resolveGroups));
    resolve.miss.dispatchIndirect(commands, missSet, tiles.handle(), offsetof(TileHeader, emptyGroups));
    images.recordInfoSampled(device, commands);
    return Status::ok;
}

} // namespace seaglass
