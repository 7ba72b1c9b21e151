#include "gpu/pipeline/spirv_bindings.h"

#include <map>

#include "gpu/pipeline/spirv_words.h"

namespace seaglass::gpu {

namespace {

using namespace spirv;

constexpr uint32_t classUniform = 2, classPushConstant = 9, classStorageBuffer = 12;
constexpr uint32_t imageIsStored = 2; // an image type's operand "Sampled"

VkShaderStageFlags stageOf(uint32_t executionModel) {
    switch (executionModel) {
    case 0:
        return VK_SHADER_STAGE_VERTEX_BIT;
    case 4:
        return VK_SHADER_STAGE_FRAGMENT_BIT;
    default:
        return VK_SHADER_STAGE_COMPUTE_BIT;
    }
}

/// `type`: what a variable of this storage class points at.
VkDescriptorType descriptorOf(Instruction type, uint32_t storageClass) {
    switch (opOf(type)) {
    case opTypeSampledImage:
        return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case opTypeImage:
        if (type[7] == imageIsStored) return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        break;
    case opTypeStruct:
        if (storageClass == classUniform) return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        if (storageClass == classStorageBuffer) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        break;
    default:
        break;
    }
    return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

/// Of a storage image: by the numbers of the SPIR-V specification, 3.11.
VkFormat formatOf(Instruction type) {
    switch (type[8]) {
    case 1:
        return VK_FORMAT_R32G32B32A32_SFLOAT;
    case 2:
        return VK_FORMAT_R16G16B16A16_SFLOAT;
    case 3:
        return VK_FORMAT_R32_SFLOAT;
    case 7:
        return VK_FORMAT_R16G16_SFLOAT;
    case 9:
        return VK_FORMAT_R16_SFLOAT;
    default:
        return VK_FORMAT_UNDEFINED;
    }
}

/// What one module declares ahead of its functions.
struct Declarations {
    VkShaderStageFlags stage = 0;
    std::map<uint32_t, uint32_t> numbers; ///< by variable
    std::map<uint32_t, Instruction> types;
    std::vector<Instruction> variables;
};

Declarations declarationsOf(std::span<const uint32_t> module) {
    Declarations out;
    for (const Instruction i : instructionsOf(module)) {
        const uint32_t op = opOf(i);
        if (op == opFunction) break;
        if (op == opEntryPoint) out.stage = stageOf(i[1]);
        if (op == opDecorate && i[2] == decorationBinding) out.numbers[i[1]] = i[3];
        if (op == opTypeImage || op == opTypeSampledImage || op == opTypeStruct || op == opTypePointer)
            out.types[i[1]] = i;
        if (op == opVariable) out.variables.push_back(i);
    }
    return out;
}

/// False where it is there with another type or format.
bool add(const ShaderBinding& binding, std::map<uint32_t, ShaderBinding>& all) {
    ShaderBinding& known = all.try_emplace(binding.number, binding).first->second;
    known.stages |= binding.stages;
    return known.type == binding.type && known.format == binding.format &&
           binding.type != VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

} // namespace

std::optional<ShaderInterface> interfaceOf(std::span<const std::span<const uint32_t>> modules) {
    ShaderInterface out;
    std::map<uint32_t, ShaderBinding> all;
    for (const std::span<const uint32_t> module : modules) {
        const Declarations declared = declarationsOf(module);
        for (const Instruction variable : declared.variables) {
            const uint32_t storageClass = variable[3];
            if (storageClass == classPushConstant) out.pushedTo |= declared.stage;
            const auto number = declared.numbers.find(variable[2]);
            if (number == declared.numbers.end()) continue;
            const auto type = declared.types.find(declared.types.at(variable[1])[3]);
            const VkDescriptorType descriptor = type == declared.types.end()
                                                    ? VK_DESCRIPTOR_TYPE_MAX_ENUM
                                                    : descriptorOf(type->second, storageClass);
            const VkFormat format =
                descriptor == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE ? formatOf(type->second) : VK_FORMAT_UNDEFINED;
            if (!add({number->second, descriptor, declared.stage, format}, all)) return std::nullopt;
        }
    }
    for (const auto& [number, binding] : all) out.bindings.push_back(binding);
    return out;
}

} // namespace seaglass::gpu
