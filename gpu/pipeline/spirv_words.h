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
enum Op : uint32_t {
    opNop = 0,
    opUndef = 1,
    opName = 5,
    opMemberName = 6,
    opLine = 8,
    opExtInst = 12,
    opEntryPoint = 15,
    opCapability = 17,
    opTypeImage = 25,
    opTypeSampledImage = 27,
    opTypeStruct = 30,
    opTypePointer = 32,
    opConstantTrue = 41,
    opConstantFalse = 42,
    opConstant = 43,
    opSpecConstantTrue = 48,
    opSpecConstantFalse = 49,
    opSpecConstant = 50,
    opSpecConstantOp = 52,
    opFunction = 54,
    opFunctionParameter = 55,
    opFunctionEnd = 56,
    opFunctionCall = 57,
    opVariable = 59,
    opImageTexelPointer = 60,
    opLoad = 61,
    opStore = 62,
    opCopyMemory = 63,
    opAccessChain = 65,
    opInBoundsAccessChain = 66,
    opArrayLength = 68,
    opDecorate = 71,
    opMemberDecorate = 72,
    opCopyObject = 83,
    opImageWrite = 99,
    opIAdd = 128,
    opISub = 130,
    opIMul = 132,
    opLogicalEqual = 164,
    opLogicalNotEqual = 165,
    opLogicalOr = 166,
    opLogicalAnd = 167,
    opLogicalNot = 168,
    opSelect = 169,
    opIEqual = 170,
    opINotEqual = 171,
    opUGreaterThan = 172,
    opSGreaterThan = 173,
    opUGreaterThanEqual = 174,
    opSGreaterThanEqual = 175,
    opULessThan = 176,
    opSLessThan = 177,
    opULessThanEqual = 178,
    opSLessThanEqual = 179,
    opBitwiseAnd = 199,
    opControlBarrier = 224,
    opMemoryBarrier = 225,
    opAtomicLoad = 227,
    opAtomicStore = 228,
    opAtomicXor = 242,
    opPhi = 245,
    opLoopMerge = 246,
    opSelectionMerge = 247,
    opLabel = 248,
    opBranch = 249,
    opBranchConditional = 250,
    opSwitch = 251,
    opReturnValue = 254,
    opUnreachable = 255,
    opNoLine = 317,
    opTerminateInvocation = 4416,
    opDemote = 5380,
};
constexpr uint32_t decorationSpecId = 1, decorationBuiltIn = 11, decorationBinding = 33;
constexpr uint32_t builtInViewIndex = 4440, capabilityMultiView = 4439;

using Instruction = std::span<const uint32_t>;

inline Op opOf(Instruction words) {
    return static_cast<Op>(words[0] & 0xffffu);
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
