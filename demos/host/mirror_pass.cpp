#include "host/mirror_pass.h"

#include <cstring>

#include "host/floor_texture.h"
#include "host/pipeline.h"
#include "host/rendering.h"
#include "host/seaglass_view.h"
#include "spirv/mirror.frag.h"
#include "spirv/mirror.vert.h"

namespace demos {
namespace {

constexpr VkDescriptorType bindings[] = {
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
constexpr uint32_t textureBinding = 1, colorBinding = 2, infoBinding = 3;

bool createTexture(Device& device, const FloorDesc& desc, MirrorSurface& out, Error& error) {
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
    return createSampledImage(device, image, {&level, 1}, out.texture, error) &&
           createSampler(device, sampler, out.textureSampler, error) &&
           createSampler(device, {}, out.reflectionSampler, error);
}

} // namespace

MirrorPass::~MirrorPass() {
    if (context_) seaglass::destroyContext(context_);
}

bool MirrorPass::ok(seaglass::Status status, Error& error) {
    if (status == seaglass::Status::ok) return true;
    error.text = "floor: " + (message_.empty() ? seaglass::toString(status) : message_);
    message_.clear();
    return false;
}

void MirrorPass::create(Device& device, const Layouts& layouts, uint32_t framesInFlight, PassTimer& timer) {
    device_ = &device;
    layouts_ = &layouts;
    framesInFlight_ = framesInFlight;
    timer_ = &timer;
}

bool MirrorPass::createOnce(Error& error) {
    if (context_) return true;
    seaglass::DeviceDesc desc;
    desc.instance = device_->instance();
    desc.physicalDevice = device_->physical();
    desc.device = device_->handle();
    desc.getInstanceProcAddr = vkGetInstanceProcAddr;
    desc.framesInFlight = framesInFlight_;
    desc.message.user = &message_;
    desc.message.function = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
    desc.pass.user = timer_;
    desc.pass.function = [](void* user, VkCommandBuffer commands, const char* pass, bool begins) {
        static_cast<PassTimer*>(user)->mark(commands, pass, begins);
    };
    PipelineDesc pipeline;
    pipeline.vertex = mirror_vert;
    pipeline.fragment = mirror_frag;
    pipeline.meshVertices = false;
    pipeline.colorFormat = FrameTargets::colorFormat;
    pipeline.depthFormat = FrameTargets::depthFormat;
    return createLayout(error) && createPipeline(*device_, layout_.get(), pipeline, pipeline_, error) &&
           ok(seaglass::createContext(&desc, &context_), error);
}

bool MirrorPass::createLayout(Error& error) {
    if (!createSetLayout(*device_, bindings, setLayout_, error)) return false;
    const VkDescriptorSetLayout sets[] = {layouts_->frame.get(), setLayout_.get()};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 2;
    info.pSetLayouts = sets;
    // As the host's other pipelines, so that set 0 stays bound from one to the next.
    const VkPushConstantRange range = {drawStages, 0, sizeof(DrawConstants)};
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    if (!succeeded(vkCreatePipelineLayout(device_->handle(), &info, nullptr, &layout),
                   "vkCreatePipelineLayout", error))
        return false;
    layout_ = UniquePipelineLayout(device_->handle(), layout);
    return true;
}

bool MirrorPass::createReflector(const ReflectionDesc& desc, const FloorPlane& plane, MirrorSurface& out,
                                 Error& error) {
    seaglass::ReflectorDesc reflector;
    if (!reflectionOf(desc, "floor", reflector.reflection, error)) return false;
    if (reflector.reflection.technique == seaglass::ReflectionTechnique::sky) return true;
    reflector.reflection.blurLevels = out.desc.roughness > 0 ? 6 : 0;
    for (int i = 0; i < 3; ++i) reflector.plane[i] = plane.normal[i];
    reflector.plane[3] = -glm::dot(plane.normal, plane.middle);
    seaglass::Reflector* made = nullptr;
    if (!ok(seaglass::createReflector(context_, &reflector, &made), error)) return false;
    out.reflector.reset(made);
    out.downscale = static_cast<int>(reflector.reflection.downscale);
    out.planar = reflector.reflection.technique == seaglass::ReflectionTechnique::planar;
    return true;
}

bool MirrorPass::createSet(MirrorSurface& surface, Error& error) const {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3}};
    if (!allocateSet(*device_, setLayout_.get(), sizes, surface.pool, surface.set, error)) return false;
    writeUniformBuffer(*device_, surface.set, surface.uniforms.buffer.get(), sizeof(MirrorUniforms));
    writeTexture(*device_, surface.set, textureBinding, surface.texture.view.get(),
                 surface.textureSampler.get());
    // Without a reflection they are not read, and need something to point at.
    for (const uint32_t binding : {colorBinding, infoBinding})
        writeTexture(*device_, surface.set, binding, surface.texture.view.get(),
                     surface.reflectionSampler.get());
    return true;
}

bool MirrorPass::createSurface(const FloorDesc& desc, MirrorSurface& out, Error& error) {
    out.desc = desc;
    out.plane = floorPlane(desc);
    return createOnce(error) && createTexture(*device_, desc, out, error) &&
           createBuffer(*device_, sizeof(MirrorUniforms), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                        BufferPlace::upload, out.uniforms, error) &&
           createSet(out, error) &&
           (!desc.reflection || createReflector(*desc.reflection, out.plane, out, error));
}

bool MirrorPass::beginFrame(Error& error) {
    if (!context_) return true;
    slot_ = (slot_ + 1) % framesInFlight_;
    return ok(seaglass::beginFrame(context_, slot_), error);
}

bool MirrorPass::planarView(const MirrorSurface& surface, const Camera& camera, const FrameTargets& targets,
                            seaglass::PlanarView& out, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return ok(seaglass::planarView(surface.reflector.get(), &view, &out), error);
}

bool MirrorPass::reflect(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                         const FrameTargets& targets, Error& error) {
    seaglass::Reflector* const reflectors[] = {surface.reflector.get()};
    const seaglass::ViewDesc view = viewOf(camera, targets);
    return ok(seaglass::reflect(commands, reflectors, 1, &view), error);
}

bool MirrorPass::overlay(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                         const FrameTargets& targets, Aov aov, Error& error) {
    const seaglass::ViewDesc view = viewOf(camera, targets);
    const seaglass::OverlayDesc desc = overlayOf(aov, targets);
    return ok(seaglass::recordOverlay(commands, surface.reflector.get(), &view, &desc), error);
}

void MirrorPass::writeUniforms(const MirrorSurface& surface, const Camera& camera, VkExtent2D extent,
                               Aov aov) const {
    const FloorDesc& desc = surface.desc;
    const FloorPlane& plane = surface.plane;
    const auto with = [](const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); };
    MirrorUniforms uniforms{};
    uniforms.middle = with(plane.middle - camera.eye, desc.reflectance);
    uniforms.across = with(plane.across * (desc.widthM / 2), desc.widthM / 2 / desc.textureM);
    uniforms.along = with(plane.along * (desc.lengthM / 2), desc.lengthM / 2 / desc.textureM);
    uniforms.normal = with(plane.normal, desc.roughness);
    uniforms.color = with(toGlm(desc.color), extent.height / (2 * camera.tanHalfFovY));
    uniforms.modes = {static_cast<int>(aov), surface.reflector ? 1 : 0, surface.downscale, 0};
    std::memcpy(surface.uniforms.mapped, &uniforms, sizeof(uniforms));
}

void MirrorPass::draw(VkCommandBuffer commands, const MirrorSurface& surface, const Camera& camera,
                      const FrameTargets& targets, Aov aov) const {
    writeUniforms(surface, camera, targets.extent, aov);
    if (surface.reflector) {
        const seaglass::ReflectionImages images = seaglass::reflectionImages(surface.reflector.get(), 0);
        writeTexture(*device_, surface.set, colorBinding, images.color, surface.reflectionSampler.get());
        writeTexture(*device_, surface.set, infoBinding, images.info, surface.reflectionSampler.get());
    }
    const bool overScene = aov == Aov::color || aov == Aov::depth;
    beginRendering(commands, targets.extent, &targets.color,
                   overScene ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR, targets.depth,
                   VK_ATTACHMENT_LOAD_OP_LOAD, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 1, 1, &surface.set, 0,
                            nullptr);
    vkCmdSetCullMode(commands, VK_CULL_MODE_BACK_BIT);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdDraw(commands, 6, 1, 0, 0);
    vkCmdEndRendering(commands);
}

} // namespace demos
