#include "host/passes/mirror_pass.h"

#include <cstring>

#include "host/passes/floor_texture.h"
#include "host/seaglass_view.h"
#include "host/vulkan/pipeline.h"
#include "host/vulkan/rendering.h"
#include "spirv/mirror.frag.h"
#include "spirv/mirror.vert.h"

namespace demos {
namespace {

constexpr VkDescriptorType bindings[] = {
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
constexpr uint32_t textureBinding = 1, colorBinding = 2, infoBinding = 3;

bool createTexture(Device& device, const FloorDesc& desc, FloorTexture& out, Error& error) {
    const std::optional<MeshTexture> texture = readFloorTexture(desc, error);
    if (!texture) return false;
    ImageDesc image;
    image.format = VK_FORMAT_R8G8B8A8_SRGB;
    image.extent = {texture->width, texture->height};
    image.mips = fullMipCount(image.extent);
    const std::span<const std::byte> level = std::as_bytes(std::span(texture->rgba));
    SamplerDesc sampler;
    sampler.u = sampler.v = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    // As the meshes' textures.
    sampler.anisotropic = device.info().type != "cpu";
    return createSampledImage(device, image, {&level, 1}, out.image, error) &&
           createSampler(device, sampler, out.sampler, error);
}

bool isMirrored(const std::optional<seaglass::ReflectionDesc>& desc) {
    return desc && desc->technique != seaglass::ReflectionTechnique::sky;
}

seaglass::ReflectionDesc reflectionOf(const FloorDesc& desc) {
    seaglass::ReflectionDesc reflection = *desc.reflection;
    if (desc.roughness == 0 && reflection.scatter == 0) reflection.blurLevels = 0;
    return reflection;
}

} // namespace

void MirrorPass::create(Device& device, const Layouts& layouts, uint32_t framesInFlight) {
    device_ = &device;
    layouts_ = &layouts;
    framesInFlight_ = framesInFlight;
}

bool MirrorPass::createOnce(Error& error) {
    return context_.exists() ||
           (createLayout(error) && context_.create(*device_, framesInFlight_, "floor", error));
}

VkPipeline MirrorPass::pipelineOf(const MirrorSurface& surface, Aov aov, Error& error) {
    // Where depth is shown, colour is drawn as ever.
    const Aov shown = aov == Aov::depth ? Aov::color : aov;
    const bool mirrored = surface.reflector != nullptr;
    UniquePipeline& pipeline = pipelines_[{shown, mirrored}];
    if (pipeline) return pipeline.get();
    const uint32_t constants[] = {static_cast<uint32_t>(shown), mirrored};
    PipelineDesc desc;
    desc.vertex = mirror_vert;
    desc.fragment = mirror_frag;
    desc.meshVertices = false;
    desc.constants = constants;
    desc.colorFormat = needsExact(aov) ? FrameTargets::exactFormat : FrameTargets::colorFormat;
    desc.depthFormat = FrameTargets::depthFormat;
    if (!createPipeline(*device_, layout_.get(), desc, pipeline, error)) return VK_NULL_HANDLE;
    return pipeline.get();
}

bool MirrorPass::createLayout(Error& error) {
    if (!createSetLayout(*device_, bindings, setLayout_, error)) return false;
    const VkDescriptorSetLayout sets[] = {layouts_->frame.get(), setLayout_.get()};
    // As the host's other pipelines, so that set 0 stays bound from one to the next.
    return createPipelineLayout(*device_, sets, sizeof(DrawConstants), layout_, error);
}

bool MirrorPass::createReflector(MirrorSurface& out, Error& error) {
    seaglass::ReflectorDesc reflector;
    reflector.reflection = reflectionOf(out.desc);
    reflector.reflection.distortion = 0; // nothing bends it
    for (int i = 0; i < 3; ++i) reflector.plane[i] = out.plane.normal[i];
    reflector.plane[3] = -glm::dot(out.plane.normal, out.plane.middle);
    const glm::dvec3 reach = glm::abs(out.plane.across) * (0.5 * out.desc.widthM) +
                             glm::abs(out.plane.along) * (0.5 * out.desc.lengthM);
    for (int i = 0; i < 3; ++i) {
        reflector.boundsLow[i] = out.plane.middle[i] - reach[i];
        reflector.boundsHigh[i] = out.plane.middle[i] + reach[i];
    }
    seaglass::Reflector* made = nullptr;
    if (!context_.ok(seaglass::createReflector(context_.get(), &reflector, &made), error)) return false;
    out.reflector.reset(made);
    out.planar = reflector.reflection.technique == seaglass::ReflectionTechnique::planar;
    return true;
}

bool MirrorPass::createSet(MirrorSurface& surface, Error& error) const {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3}};
    if (!allocateSet(*device_, setLayout_.get(), sizes, surface.pool, surface.set, error)) return false;
    writeUniformBuffer(*device_, surface.set, surface.uniforms.buffer.get(), sizeof(MirrorBlock));
    writeTexture(*device_, surface.set, textureBinding, surface.texture->image.view.get(),
                 surface.texture->sampler.get());
    // Without a reflection they are not read, and need something to point at.
    for (const uint32_t binding : {colorBinding, infoBinding})
        writeTexture(*device_, surface.set, binding, surface.texture->image.view.get(),
                     surface.reflectionSampler.get());
    return true;
}

bool MirrorPass::createSurface(const FloorDesc& desc, const MirrorSurface* alike, MirrorSurface& out,
                               Error& error) {
    out.desc = desc;
    out.plane = floorPlane(desc);
    if (!createOnce(error)) return false;
    if (alike && alike->desc.texture == desc.texture) {
        out.texture = alike->texture;
    } else {
        const auto texture = std::make_shared<FloorTexture>();
        if (!createTexture(*device_, desc, *texture, error)) return false;
        out.texture = texture;
    }
    return createSampler(*device_, {}, out.reflectionSampler, error) &&
           createBuffer(*device_, sizeof(MirrorBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                        BufferPlace::upload, out.uniforms, error) &&
           createSet(out, error) && (!isMirrored(desc.reflection) || createReflector(out, error));
}

bool MirrorPass::estimateReflection(const FloorDesc& desc, VkExtent2D extent, uint64_t& bytes, Error& error) {
    bytes = 0;
    if (!isMirrored(desc.reflection)) return true;
    return createOnce(error) && context_.estimate(reflectionOf(desc), extent, bytes, error);
}

bool MirrorPass::planarView(const MirrorSurface& surface, const Camera& camera, const FrameTargets& targets,
                            seaglass::PlanarView& out, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::planarView(surface.reflector.get(), &view, &out), error);
}

bool MirrorPass::reflect(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                         const FrameTargets& targets, Error& error) {
    seaglass::Reflector* const reflectors[] = {surface.reflector.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return context_.ok(seaglass::reflect(commands, reflectors, 1, &view), error);
}

bool MirrorPass::overlay(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                         const FrameTargets& targets, Aov aov, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    const seaglass::OverlayDesc desc = overlayOf(aov, targets);
    return context_.ok(seaglass::recordOverlay(commands, surface.reflector.get(), &view, &desc), error);
}

namespace {

/// Of the reflection of this frame, where there is one.
uint32_t downscaleOf(const MirrorSurface& surface) {
    return surface.reflector ? seaglass::reflectionImages(surface.reflector.get(), 0).downscale : 1;
}

} // namespace

void MirrorPass::writeUniforms(const MirrorSurface& surface, const Camera& camera, VkExtent2D extent) const {
    const FloorDesc& desc = surface.desc;
    const FloorPlane& plane = surface.plane;
    const auto with = [](const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); };
    MirrorBlock uniforms{};
    uniforms.middle = with(plane.middle - camera.eye, desc.reflectance);
    uniforms.across = with(plane.across * (desc.widthM / 2), desc.widthM / 2 / desc.textureM);
    uniforms.along = with(plane.along * (desc.lengthM / 2), desc.lengthM / 2 / desc.textureM);
    uniforms.normal = with(plane.normal, desc.roughness);
    uniforms.color = with(toGlm(desc.color), extent.height / (2 * camera.tanHalfFovY));
    uniforms.picture = glm::vec4(extent.width, extent.height, downscaleOf(surface), 0);
    if (desc.reflection)
        uniforms.blur = glm::dvec4(desc.reflection->clearDistance, desc.reflection->scatter,
                                   desc.reflection->skyFadeDistance, 0);
    std::memcpy(surface.uniforms.mapped, &uniforms, sizeof(uniforms));
}

bool MirrorPass::draw(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                      const FrameTargets& targets, Aov aov, Error& error) {
    const VkPipeline pipeline = pipelineOf(surface, aov, error);
    if (!pipeline) return false;
    writeUniforms(surface, camera, targets.extent);
    if (surface.reflector) {
        const seaglass::ReflectionImages images = seaglass::reflectionImages(surface.reflector.get(), 0);
        writeTexture(*device_, surface.set, colorBinding, images.color, surface.reflectionSampler.get());
        writeTexture(*device_, surface.set, infoBinding, images.info, surface.reflectionSampler.get());
    }
    const bool overScene = aov == Aov::color || aov == Aov::depth, exact = needsExact(aov);
    if (exact) targets.exactToAttachment(commands);
    beginRendering(commands, targets.extent, exact ? &targets.exact : &targets.color,
                   overScene ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 1, 1, &surface.set, 0,
                            nullptr);
    vkCmdSetCullMode(commands, VK_CULL_MODE_BACK_BIT);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdDraw(commands, 6, 1, 0, 0);
    vkCmdEndRendering(commands);
    return true;
}

} // namespace demos
