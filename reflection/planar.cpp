#include "reflection/planar.h"

#include <glm/matrix.hpp>

#include "reflection/mirror.h"
#include "reflection/oblique.h"
#include "spirv/planar.comp.h"

namespace seaglass {

namespace {

/// The std140 block of shaders/planar.comp.
struct PlanarUniforms {
    glm::vec4 heightRow{0};
    glm::vec4 weightRow{0};
};

/// Without its translation: what the view does to points relative to the eye.
glm::dmat4 turned(const glm::dmat4& view) {
    glm::dmat4 rotation = view;
    rotation[3] = glm::dvec4(0, 0, 0, 1);
    return rotation;
}

void recordBarriers(const ReflectPass& pass, const PlanarScratch& scratch, const OwnedReflection& images) {
    VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(images.color.handle(), gpu::drawnColor, gpu::storageChanged, 0, 1),
        gpu::imageBarrier(scratch.depth.handle(), gpu::drawnDepth, gpu::sampledByShaders),
        gpu::imageBarrier(images.info.handle(), gpu::discardedAfterSampling, gpu::storageWritten)};
    before[1].subresourceRange.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    gpu::recordBarriers(pass.context.device, pass.commands, before, 3);
}

} // namespace

gpu::ImageDesc drawnDepthDesc(VkExtent2D extent) {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_D32_SFLOAT;
    desc.extent = extent;
    desc.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    desc.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    return desc;
}

void setImages(const gpu::OwnedImage& color, const gpu::OwnedImage& depth, double farDepth, PlanarView& out) {
    out.extent = color.desc().extent;
    out.colorImage = color.handle();
    out.color = color.firstMipView();
    out.colorFormat = color.desc().format;
    out.depthImage = depth.handle();
    out.depth = depth.view();
    out.depthFormat = depth.desc().format;
    out.clearDepth = static_cast<float>(farDepth);
}

Status PlanarKernel::create(Context& context) {
    constexpr VkDescriptorType bindings[] = {
        VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
        VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    return kernel.create(context.device, planar_comp, bindings, "planar pipeline");
}

Status PlanarScratch::create(const gpu::Device& device, VkExtent2D extent) {
    return depth.create(device, drawnDepthDesc(extent), "mirrored depth");
}

VkDeviceSize PlanarScratch::bytes(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, drawnDepthDesc(extent));
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
    setImages(images.color, scratch.depth, geometry.farDepth, out);
    return out;
}

Status recordPlanar(const ReflectPass& pass, const PlanarKernel& planar, const PlanarScratch& scratch,
                    const glm::dvec4& worldPlane, const OwnedReflection& images) {
    Context& context = pass.context;
    const MirroredCamera camera = mirroredCamera(pass.view, pass.geometry, worldPlane);
    const PlanarUniforms uniforms{glm::vec4(camera.heightRow), glm::vec4(camera.weightRow)};
    gpu::Slice slice;
    if (const Status s = context.frame().upload(uniforms, slice); s != Status::ok) return s;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::uniformBuffer(slice.buffer, slice.offset, sizeof uniforms),
        gpu::sampledImage(context.samplers.nearestClamp(), scratch.depth.view()),
        gpu::storageImage(images.color.firstMipView()),
        gpu::storageImage(images.info.view()),
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(planar.kernel.layout(), resources, set); s != Status::ok)
        return s;

    const VkCommandBuffer commands = pass.commands;
    const gpu::PassScope scope(context.device, commands, "planar_resolve");
    recordBarriers(pass, scratch, images);
    planar.kernel.dispatchOver(commands, set, images.color.desc().extent);
    images.recordInfoSampled(context.device, commands);
    return Status::ok;
}

} // namespace seaglass
