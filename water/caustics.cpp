#include "water/caustics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "gpu/mip_chain.h"
#include "reflection/tiles.h"
#include "spirv/caustics_cast.comp.h"
#include "spirv/caustics_cast_shore.comp.h"
#include "spirv/caustics_gather.comp.h"
#include "water/bed.h"
#include "water/sea.h"
#include "water/surface_uniforms.h"
#include "water/wave_octaves.h"

namespace seaglass {

namespace {

constexpr VkDescriptorType uniforms = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType sampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;

VkExtent2D over(const glm::ivec2& pixels, int step) {
    return {static_cast<uint32_t>((pixels.x + step - 1) / step),
            static_cast<uint32_t>((pixels.y + step - 1) / step)};
}

gpu::ImageDesc lightDesc(VkExtent2D texels) {
    constexpr int mostMips = 6; // blurs as wide as 64 texels
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R16G16B16A16_SFLOAT; // the narrowest that any device stores
    desc.extent = texels;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    desc.mipLevels = static_cast<uint32_t>(
        std::min(static_cast<int>(std::bit_width(std::max(texels.width, texels.height))), mostMips));
    return desc;
}

VkDeviceSize sumBytes(VkExtent2D texels) {
    return VkDeviceSize{texels.width} * texels.height * sizeof(uint32_t);
}

gpu::Resource uniformsOf(const CausticInputs& in) {
    return gpu::uniformBuffer(in.uniforms.buffer, in.uniforms.offset, sizeof(SurfaceUniforms));
}

gpu::Resource depthOf(const Context& context, const CausticInputs& in) {
    const Image& depth = in.view->sceneDepth;
    return gpu::sampledImage(context.samplers.nearestClamp(), depth.view, depth.layout);
}

} // namespace

LostSlopes lostSlopesOf(const Sea& sea) {
    const std::array<double, waveOctaves> variance = varianceByOctave(sea, 1);
    LostSlopes lost{};
    for (size_t i = 0; i < lost.size(); ++i) {
        // A mean over a width lets half of the waves through that are 2.3 times as long.
        const double longest = std::log2(longestOctave / (2.3 * std::ldexp(1.0, static_cast<int>(i) - 7)));
        double sum = unresolvedSlopeVariance(sea);
        for (int octave = 0; octave < waveOctaves; ++octave)
            sum += variance[static_cast<size_t>(octave)] * std::clamp(octave + 1 - longest, 0.0, 1.0);
        lost[i] = static_cast<float>(std::sqrt(sum / 2));
    }
    return lost;
}

SunInWater sunInWater(const glm::dvec3& toSun) {
    // A normal tilted by a small slope s turns the refracted ray by (cos t - cos i / n) s along the tilt, of
    // which the ray makes tan t (1 + tan^2 t) along its own plane and tan t's own share across it.
    constexpr double index = 1.333;
    const double sine = std::sqrt(std::max(1 - toSun.y * toSun.y, 0.0)) / index;
    const double cosine = std::sqrt(1 - sine * sine), turned = cosine - toSun.y / index;
    SunInWater sun;
    sun.from = {toSun.x / index, cosine, toSun.z / index};
    sun.turnedAcross = turned / cosine;
    sun.turnedAlong = turned / (cosine * cosine * cosine);
    return sun;
}

CausticGrid causticGrid(const ShadingDesc& shading, const glm::ivec2& region) {
    const int step = static_cast<int>(shading.causticStep);
    // Light that comes from farther out is taken to be even: what is gathered fades by the border.
    const int margin = std::min(region.x, region.y) / 16;
    return {step, margin / step * step};
}

Status CastKernel::create(Context& context) {
    constexpr std::array bindings{uniforms, sampled, sampled, sampled, sampled, storage};
    return kernel.create(context.device, caustics_cast_comp, bindings, "caustics pipeline");
}

Status CastOnShoreKernel::create(Context& context) {
    constexpr std::array bindings{uniforms, sampled, sampled, sampled, sampled, storage, sampled, storage};
    return kernel.create(context.device, caustics_cast_shore_comp, bindings, "caustics pipeline");
}

Status GatherKernel::create(Context& context) {
    constexpr std::array bindings{uniforms, sampled, storage, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    return kernel.create(context.device, caustics_gather_comp, bindings, "caustics pipeline");
}

Status Caustics::create(Context& context, const Sea& sea, const CausticsDesc& desc) {
    strength_ = desc.strength;
    lostSlopes_ = lostSlopesOf(sea);
    if (const Status s = context.share(gather_); s != Status::ok) return s;
    return sea.shore ? context.share(castOnShore_) : context.share(cast_);
}

Status Caustics::fit(Context& context, VkExtent2D texels, Picture& picture) const {
    const VkExtent2D held = picture.light.handle() ? picture.light.desc().extent : VkExtent2D{0, 0};
    const VkExtent2D wanted = {std::max(texels.width, held.width), std::max(texels.height, held.height)};
    if (picture.light.isOf(wanted)) return Status::ok;
    Picture fresh;
    constexpr VkBufferUsageFlags usage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    if (const Status s = fresh.sums.create(context.device, sumBytes(wanted), usage, "caustics' sums");
        s != Status::ok)
        return s;
    if (const Status s = fresh.light.create(context.device, lightDesc(wanted), "caustics' light");
        s != Status::ok)
        return s;
    context.frame().retire(std::exchange(picture, std::move(fresh)));
    return Status::ok;
}

Status Caustics::recordCast(Context& context, VkCommandBuffer commands, const CausticInputs& in,
                            const Picture& picture) const {
    const gpu::Device& device = context.device;
    const gpu::Samplers& samplers = context.samplers;
    std::vector<gpu::Resource> resources = {uniformsOf(in), depthOf(context, in)};
    for (VkImageView map : in.waveMaps)
        resources.push_back(gpu::sampledImage(samplers.trilinearRepeat(), map));
    resources.push_back(gpu::storageBuffer(picture.sums.handle()));
    if (in.shoreMap) {
        resources.push_back(gpu::sampledImage(samplers.trilinearClamp(), in.shoreMap));
        resources.push_back(in.shoreRows);
    }
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(castKernel().layout().set(), resources, set);
        s != Status::ok)
        return s;
    recordBuffersCleared(device, commands, {picture.sums.handle()});
    castKernel().dispatchOver(commands, set, over(in.region + 2 * in.grid.margin, in.grid.step));
    gpu::recordBarrier(device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
    return Status::ok;
}

Status Caustics::recordGather(Context& context, VkCommandBuffer commands, const CausticInputs& in,
                              const Picture& picture) const {
    const gpu::Resource resources[] = {uniformsOf(in), depthOf(context, in),
                                       gpu::storageBuffer(picture.sums.handle()),
                                       gpu::storageImage(picture.light.firstMipView())};
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(gather_->kernel.layout().set(), resources, set);
        s != Status::ok)
        return s;
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(picture.light.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1);
    gpu::recordBarriers(context.device, commands, &before, 1);
    gather_->kernel.dispatchOver(commands, set, picture.light.desc().extent);
    const gpu::OwnedImage* const images[] = {&picture.light};
    gpu::recordMipChain(context.device, commands, images, gpu::storageWritten);
    return Status::ok;
}

Status Caustics::record(Context& context, VkCommandBuffer commands, const CausticInputs& in) {
    Picture& picture = views_[in.view->viewIndex];
    picture.frame = 0; // until all of it is recorded
    if (const Status s = fit(context, over(in.region, in.grid.step), picture); s != Status::ok) return s;

    const gpu::PassScope pass(context.device, commands, "caustics_cast");
    if (const Status s = recordCast(context, commands, in, picture); s != Status::ok) return s;
    if (const Status s = recordGather(context, commands, in, picture); s != Status::ok) return s;
    picture.frame = context.frameNumber;
    picture.region = in.region;
    return Status::ok;
}

VkImageView Caustics::lightOf(const Context& context, uint32_t viewIndex, const glm::ivec2& region) const {
    const Picture& picture = views_[viewIndex];
    const bool cast = picture.frame == context.frameNumber && picture.region == region;
    return cast ? picture.light.view() : VK_NULL_HANDLE;
}

VkDeviceSize Caustics::bytes(const BodyDesc& desc, VkExtent2D view) {
    VkExtent2D largest = view;
    if (desc.bed) {
        const VkExtent2D bed = Bed::pictureExtent(*desc.bed, desc.shading.bedDownscale, view);
        largest = {std::max(view.width, bed.width), std::max(view.height, bed.height)};
    }
    const glm::ivec2 region(static_cast<int>(largest.width), static_cast<int>(largest.height));
    const VkExtent2D texels = over(region, causticGrid(desc.shading, region).step);
    return sumBytes(texels) + gpu::imageBytes(lightDesc(texels));
}

} // namespace seaglass
