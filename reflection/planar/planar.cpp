#include "reflection/planar/planar.h"

#include <span>

#include <glm/matrix.hpp>

#include "gpu/view/oblique.h"
#include "reflection/core/mirror.h"
#include "reflection/core/technique.h"
#include "shaders/shared/planar_block.h"
#include "shaders/shared/reflection_bindings.h"
#include "spirv/planar.comp.h"
#include "spirv/planar_apart.comp.h"
#include "spirv/planar_multisampled.comp.h"
#include "spirv/planar_resolved.comp.h"

namespace seaglass {

namespace {

/// Without its translation: what the view does to points relative to the eye.
glm::dmat4 turned(const glm::dmat4& view) {
    glm::dmat4 rotation = view;
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    return rotation;
}

void recordBarriers(const ReflectPass& pass, const PlanarScratch& scratch, const OwnedReflection& images) {
    const bool apart = scratch.color.handle();
    const VkImageMemoryBarrier2 before[] = {
        colorDrawn(scratch.drawnColor(images), apart ? gpu::sampledByShaders : gpu::storageChanged),
        depthDrawn(scratch.depth),
        gpu::imageBarrier(images.info.handle(), gpu::discardedAfterSampling, gpu::storageWritten),
        gpu::imageBarrier(images.color.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1)};
    gpu::recordBarriers(pass.context.device, pass.commands, before, apart ? 4 : 3);
}

} // namespace

PlanarForm planarForm(const DrawnDesc& drawn) {
    if (drawn.samples.color != VK_SAMPLE_COUNT_1_BIT) return PlanarForm::multisampled;
    if (drawn.samples.depth != VK_SAMPLE_COUNT_1_BIT) return PlanarForm::resolved;
    return drawn.colorFormat == reflectionColorFormat ? PlanarForm::inPlace : PlanarForm::apart;
}

template<PlanarForm form>
Status PlanarKernelOf<form>::create(Context& context) {
    using Shader = std::span<const uint32_t>;
    const Shader shaders[] = {planar_comp, planar_apart_comp, planar_resolved_comp, planar_multisampled_comp};
    return kernel.create(context, shaders[static_cast<size_t>(form)], "planar pipeline");
}

template struct PlanarKernelOf<PlanarForm::inPlace>;
template struct PlanarKernelOf<PlanarForm::apart>;
template struct PlanarKernelOf<PlanarForm::resolved>;
template struct PlanarKernelOf<PlanarForm::multisampled>;

namespace {

template<PlanarForm form>
Status shareForm(Context& context, std::shared_ptr<PlanarKernel>& out) {
    std::shared_ptr<PlanarKernelOf<form>> shared;
    const Status s = context.share(shared);
    out = shared;
    return s;
}

} // namespace

Status PlanarKernels::create(Context& context, const ReflectionDesc& desc) {
    switch (planarForm(desc.drawn)) {
    case PlanarForm::inPlace:
        break;
    case PlanarForm::apart:
        return shareForm<PlanarForm::apart>(context, planar);
    case PlanarForm::resolved:
        return shareForm<PlanarForm::resolved>(context, planar);
    case PlanarForm::multisampled:
        return shareForm<PlanarForm::multisampled>(context, planar);
    }
    return shareForm<PlanarForm::inPlace>(context, planar);
}

Status PlanarScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    const VkExtent2D scaled = scaledDown(extent, desc);
    if (planarForm(desc.drawn) != PlanarForm::inPlace)
        if (const Status s = color.create(device, drawnColorDesc(desc.drawn, scaled), "mirrored colour");
            s != Status::ok)
            return s;
    return depth.create(device, drawnDepthDesc(desc.drawn, scaled), "mirrored depth");
}

VkDeviceSize PlanarScratch::bytes(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    const VkExtent2D scaled = scaledDown(extent, desc);
    const bool apart = planarForm(desc.drawn) != PlanarForm::inPlace;
    return gpu::heldBytes(device, drawnDepthDesc(desc.drawn, scaled)) +
           (apart ? gpu::heldBytes(device, drawnColorDesc(desc.drawn, scaled)) : 0);
}

MirroredCamera mirroredCamera(const ViewDesc& view, const ViewGeometry& geometry,
                              const glm::dvec4& worldPlane) {
    const glm::dmat4 hostView = toMatrix(view.view);
    const glm::dmat4 hostProjection = toMatrix(view.projection);
    const glm::dmat4 rotation = turned(hostView);
    const glm::dvec4 plane = planeFacing(worldPlane, geometry);
    // A world point p is drawn at v = V R p. Its height is plane.p = -(plane V^-1).v, since plane R = -plane.
    const glm::dvec4 keptSide = -(plane * glm::inverse(rotation));

    MirroredCamera camera;
    camera.view = hostView * householder(worldPlane);
    const ObliqueProjection clipped =
        obliqueProjection(hostProjection, geometry.reversedDepth, keptSide, farthestImage(geometry, plane));
    camera.projection = clipped.projection;
    camera.obliqueClip = clipped.oblique;

    const glm::dmat4 pixelFromClip = geometry.pixelFromRelative * glm::inverse(geometry.clipFromRelative);
    const glm::dmat4 viewFromPixel = glm::inverse(pixelFromClip * camera.projection);
    camera.heightRow = keptSide * viewFromPixel;
    camera.weightRow = row(viewFromPixel, 3);
    return camera;
}

PlanarView describe(const MirroredCamera& camera, const ViewDesc& view, const ViewGeometry& geometry,
                    uint32_t downscale, const PlanarScratch& scratch, const OwnedReflection& images) {
    PlanarView out;
    toValues(camera.view, out.view);
    toValues(camera.projection, out.projection);
    out.obliqueClip = camera.obliqueClip;
    const auto scale = static_cast<float>(downscale);
    out.viewport = {(view.viewport.x - static_cast<float>(geometry.regionOrigin.x)) / scale,
                    (view.viewport.y - static_cast<float>(geometry.regionOrigin.y)) / scale,
                    view.viewport.width / scale,
                    view.viewport.height / scale,
                    0,
                    1};
    setImages(scratch.drawnColor(images), scratch.depth, geometry.farDepth, out);
    return out;
}

namespace {

/// Takes mip 0 of `images.color` and the depth from attachments, as the host has left them.
Status record(const ReflectPass& pass, PlanarKernels& kernels, PlanarScratch& scratch,
              const OwnedReflection& images) {
    scratch.handedOut = false;
    Context& context = pass.context;
    const MirroredCamera camera = mirroredCamera(pass.view, pass.geometry, pass.plane);
    const PlanarBlock block{
        glm::vec4(camera.heightRow), glm::vec4(camera.weightRow), scratch.depth.desc().samples, 0, 0, 0};
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {settingsBinding, gpu::uniformBuffer(slice)},
        {mirroredDepthBinding, gpu::sampledImage(context.samplers.nearestClamp(), scratch.depth.view())},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
        {mirroredColorBinding, gpu::sampledImage(context.samplers.nearestClamp(), scratch.color.view())},
    };
    Image drawn = pass.view.sceneColor;
    if (scratch.color.handle() && appliesSrgb(scratch.color.desc().format)) drawn.encoding = Encoding::linear;
    const gpu::Kernel* kernel = nullptr;
    if (const Status s = kernels.planar->kernel.of(context, drawn, kernel); s != Status::ok) return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(kernel->layout(), resources, set); s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    const gpu::PassScope scope(context.device, commands, "planar_resolve");
    recordBarriers(pass, scratch, images);
    kernel->dispatchOver(commands, set, images.color.desc().extent);
    images.recordInfoSampled(context.device, commands);
    return Status::ok;
}

} // namespace

Technique planarTechnique() {
    Technique technique = techniqueFrom<PlanarKernels, PlanarScratch, record>(
        [](const gpu::Device&, const ReflectionDesc&) { return 1u; });
    technique.readsScene = false;
    return technique;
}

} // namespace seaglass
