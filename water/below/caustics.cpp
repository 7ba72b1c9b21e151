#include "water/below/caustics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "gpu/pipeline/constants.h"
#include "shaders/shared/body_block.h"
#include "shaders/shared/water_bindings.h"
#include "spirv/caustics_blur.comp.h"
#include "spirv/caustics_cast.comp.h"
#include "spirv/caustics_gather.comp.h"
#include "water/below/bed_part.h"
#include "water/sea/sea.h"
#include "water/waves/wave_octaves.h"

namespace seaglass {

namespace {

constexpr const char* what = "caustics pipeline";

struct CausticConstants {
#define CONSTANTS "shaders/shared/below/caustics_constants.h"
#include "gpu/pipeline/constants.inl"
};

constexpr VkFormat lightFormat = VK_FORMAT_R16G16_SFLOAT;
constexpr uint32_t mostMips = 6;          // blurs as wide as 64 texels
constexpr uint32_t reach = 1 << mostMips; // of taps beyond a view, in texels: two of the last mip

VkExtent2D over(const glm::ivec2& pixels, int step) {
    return {static_cast<uint32_t>((pixels.x + step - 1) / step),
            static_cast<uint32_t>((pixels.y + step - 1) / step)};
}

/// How kernels' light has come to the images.
const gpu::Use& lightLeft(const gpu::Device& device) {
    return device.isCpu() ? gpu::copyWritten : gpu::storageWritten;
}

gpu::ImageDesc gatheredDesc(const gpu::Device& device, VkExtent2D texels) {
    gpu::ImageDesc desc;
    desc.format = lightFormat;
    desc.extent = texels;
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | gpu::MipChain::usage(device) |
                 (device.isCpu() ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : VK_IMAGE_USAGE_STORAGE_BIT);
    const auto mips = static_cast<uint32_t>(std::bit_width(std::max(texels.width, texels.height)));
    desc.mipLevels = std::min(mips, mostMips);
    desc.arrayView = true; // as gpu::MipChain takes it
    return desc;
}

/// Of a picture that holds so many: kernels halve without rest.
VkExtent2D pictureExtent(const gpu::Device& device, VkExtent2D texels) {
    if (device.isCpu()) return texels;
    constexpr uint32_t last = 1 << (mostMips - 1);
    return {(texels.width + last - 1) / last * last, (texels.height + last - 1) / last * last};
}

constexpr VkBufferUsageFlags sumUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

VkDeviceSize sumBytes(VkExtent2D texels) {
    return VkDeviceSize{texels.width + reach} * (texels.height + reach) * sizeof(uint32_t);
}

/// What a view covers of a picture that may be larger, and beside it what looks from there reach.
VkExtent2D lookedAt(const CausticInputs& in, const gpu::OwnedImage& picture) {
    const VkExtent2D view = over(in.region, in.grid.step), all = picture.desc().extent;
    return {std::min(view.width + reach, all.width), std::min(view.height + reach, all.height)};
}

/// Mip 0, which a kernel stores to but on CPU devices.
void recordToBeStored(const gpu::Device& device, VkCommandBuffer commands, const gpu::OwnedImage& to) {
    if (device.isCpu()) return;
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(to.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1);
    gpu::recordBarriers(device, commands, &before, 1);
}

/// What a kernel has left in the buffer, to mip 0; on CPU devices, where storing to images is slow.
void recordCopied(const gpu::Device& device, VkCommandBuffer commands, const CausticInputs& in,
                  const gpu::Buffer& from, const gpu::OwnedImage& to, VkExtent2D texels) {
    if (!device.isCpu()) return;
    gpu::recordBarrier(device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT});
    const VkImageMemoryBarrier2 before =
        gpu::imageBarrier(to.handle(), gpu::discardedAfterSampling, gpu::copyWritten, 0, 1);
    gpu::recordBarriers(device, commands, &before, 1);
    VkBufferImageCopy region{};
    region.bufferRowLength = static_cast<uint32_t>(in.grid.rowLength);
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {texels.width, texels.height, 1};
    device.vk().CmdCopyBufferToImage(commands, from.handle(), to.handle(),
                                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

/// First and last row of pixels, to `margin` beside the view, whose lines of sight point down somewhere: how
/// much they rise is linear in the pixels (shaders/reflection/core/sight_line.glsl). All for an eye that sees
/// the water from within.
glm::dvec2 rowsBelowHorizon(const ViewGeometry& view, double height, int margin) {
    const double low = -margin, high = view.regionSize.y + margin;
    if (view.parallel || height <= 0) return {low, high};
    const glm::dmat4 fromPixel = relativeFromScenePixel(view);
    const glm::dvec4 perDepth = fromPixel[2];
    const auto rise = [&](double x, double y) {
        const glm::dvec4 p = fromPixel * glm::dvec4(x, y, 0.5, 1);
        return (view.reversedDepth ? 1 : -1) * (p.y * perDepth.w - perDepth.y * p.w);
    };
    double first = high, last = low;
    for (const double x : {low, double(view.regionSize.x + margin)}) {
        const double top = rise(x, low), bottom = rise(x, high);
        const double level = low + (high - low) * (top == bottom ? 0 : top / (top - bottom));
        if (top < 0 || bottom < 0) {
            first = std::min(first, top < 0 ? low : level);
            last = std::max(last, bottom < 0 ? high : level);
        }
    }
    return {first, last};
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

SunInWater fillSunInWater(BodyBlock& block) {
    const SunInWater sun = sunInWater(glm::dvec3(glm::vec4(block.toSun)));
    block.sunInWater = glm::vec4(glm::vec3(sun.from), 0);
    return sun;
}

CausticGrid causticGrid(const ShadingDesc& shading, const ViewGeometry& view, double height) {
    const glm::ivec2 region = view.regionSize;
    const int step = static_cast<int>(shading.causticStep);
    // Light that comes from farther out is taken to be even: what is gathered fades by the border.
    const int margin = std::min(region.x, region.y) / 16;
    CausticGrid grid;
    grid.step = step;
    grid.margin = margin / step * step;
    grid.rowLength = (region.x + step - 1) / step + static_cast<int>(reach);
    const glm::dvec2 rows = rowsBelowHorizon(view, height, grid.margin) / double(step);
    const int viewRows = (region.y + step - 1) / step, beside = grid.margin / step;
    grid.firstRow = std::clamp(static_cast<int>(std::floor(rows.x)) - 1, -beside, viewRows - 1);
    const int least = std::max(grid.firstRow, 0) + 1;
    grid.endRow = std::clamp(static_cast<int>(std::ceil(rows.y)) + 1, least, viewRows + beside);
    return grid;
}

Status CastKernel::create(Context& context) {
    return kernel.create(context.device, caustics_cast_comp, what, CausticConstants{}.constants());
}

Status CastOnShoreKernel::create(Context& context) {
    const CausticConstants onShore = {.hasShore = true};
    return kernel.create(context.device, caustics_cast_comp, what, onShore.constants());
}

Status GatherKernel::create(Context& context) {
    const CausticConstants left = {.copies = context.device.isCpu()};
    return kernel.create(context.device, caustics_gather_comp, what, left.constants());
}

Status CausticBlurKernel::create(Context& context) {
    return kernel.create(context.device, caustics_blur_comp, what, CausticConstants{}.constants());
}

Status ShadowedCausticBlurKernel::create(Context& context) {
    const CausticConstants shadowed = {.hasSunShadow = true};
    return kernel.create(context.device, caustics_blur_comp, what, shadowed.constants());
}

Status Caustics::create(Context& context, const Sea& sea, const CausticsDesc& desc) {
    strength_ = desc.strength;
    lostSlopes_ = lostSlopesOf(sea);
    if (const Status s = context.share(gather_); s != Status::ok) return s;
    if (const Status s = context.share(blur_); s != Status::ok) return s;
    if (const Status s = mips_.create(context, lightFormat); s != Status::ok) return s;
    return sea.shore ? context.share(castOnShore_) : context.share(cast_);
}

Status Caustics::fit(Context& context, VkExtent2D texels, Picture& picture) const {
    const VkExtent2D held = picture.gathered.handle() ? picture.gathered.desc().extent : VkExtent2D{0, 0};
    const VkExtent2D wanted = pictureExtent(
        context.device, {std::max(texels.width, held.width), std::max(texels.height, held.height)});
    if (picture.gathered.isOf(wanted)) return Status::ok;
    Picture fresh;
    if (const Status s = fresh.sums.create(context.device, sumBytes(wanted), sumUsage, "caustics' sums");
        s != Status::ok)
        return s;
    if (const Status s =
            fresh.gathered.create(context.device, gatheredDesc(context.device, wanted), "caustics' light");
        s != Status::ok)
        return s;
    context.frame().replace(picture, std::move(fresh));
    return Status::ok;
}

Status Caustics::recordCast(Context& context, VkCommandBuffer commands, const CausticInputs& in,
                            const Picture& picture) const {
    const gpu::Device& device = context.device;
    const std::vector<gpu::Bound> resources =
        in.with({{causticSumsBinding, gpu::storageBuffer(picture.sums.handle())}});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(castKernel().layout(), resources, set); s != Status::ok)
        return s;
    // What was blurred there before may still be drawn by.
    gpu::recordBarrier(device, commands, {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_NONE},
                       {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT});
    gpu::recordBuffersCleared(device, commands, {picture.sums.handle()});
    const uint32_t across = over(in.region + 2 * in.grid.margin, in.grid.step).width;
    castKernel().dispatchOver(commands, set,
                              VkExtent2D{across, static_cast<uint32_t>(in.grid.endRow - in.grid.firstRow)});
    gpu::recordBarrier(device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT});
    return Status::ok;
}

Status Caustics::recordGather(Context& context, VkCommandBuffer commands, const CausticInputs& in,
                              const Picture& picture) const {
    const std::vector<gpu::Bound> resources =
        in.with({{causticSumsBinding, gpu::storageBuffer(picture.sums.handle())},
                 {causticLightBinding, gpu::storageImage(picture.gathered)}});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(gather_->kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    const VkExtent2D texels = lookedAt(in, picture.gathered);
    recordToBeStored(context.device, commands, picture.gathered);
    gather_->kernel.dispatchOver(commands, set, texels);
    recordCopied(context.device, commands, in, picture.sums, picture.gathered, texels);
    const gpu::OwnedImage* const images[] = {&picture.gathered};
    return mips_.record(context, commands, images, lightLeft(context.device));
}

Status Caustics::recordBlur(Context& context, VkCommandBuffer commands, const CausticInputs& in,
                            const Picture& picture) {
    if (in.inShadow && !blurInShadow_)
        if (const Status s = context.share(blurInShadow_); s != Status::ok) return s;
    const gpu::Kernel& kernel = in.inShadow ? blurInShadow_->kernel : blur_->kernel;
    const std::vector<gpu::Bound> resources = in.with(
        {{causticLightBinding, gpu::sampledImage(context.samplers.trilinearClamp(), picture.gathered.view())},
         {causticSumsBinding, gpu::storageBuffer(picture.sums.handle())}});
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel.layout(), resources, set); s != Status::ok)
        return s;
    const VkExtent2D view = over(in.region, in.grid.step);
    const uint32_t firstRow = static_cast<uint32_t>(std::max(in.grid.firstRow, 0));
    const uint32_t endRow = std::min(static_cast<uint32_t>(in.grid.endRow), view.height);
    const VkExtent2D texels = {view.width, endRow - firstRow};
    // What was gathered from the buffer has been read, or copied.
    gpu::recordBarrier(
        context.device, commands,
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_NONE},
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE});
    kernel.dispatchOver(commands, set, texels);
    gpu::recordBarrier(context.device, commands,
                       {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                       {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
    return Status::ok;
}

Status Caustics::record(Context& context, VkCommandBuffer commands, const CausticInputs& in) {
    Picture& picture = views_[in.viewIndex];
    picture.frame = 0; // until all of it is recorded
    if (const Status s = fit(context, over(in.region, in.grid.step), picture); s != Status::ok) return s;

    const gpu::PassScope pass(context.device, commands, "caustics_cast");
    if (const Status s = recordCast(context, commands, in, picture); s != Status::ok) return s;
    if (const Status s = recordGather(context, commands, in, picture); s != Status::ok) return s;
    if (const Status s = recordBlur(context, commands, in, picture); s != Status::ok) return s;
    picture.frame = context.frameNumber;
    picture.region = in.region;
    return Status::ok;
}

VkBuffer Caustics::lightOf(const Context& context, uint32_t viewIndex, const glm::ivec2& region) const {
    const Picture& picture = views_[viewIndex];
    const bool cast = picture.frame == context.frameNumber && picture.region == region;
    return cast ? picture.sums.handle() : VK_NULL_HANDLE;
}

VkDeviceSize Caustics::bytes(const gpu::Device& device, const BodyDesc& desc, VkExtent2D view) {
    VkExtent2D largest = view;
    if (desc.bed) {
        const VkExtent2D bed = BedPart::pictureExtent(desc, view);
        largest = {std::max(view.width, bed.width), std::max(view.height, bed.height)};
    }
    const glm::ivec2 region(static_cast<int>(largest.width), static_cast<int>(largest.height));
    const VkExtent2D texels = pictureExtent(device, over(region, static_cast<int>(desc.shading.causticStep)));
    return gpu::heldBytes(device, sumBytes(texels), sumUsage) +
           gpu::heldBytes(device, gatheredDesc(device, texels));
}

} // namespace seaglass
