// SPIR-V as a list of instructions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace seaglass::gpu::spirv {

constexpr size_t headerWords = 5;

// Numbers of the SPIR-V specification, 3.
constexpr uint32_t opName = 5, opEntryPoint = 15, opTypeImage = 25, opTypeSampledImage = 27,
                   opTypeStruct = 30, opTypePointer = 32, opFunction = 54, opFunctionParameter = 55,
                   opFunctionEnd = 56, opVariable = 59, opLoad = 61, opDecorate = 71, opLabel = 248,
                   opUnreachable = 255;
constexpr uint32_t decorationBinding = 33;

using Instruction = std::span<const uint32_t>;

inline uint32_t opOf(Instruction words) {
    return words[0] & 0xffffu;
}

inline std::vector<Instruction> instructionsOf(std::span<const uint32_t> module) {
    std::vector<Instruction> list;
    for (size_t at = headerWords; at < module.size();) {
        const size_t count = std::max(module[at] >> 16, 1u);
        list.push_back(module.subspan(at, std::min(count, module.size() - at)));
        at += count;
    }
    return list;
}

} // namespace seaglass::gpu::spirv
