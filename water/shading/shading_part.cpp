#include "water/shading/shading_part.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "shaders/shared/water_bindings.h"
#include "water/below/refraction_part.h"
#include "water/below/underwater_part.h"
#include "water/below/view_pass.h"
#include "water/body/body.h"
#include "water/body/body_block.h"
#include "water/body/target.h"
#include "water/interface/fields/water.h"
#include "water/reflection/reflection_part.h"

namespace seaglass {

namespace {

/// CPU devices compile the kernels of a surface's sorted tiles in longer than smaller views gain by them.
constexpr uint64_t sortedOnCpusFrom = 32768;

/// Depth the other way round, of homogeneous coordinates: an involution.
glm::dmat4 turnedDepth() {
    glm::dmat4 turn(1);
    turn[2][2] = -1;
    turn[3][2] = 1;
    return turn;
}

/// What a surface is drawn by to be found: its depth runs from 1 down to 0, which keeps far places apart.
glm::mat4 clipFromRelative(const ViewGeometry& geometry) {
    return glm::mat4(geometry.reversedDepth ? geometry.clipFromRelative
                                            : turnedDepth() * geometry.clipFromRelative);
}

bool isSame(const BodyBlock& a, const BodyBlock& b) {
    static_assert(std::is_trivially_copyable_v<BodyBlock>);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

ViewPassVariant overView(SurfaceOutput output) {
    const bool isLight = output == SurfaceOutput::shaded || output == SurfaceOutput::reflection;
    return {.pass = ViewPass::surface, .placesFigures = !isLight};
}

} // namespace

FieldError ShadingPart::validate(const BodyDesc& desc) {
    return badField(shadingFields, &desc.shading);
}

Status ShadingPart::addCost(const AskedBody& asked, Estimate& sum) {
    const gpu::Device& device = asked.context.device;
    const bool mirrorsApart = asked.desc.shading.pixelsPerShading == 1 && takesSteps(device) && asked.sea &&
                              ReflectionPart::wanted(asked.desc, asked.sea);
    sum.bytesPerView +=
        FoundSurface::bytes(device, asked.extent) + ShadedSurface::bytes(device, asked.extent, mirrorsApart);
    return Status::ok;
}

Status ShadingPart::create(Body& body, const BodyDesc&) {
    Context& context = *body.context;
    bySteps = takesSteps(context.device);
    sortedFromPixels = context.device.isCpu() ? sortedOnCpusFrom : 0;
    if (const Status s = context.share(passes_); s != Status::ok) return s;
    if (const Status s = context.share(tiles_); s != Status::ok) return s;
    if (const Status s = context.share(completing_); s != Status::ok) return s;
    return context.share(kernels_);
}

void ShadingPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const ViewGeometry& geometry = view.geometry;
    block.relativeFromFound = glm::mat4(geometry.reversedDepth ? geometry.relativeFromPixel
                                                               : geometry.relativeFromPixel * turnedDepth());
    const double most = std::max(body.placing.displacement, 1e-3);
    block.found = glm::vec4(most, 1 / most, 0, 0);
}

void ShadingPart::vary(const Body& body, const SurfaceDraw& draw, SurfaceVariant& variant) const {
    variant.bySchlick = body.shading.fresnel == Fresnel::schlick;
    // To complete a pixel takes as much as to shade one of still water that nothing shines through.
    const bool isDear = body.sea || body.find<RefractionPart>();
    if (isDear && draw.output == SurfaceOutput::shaded && draw.sides == SidesSeen::above)
        variant.pixelsPerShading = body.shading.pixelsPerShading;
}

ShadingPart::Sources ShadingPart::sourcesOf(const ViewDesc& view, const LightingDesc& lighting) {
    return {view.sceneColor.view, view.sceneDepth.view, lighting.skyCube,
            lighting.shadow ? lighting.shadow->map.view : VK_NULL_HANDLE};
}

Status ShadingPart::fit(Context& context, VkExtent2D region, SurfaceOutput output, const ShadedBy& kernels,
                        Picture& picture) const {
    const bool mirrorsApart = kernels.pixelsPerShading == 1 && isAny(kernels.shading.mirrors);
    const bool holdsMirrored = picture.shaded.mirrored.handle() || !mirrorsApart;
    if (picture.found.holds(region) && holdsMirrored) return Status::ok;
    VkExtent2D wanted = region;
    if (picture.found.holds({1, 1})) {
        const VkExtent2D held = picture.found.extent();
        wanted = {std::max(region.width, held.width), std::max(region.height, held.height)};
    }
    Picture fresh;
    if (const Status s = fresh.found.create(passes_->of(output), wanted); s != Status::ok) return s;
    if (output != SurfaceOutput::motion)
        if (const Status s = fresh.shaded.create(context.device, wanted, output, mirrorsApart);
            s != Status::ok)
            return s;
    context.frame().retire(std::exchange(picture, std::move(fresh)));
    return Status::ok;
}

Status ShadingPart::getKernels(const SurfaceVariant& variant, bool sorted, ShadedBy& out) const {
    TileSorting sorting = tileSorting(variant);
    if (!sorted) sorting.mirrors = sorting.bed = false;
    out.pixelsPerShading = sorting.pixelsPerShading;
    if (const Status s = tiles_->get(sorting, out.listing); s != Status::ok) return s;
    if (sorting.pixelsPerShading > 1)
        if (const Status s = completing_->get(sorting.pixelsPerShading, out.completing); s != Status::ok)
            return s;
    return getListed(*kernels_, variant, sorting, bySteps, out.shading);
}

Status ShadingPart::record(Body& body, VkCommandBuffer commands, const SeenSurface& seen, Picture& picture) {
    Context& context = *body.context;
    const ViewGeometry& geometry = seen.view.geometry;
    const SurfaceOutput output = seen.drawn.output;
    const bool isMotion = seen.drawn.isMotion();
    const SurfaceVariant variant = body.surfaceVariant(seen.drawn);
    const VkExtent2D region = extentOf(geometry);
    const bool sorted = uint64_t{region.width} * region.height >= sortedFromPixels;
    ShadedBy kernels;
    if (!isMotion)
        if (const Status s = getKernels(variant, sorted, kernels); s != Status::ok) return s;
    if (const Status s = fit(context, region, output, kernels, picture); s != Status::ok) return s;
    BodyBlock block = seen.block;
    block.clipFromRelative = clipFromRelative(geometry);
    if (isMotion) block.region.x = block.region.y = 0; // whose pixels are counted in these images
    Resources resources;
    if (const Status s = bindBody(body, seen.view, block, resources); s != Status::ok) return s;
    if (const Status s = picture.found.record(context, commands, passes_->of(output), foundVariant(variant),
                                              seen.mesh, resources, *seen.view.given, geometry);
        s != Status::ok || isMotion)
        return s;
    return picture.shaded.record(context, commands, kernels, picture.found, std::move(resources), region);
}

Status ShadingPart::shade(Body& body, VkCommandBuffer commands, const ViewDesc& view,
                          const LightingDesc& lighting, SurfaceOutput output) {
    SeenSurface seen;
    if (const Status s = body.readSurface("shade", view, lighting, output, seen.view, seen.drawn);
        s != Status::ok)
        return s;
    if (const Status s = body.see("shade", nullptr, seen); s != Status::ok) return s;
    Picture& picture = views_[view.viewIndex][output];
    picture.frame = 0; // until all of it is recorded
    const bool shows = seen.mesh.instanceCount > 0;
    if (shows)
        if (const Status s = record(body, commands, seen, picture); s != Status::ok) return s;
    picture.frame = body.context->frameNumber;
    picture.shows = shows;
    picture.block = bodyBlock(body, seen.view);
    picture.sources = sourcesOf(view, lighting);
    return Status::ok;
}

Status ShadingPart::find(const Body& body, const BodyView& view, const Picture*& out) const {
    const Context& context = *body.context;
    const auto& pictures = views_[view.given->viewIndex];
    const auto found = pictures.find(view.surface->output);
    if (found == pictures.end() || found->second.frame != context.frameNumber)
        return context.device.misused(
            "draw: shade() was not called for the body and this view, with this output, in "
            "this frame before");
    const Picture& picture = found->second;
    if (!isSame(picture.block, bodyBlock(body, view)) ||
        picture.sources != sourcesOf(*view.given, *view.lighting))
        return context.device.misused(
            "draw: the view or the lighting has changed since shade(), which comes before with the same");
    out = &picture;
    return Status::ok;
}

void ShadingPart::bindPicture(const Context& context, const Picture& picture, SurfaceOutput output,
                              Resources& out) {
    const VkSampler nearest = context.samplers.nearestClamp();
    const VkImageView shown =
        output == SurfaceOutput::motion ? picture.found.beside() : picture.shaded.color.view();
    out.push_back({foundDepthBinding, gpu::sampledImage(nearest, picture.found.depth())});
    out.push_back({shadedBinding, gpu::sampledImage(nearest, shown)});
}

Status ShadingPart::place(Body& body, const DrawCall& call, SeenSurface& seen) const {
    const Picture* picture = nullptr;
    if (const Status s = find(body, seen.view, picture); s != Status::ok) return s;
    if (!picture->shows) return Status::ok;
    const bool isSampled = call.target.desc.samples != VK_SAMPLE_COUNT_1_BIT;
    return isSampled ? placeSamples(body, call, seen, *picture) : placeView(body, call, seen.view, *picture);
}

Status ShadingPart::placeView(Body& body, const DrawCall& call, const BodyView& view,
                              const Picture& picture) const {
    Context& context = *body.context;
    const SurfaceOutput output = view.surface->output;
    gpu::Slice slice;
    if (const Status s = context.frame().upload(picture.block, slice); s != Status::ok) return s;
    Resources resources = {{bodyBinding, gpu::uniformBuffer(slice)}};
    bindPicture(context, picture, output, resources);
    return recordViewPass(context, call, view, overView(output), resources);
}

Status ShadingPart::placeSamples(Body& body, const DrawCall& call, SeenSurface& seen,
                                 const Picture& picture) const {
    Context& context = *body.context;
    const PlacedSamplesVariant variant = placedSamplesVariant(body.surfaceVariant(seen.drawn));
    // The mesh is that of light: where the last frame showed it has been asked once.
    const SurfaceOutput output = std::exchange(seen.drawn.output, SurfaceOutput::shaded);
    if (const Status s = body.see("draw", &call.target, seen); s != Status::ok) return s;
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = call.target.placedSamples.get(variant, pipeline); s != Status::ok) return s;
    Resources resources;
    if (const Status s = bindBody(body, seen.view, seen.block, resources); s != Status::ok) return s;
    bindPicture(context, picture, output, resources);
    setViewport(context.device, call.commands, call.view, seen.view.geometry);
    const InstancesDraw all = {pipeline, {0, seen.mesh.instanceCount}};
    return recordSurface(context, call.commands, {&all, 1}, seen.mesh, std::move(resources),
                         call.view.viewIndex);
}

Status ShadingPart::prepareShading(const Body& body, const PrepareCall& call, SurfaceVariant& variant) const {
    SurfaceDraw drawn = drawnAhead(call);
    const bool hasSides = body.find<UnderwaterPart>() && !drawn.isMotion();
    for (const SidesSeen sides : {SidesSeen::either, SidesSeen::below, SidesSeen::above}) {
        if (sides != SidesSeen::above && !hasSides) continue;
        drawn.sides = sides;
        variant = body.surfaceVariant(drawn);
        if (drawn.isMotion()) continue;
        for (const bool sorted : {true, false}) {
            ShadedBy kernels;
            if (!sorted && sortedFromPixels == 0) continue;
            if (const Status s = getKernels(variant, sorted, kernels); s != Status::ok) return s;
        }
    }
    return Status::ok;
}

Status ShadingPart::prepare(const Body& body, const PrepareCall& call) const {
    SurfaceVariant variant;
    if (const Status s = prepareShading(body, call, variant); s != Status::ok) return s;
    const DrawPipeline *pipeline = nullptr, *cut = nullptr;
    if (const Status s = getFound(passes_->of(call.output), foundVariant(variant), pipeline, cut);
        s != Status::ok)
        return s;
    Target& target = call.target;
    return target.desc.samples == VK_SAMPLE_COUNT_1_BIT
               ? prepareViewPass(target.viewPasses, overView(call.output))
               : target.placedSamples.get(placedSamplesVariant(variant), pipeline);
}

Part shadingPart() {
    return partFrom<ShadingPart>();
}

} // namespace seaglass
