#include "water/underwater.h"

#include <vector>

#include "spirv/underwater.frag.h"
#include "spirv/underwater.vert.h"
#include "spirv/underwater_waves.frag.h"
#include "spirv/waterline.frag.h"
#include "spirv/waterline_waves.frag.h"

namespace seaglass {

namespace {

std::span<const uint32_t> fragmentShader(const UnderwaterVariant& v) {
    if (v.pass == UnderwaterPass::waterline) {
        if (v.waves) return waterline_waves_frag;
        return waterline_frag;
    }
    if (v.waves) return underwater_waves_frag;
    return underwater_frag;
}

/// In the order of the shaders' bindings.
std::vector<gpu::Resource> resources(const Context& context, const UnderwaterVariant& v,
                                     const UnderwaterInputs& in) {
    const gpu::Samplers& samplers = context.samplers;
    std::vector<gpu::Resource> list = {
        gpu::uniformBuffer(in.uniforms.buffer, in.uniforms.offset, sizeof(SurfaceUniforms))};
    if (v.pass == UnderwaterPass::water)
        for (const Image* image : {&in.view->sceneColor, &in.view->sceneDepth})
            list.push_back(gpu::sampledImage(samplers.nearestClamp(), image->view, image->layout));
    if (v.waves) list.push_back(gpu::sampledImage(samplers.trilinearRepeat(), in.waveDisplacement));
    return list;
}

std::vector<VkDescriptorType> bindings(const UnderwaterVariant& v) {
    std::vector<VkDescriptorType> types = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER};
    const size_t images = (v.pass == UnderwaterPass::water ? 2 : 0) + (v.waves ? 1 : 0);
    types.insert(types.end(), images, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    return types;
}

} // namespace

UnderwaterPipelines::~UnderwaterPipelines() {
    for (auto& [key, pipeline] : pipelines_)
        device_->vk().DestroyPipeline(device_->handle(), pipeline.handle, device_->allocator());
}

void UnderwaterPipelines::init(const gpu::Device& device, const TargetDesc& desc) {
    device_ = &device;
    desc_ = desc;
}

Status UnderwaterPipelines::get(const UnderwaterVariant& variant, const DrawPipeline*& out) {
    const auto [entry, fresh] = pipelines_.try_emplace(variant);
    if (fresh)
        if (const Status s = build(variant, entry->second); s != Status::ok) {
            pipelines_.erase(entry);
            return s;
        }
    out = &entry->second;
    return Status::ok;
}

Status UnderwaterPipelines::build(const UnderwaterVariant& variant, DrawPipeline& out) const {
    const std::vector<VkDescriptorType> types = bindings(variant);
    if (const Status s =
            out.layout.create(*device_, types, VK_SHADER_STAGE_FRAGMENT_BIT, 0, "underwater layout");
        s != Status::ok)
        return s;
    const bool water = variant.pass == UnderwaterPass::water;
    const uint32_t straddles[] = {variant.straddles};
    const std::span<const uint32_t> constants(straddles, water ? 1 : 0);
    return createDrawPipeline(*device_, desc_, {underwater_vert, fragmentShader(variant), constants},
                              water ? Drawing::over : Drawing::blended, "underwater pipeline", out);
}

Status recordUnderwater(Context& context, VkCommandBuffer commands, UnderwaterPipelines& pipelines,
                        const UnderwaterVariant& variant, const UnderwaterInputs& inputs) {
    const DrawPipeline* pipeline = nullptr;
    if (const Status s = pipelines.get(variant, pipeline); s != Status::ok) return s;
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s =
            context.frame().allocateSet(pipeline->layout.set(), resources(context, variant, inputs), set);
        s != Status::ok)
        return s;
    const gpu::PassScope pass(context.device, commands,
                              variant.pass == UnderwaterPass::water ? "underwater" : "waterline");
    const gpu::DeviceTable& vk = context.device.vk();
    vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle);
    vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->layout.pipeline(), 0, 1,
                             &set, 0, nullptr);
    vk.CmdDraw(commands, 3, 1, 0, 0);
    return Status::ok;
}

} // namespace seaglass
