#include "reflection/single_sample.h"

#include "reflection/mirror.h"
#include "spirv/single_sample_color.comp.h"
#include "spirv/single_sample_depth.comp.h"

namespace seaglass {

namespace {

Status createKernel(Context& context, std::span<const uint32_t> spirv, gpu::Kernel& out) {
    constexpr VkDescriptorType bindings[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                             VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                             VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    return out.create(context.device, spirv, bindings, "single sample pipeline");
}

bool hasManySamples(const Image& image) {
    return image.samples != VK_SAMPLE_COUNT_1_BIT;
}

bool isAsLarge(const gpu::OwnedImage& owned, const Image& image) {
    const VkExtent2D extent = owned.desc().extent;
    return owned.handle() && extent.width == image.extent.width && extent.height == image.extent.height;
}

Status createImage(const gpu::Device& device, const Image& like, VkFormat format, gpu::OwnedImage& out) {
    gpu::ImageDesc desc;
    desc.format = format;
    desc.extent = like.extent;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    return out.create(device, desc, "single-sampled scene");
}

Status recordImage(const ReflectPass& pass, const gpu::Kernel& kernel, const gpu::OwnedImage& to,
                   Image& image) {
    Context& context = pass.context;
    const gpu::Device& device = context.device;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(context.samplers.nearestClamp(), image.view, image.layout),
        gpu::storageImage(to.view()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.layout().set(), resources, set); s != Status::ok)
        return s;
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(to.handle(), gpu::discardedAfterSampling, gpu::storageWritten);
    gpu::recordBarriers(device, pass.commands, &before, 1);
    kernel.dispatchOver(pass.commands, set, pass.extent());
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(to.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, pass.commands, &after, 1);
    image.view = to.view();
    image.layout = gpu::sampledByShaders.layout;
    image.samples = VK_SAMPLE_COUNT_1_BIT;
    return Status::ok;
}

} // namespace

Status DepthSampleKernel::create(Context& context) {
    return createKernel(context, single_sample_depth_comp, kernel);
}

Status ColorSampleKernel::create(Context& context) {
    return createKernel(context, single_sample_color_comp, kernel);
}

Status SingleSampleKernels::create(Context& context, const ViewDesc& view) {
    if (!depth)
        if (const Status s = context.share(depth); s != Status::ok) return s;
    if (color || !hasManySamples(view.sceneColor)) return Status::ok;
    return context.share(color);
}

bool SingleSampledScene::fits(const ViewDesc& view) const {
    return isAsLarge(depth, view.sceneDepth) &&
           (!hasManySamples(view.sceneColor) || isAsLarge(color, view.sceneColor));
}

Status SingleSampledScene::create(const gpu::Device& device, const ViewDesc& view) {
    if (const Status s = createImage(device, view.sceneDepth, VK_FORMAT_R32_SFLOAT, depth); s != Status::ok)
        return s;
    if (!hasManySamples(view.sceneColor)) return Status::ok;
    return createImage(device, view.sceneColor, VK_FORMAT_R16G16B16A16_SFLOAT, color);
}

Status recordSingleSample(const ReflectPass& pass, const SingleSampleKernels& kernels,
                          const SingleSampledScene& scene, ViewDesc& view) {
    const gpu::PassScope scope(pass.context.device, pass.commands, "scene_single_sample");
    if (const Status s = recordImage(pass, kernels.depth->kernel, scene.depth, view.sceneDepth);
        s != Status::ok)
        return s;
    if (!hasManySamples(view.sceneColor)) return Status::ok;
    return recordImage(pass, kernels.color->kernel, scene.color, view.sceneColor);
}

} // namespace seaglass
