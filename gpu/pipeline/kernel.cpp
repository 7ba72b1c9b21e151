#include "gpu/pipeline/kernel.h"

#include <utility>
#include <vector>

#include "gpu/pipeline/compile_watch.h"
#include "gpu/pipeline/specialized.h"
#ifdef SEAGLASS_SHADER_RELOAD
#include "gpu/interface/shader_reload.h"
#endif

namespace seaglass::gpu {

Status ShaderModule::create(std::span<const uint32_t> spirv, std::span<const uint32_t> constants,
                            const char* what) {
#ifdef SEAGLASS_SHADER_RELOAD
    std::vector<uint32_t> reloaded;
    if (!reloadShader(spirv, reloaded))
        return device_.fail(Status::invalidArgument, "%s: its changed shader does not compile", what);
    if (!reloaded.empty()) spirv = reloaded;
#endif
    words_ = specialized(spirv, constants);
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words_.size() * sizeof(uint32_t);
    info.pCode = words_.data();
    return device_.made(
        device_.vk().CreateShaderModule(device_.handle(), &info, device_.allocator(), &module_),
        VK_OBJECT_TYPE_SHADER_MODULE, module_, what);
}

Kernel& Kernel::operator=(Kernel&& other) noexcept {
    if (this == &other) return *this;
    release();
    device_ = std::exchange(other.device_, nullptr);
    pipeline_ = std::exchange(other.pipeline_, VK_NULL_HANDLE);
    layout_ = std::move(other.layout_);
    return *this;
}

void Kernel::release() {
    if (!device_) return;
    device_->vk().DestroyPipeline(device_->handle(), pipeline_, device_->allocator());
    device_ = nullptr;
    pipeline_ = VK_NULL_HANDLE;
}

Status Kernel::create(const Device& device, std::span<const uint32_t> spirv, const char* what,
                      std::span<const uint32_t> constants) {
    release();
    device_ = &device;
    ShaderModule module(device);
    if (const Status s = module.create(spirv, constants, what); s != Status::ok) return s;
    const std::span<const uint32_t> modules[] = {module.words()};
    if (const Status s = layout_.create(device, modules, 0, what); s != Status::ok) return s;
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module.handle();
    info.stage.pName = "main";
    std::vector<VkSpecializationMapEntry> entries;
    for (uint32_t id = 0; id < constants.size(); ++id)
        entries.push_back({id, id * static_cast<uint32_t>(sizeof(uint32_t)), sizeof(uint32_t)});
    const VkSpecializationInfo specialization{static_cast<uint32_t>(entries.size()), entries.data(),
                                              constants.size_bytes(), constants.data()};
    info.stage.pSpecializationInfo = &specialization;
    info.layout = layout_.pipeline();
    const CompileWatch watch(device, what);
    return device.made(device.vk().CreateComputePipelines(device.handle(), device.pipelineCache(), 1, &info,
                                                          device.allocator(), &pipeline_),
                       VK_OBJECT_TYPE_PIPELINE, pipeline_, what);
}

void Kernel::bind(VkCommandBuffer commands, VkDescriptorSet set) const {
    const DeviceTable& vk = device_->vk();
    vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
    vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.pipeline(), 0, 1, &set, 0,
                             nullptr);
}

void Kernel::dispatch(VkCommandBuffer commands, VkDescriptorSet set, uint32_t groupsX, uint32_t groupsY,
                      uint32_t groupsZ) const {
    bind(commands, set);
    device_->vk().CmdDispatch(commands, groupsX, groupsY, groupsZ);
}

void Kernel::dispatchOver(VkCommandBuffer commands, VkDescriptorSet set, VkExtent2D pixels) const {
    constexpr uint32_t edge = 8;
    dispatch(commands, set, (pixels.width + edge - 1) / edge, (pixels.height + edge - 1) / edge);
}

void Kernel::dispatchAlong(VkCommandBuffer commands, VkDescriptorSet set, uint32_t invocations,
                           uint32_t rows) const {
    constexpr uint32_t width = 64;
    dispatch(commands, set, (invocations + width - 1) / width, rows);
}

void Kernel::dispatchIndirect(VkCommandBuffer commands, VkDescriptorSet set, VkBuffer groups,
                              VkDeviceSize offset) const {
    bind(commands, set);
    device_->vk().CmdDispatchIndirect(commands, groups, offset);
}

} // namespace seaglass::gpu
