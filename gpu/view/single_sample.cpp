#include "gpu/view/single_sample.h"

#include <utility>
#include <vector>

#include "shaders/shared/single_sample_block.h"
#include "spirv/single_sample_color.comp.h"
#include "spirv/single_sample_depth.comp.h"
#include "spirv/single_sample_resolved.comp.h"

namespace seaglass {

namespace {

bool hasManySamples(const Image& image) {
    return image.samples != VK_SAMPLE_COUNT_1_BIT;
}

gpu::ImageDesc imageDesc(VkExtent2D extent, VkFormat format) {
    gpu::ImageDesc desc;
    desc.format = format;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    return desc;
}

Status prepare(Context& context, SingleSamples& samples, const ViewDesc& view) {
    if (const Status s = shareKernels(context, view, samples); s != Status::ok) return s;
    SingleSampledScene& scene = samples.views[view.viewIndex];
    if (scene.fits(view)) return Status::ok;
    SingleSampledScene fresh;
    if (const Status s = fresh.create(context.device, view); s != Status::ok) return s;
    context.frame().replace(scene, std::move(fresh));
    return Status::ok;
}

void replace(Image& image, const gpu::OwnedImage& by) {
    image.view = by.view();
    image.layout = gpu::sampledByShaders.layout;
    image.samples = VK_SAMPLE_COUNT_1_BIT;
}

/// Fills the images of the view and gives it them for its own.
Status recordSingleSample(Context& context, VkCommandBuffer commands, const ViewGeometry& geometry,
                          SingleSamples& samples, ViewDesc& view) {
    if (const Status s = prepare(context, samples, view); s != Status::ok) return s;
    const SingleSampledScene& scene = samples.views[view.viewIndex];
    const gpu::PassScope scope(context.device, commands, "scene_single_sample");
    const auto take = [&](const gpu::Kernel& kernel, const gpu::OwnedImage& to, const Image& image,
                          const Image* resolved = nullptr) {
        return recordFirstSample(context, commands, kernel, geometry, to, image, resolved);
    };
    if (const Status s = take(samples.depth->kernel, scene.depth, view.sceneDepth); s != Status::ok) return s;
    const Status s = hasManySamples(view.sceneColor)
                         ? take(samples.color->kernel, scene.color, view.sceneColor)
                         : take(samples.resolved->kernel, scene.color, view.sceneDepth, &view.sceneColor);
    if (s != Status::ok) return s;
    scene.standIn(view);
    return Status::ok;
}

} // namespace

Status shareKernels(Context& context, const ViewDesc& view, SingleSamples& samples) {
    if (!samples.depth)
        if (const Status s = context.share(samples.depth); s != Status::ok) return s;
    const bool many = hasManySamples(view.sceneColor);
    if (many && !samples.color)
        if (const Status s = context.share(samples.color); s != Status::ok) return s;
    return many || samples.resolved ? Status::ok : context.share(samples.resolved);
}

gpu::ImageDesc firstDepthDesc(VkExtent2D extent) {
    return imageDesc(extent, VK_FORMAT_R32_SFLOAT);
}

gpu::ImageDesc firstColorDesc(VkExtent2D extent) {
    return imageDesc(extent, VK_FORMAT_R16G16B16A16_SFLOAT);
}

Status recordFirstSample(Context& context, VkCommandBuffer commands, const gpu::Kernel& kernel,
                         const ViewGeometry& view, const gpu::OwnedImage& to, const Image& image,
                         const Image* resolved) {
    const gpu::Device& device = context.device;
    SingleSampleBlock block{};
    block.region = glm::ivec4(view.regionOrigin, view.regionSize);
    block.infinityDepth = static_cast<float>(view.infinityDepth);
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const VkSampler nearest = context.samplers.nearestClamp();
    std::vector<gpu::Bound> resources = {
        {singleSampleBinding, gpu::uniformBuffer(slice)},
        {samplesBinding, gpu::sampledImage(nearest, image.view, image.layout)},
        {chosenBinding, gpu::storageImage(to)},
    };
    if (resolved)
        resources.push_back({resolvedBinding, gpu::sampledImage(nearest, resolved->view, resolved->layout)});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(to.handle(), gpu::discardedAfterSampling, gpu::storageWritten);
    gpu::recordBarriers(device, commands, &before, 1);
    kernel.dispatchOver(commands, set, extentOf(view));
    const VkImageMemoryBarrier2 after =
        gpu::imageBarrier(to.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(device, commands, &after, 1);
    return Status::ok;
}

Status DepthSampleKernel::create(Context& context) {
    return kernel.create(context.device, single_sample_depth_comp, "single sample pipeline");
}

Status ColorSampleKernel::create(Context& context) {
    return kernel.create(context.device, single_sample_color_comp, "single sample pipeline");
}

Status ResolvedColorKernel::create(Context& context) {
    return kernel.create(context.device, single_sample_resolved_comp, "single sample pipeline");
}

bool SingleSampledScene::fits(const ViewDesc& view) const {
    return depth.isOf(view.sceneDepth.extent) && color.isOf(view.sceneColor.extent);
}

void SingleSampledScene::standIn(ViewDesc& view) const {
    replace(view.sceneColor, color);
    replace(view.sceneDepth, depth);
}

Status SingleSampledScene::create(const gpu::Device& device, const ViewDesc& view) {
    constexpr const char* what = "single-sampled scene";
    if (const Status s = depth.create(device, firstDepthDesc(view.sceneDepth.extent), what); s != Status::ok)
        return s;
    return color.create(device, firstColorDesc(view.sceneColor.extent), what);
}

VkDeviceSize SingleSampledScene::bytes(const gpu::Device& device, VkExtent2D extent,
                                       VkSampleCountFlagBits depth) {
    if (depth == VK_SAMPLE_COUNT_1_BIT) return 0;
    return gpu::heldBytes(device, firstDepthDesc(extent)) + gpu::heldBytes(device, firstColorDesc(extent));
}

uint32_t SingleSampledScene::dispatches(VkSampleCountFlagBits depth) {
    return depth == VK_SAMPLE_COUNT_1_BIT ? 0 : 2;
}

Status takeSamples(Context& context, VkCommandBuffer commands, const ViewGeometry& view,
                   std::shared_ptr<SingleSamples>& samples, SceneOfCall& scene) {
    if (!isMultisampled(scene.given)) {
        dropSamples(context, samples.get(), scene.given.viewIndex);
        return Status::ok;
    }
    if (const Status s = context.shareWhileUsed(samples); s != Status::ok) return s;
    if (std::exchange(scene.taken, true)) return Status::ok;
    return recordSingleSample(context, commands, view, *samples, scene.read);
}

void dropSamples(Context& context, SingleSamples* samples, uint32_t viewIndex) {
    if (!samples || viewIndex >= maxViews) return;
    SingleSampledScene& held = samples->views[viewIndex];
    if (held.depth.handle()) context.frame().replace(held, {});
}

} // namespace seaglass
