#include "reflection/march.h"

#include <cstddef>
#include <cstring>

#include "reflection/mirror.h"
#include "reflection/tiles.h"
#include "spirv/march.comp.h"
#include "spirv/march_open.comp.h"

namespace seaglass {

namespace {

/// The std140 block of shaders/common/march.glsl.
struct MarchUniforms {
    glm::mat4 pixelFromRelative{1};
    glm::vec4 forwardRow{0};
    float thickness = 0;
    float longest = 0;
    float jitter = 0;
    int32_t steps = 0;
    uint32_t hasNormals = 0;
    uint32_t padding[3] = {};
};
static_assert(sizeof(MarchUniforms) == 112);

MarchUniforms marchUniforms(const ReflectPass& pass) {
    const ViewGeometry& view = pass.geometry;
    const ReflectionDesc& desc = pass.desc;
    MarchUniforms out;
    out.pixelFromRelative = glm::mat4(scenePixelFromRelative(view));
    out.forwardRow = glm::vec4(glm::dvec4(view.forward, 0) * relativeFromScenePixel(view));
    out.thickness = desc.marchThickness;
    out.longest = desc.marchDistance;
    out.jitter = desc.marchJitter;
    out.steps = static_cast<int32_t>(desc.marchSteps);
    out.hasNormals = pass.view.surfaceNormals ? 1 : 0;
    return out;
}

/// `last`: normals, or the tiles to complete.
Status createKernel(Context& context, std::span<const uint32_t> spirv, VkDescriptorType last,
                    const char* what, gpu::Kernel& out) {
    const VkDescriptorType bindings[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                         VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                         VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                         VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                         VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
                                         VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
                                         last};
    return out.create(context.device, spirv, bindings, what);
}

Status allocateSet(const ReflectPass& pass, const gpu::Kernel& kernel, const OwnedReflection& images,
                   const gpu::Resource& last, VkDescriptorSet& out) {
    gpu::Frame& frame = pass.context.frame();
    const MarchUniforms uniforms = marchUniforms(pass);
    gpu::Slice settings;
    if (const Status s = frame.allocate(sizeof uniforms, settings); s != Status::ok) return s;
    std::memcpy(settings.data, &uniforms, sizeof uniforms);

    const VkSampler nearest = pass.context.samplers.nearestClamp();
    const Image& depth = pass.view.sceneDepth;
    const Image& color = pass.view.sceneColor;
    const gpu::Resource resources[] = {
        gpu::uniformBuffer(pass.mirror.buffer, pass.mirror.offset, sizeof(MirrorUniforms)),
        gpu::sampledImage(nearest, depth.view, depth.layout),
        gpu::uniformBuffer(settings.buffer, settings.offset, sizeof uniforms),
        gpu::sampledImage(nearest, color.view, color.layout),
        gpu::storageImage(images.color.firstMipView()),
        gpu::storageImage(images.info.view()),
        last,
    };
    return frame.allocateSet(kernel.layout().set(), resources, out);
}

} // namespace

Status MarchKernel::create(Context& context) {
    return createKernel(context, march_comp, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, "march pipeline",
                        kernel);
}

Status OpenMarchKernel::create(Context& context) {
    return createKernel(context, march_open_comp, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, "open march pipeline",
                        kernel);
}

Status recordMarch(const ReflectPass& pass, const MarchKernel& march, const OwnedReflection& images) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    // The colour stands in for normals that nobody reads.
    const Image& normals = pass.view.surfaceNormals ? *pass.view.surfaceNormals : pass.view.sceneColor;
    const gpu::Resource last =
        gpu::sampledImage(pass.context.samplers.nearestClamp(), normals.view, normals.layout);
    if (const Status s = allocateSet(pass, march.kernel, images, last, set); s != Status::ok) return s;
    const gpu::Device& device = pass.context.device;
    const gpu::PassScope scope(device, pass.commands, "ssr_march");
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(images.color.handle(), gpu::discardedAfterSampling, gpu::storageWritten, 0, 1),
        gpu::imageBarrier(images.info.handle(), gpu::discardedAfterSampling, gpu::storageWritten)};
    gpu::recordBarriers(device, pass.commands, before, 2);
    const VkExtent2D extent = images.color.desc().extent;
    march.kernel.dispatch(pass.commands, set, (extent.width + tileEdge - 1) / tileEdge,
                          (extent.height + tileEdge - 1) / tileEdge);
    images.recordInfoSampled(device, pass.commands);
    return Status::ok;
}

Status recordOpenMarch(const ReflectPass& pass, const OpenMarchKernel& march, const gpu::Buffer& open,
                       const OwnedReflection& images) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = allocateSet(pass, march.kernel, images, gpu::storageBuffer(open.handle()), set);
        s != Status::ok)
        return s;
    const gpu::Device& device = pass.context.device;
    const gpu::PassScope scope(device, pass.commands, "hybrid_march");
    const VkImageMemoryBarrier2 before[] = {
        gpu::imageBarrier(images.color.handle(), gpu::storageWritten, gpu::storageWritten, 0, 1),
        gpu::imageBarrier(images.info.handle(), gpu::sampledByShaders, gpu::storageChanged)};
    gpu::recordBarriers(device, pass.commands, before, 2);
    march.kernel.dispatchIndirect(pass.commands, set, open.handle(), offsetof(TileHeader, resolveGroups));
    images.recordInfoSampled(device, pass.commands);
    return Status::ok;
}

} // namespace seaglass
