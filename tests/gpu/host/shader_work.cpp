#include "tests/gpu/host/shader_work.h"

#include <map>
#include <unordered_map>

#include <gtest/gtest.h>
#include <spirv-tools/optimizer.hpp>

namespace tests {

namespace {

using Words = std::vector<uint32_t>;

/// Inlined first: else what a caller says would not reach the branch that hangs on it.
Words specialised(const Words& spirv, const Words& constants) {
    std::unordered_map<uint32_t, Words> values;
    for (uint32_t id = 0; id < constants.size(); ++id) values[id] = {constants[id]};
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
    optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&,
                                    const char* text) { ADD_FAILURE() << text; });
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateMergeReturnPass())
        .RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreatePrivateToLocalPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass())
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass());
    Words out;
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    EXPECT_TRUE(optimizer.Run(spirv.data(), spirv.size(), &out, options));
    return out;
}

// As the SPIR-V specification numbers them, 3.52.
constexpr uint32_t opFunction = 54, opFunctionEnd = 56, opFunctionCall = 57, opEntryPoint = 15;
constexpr uint32_t opImageSampleImplicitLod = 87, opImageRead = 98;

struct Function {
    ShaderWork own;
    std::vector<uint32_t> calls;
};

ShaderWork withCalls(const std::map<uint32_t, Function>& functions, uint32_t id) {
    const Function& function = functions.at(id);
    ShaderWork sum = function.own;
    for (const uint32_t called : function.calls) {
        const ShaderWork more = withCalls(functions, called);
        sum.reads += more.reads;
        sum.instructions += more.instructions;
    }
    return sum;
}

ShaderWork counted(const Words& spirv) {
    std::map<uint32_t, Function> functions;
    Function* within = nullptr;
    uint32_t entry = 0;
    for (size_t i = 5; i < spirv.size(); i += spirv[i] >> 16) {
        const uint32_t operation = spirv[i] & 0xffffu;
        if (operation == opEntryPoint) entry = spirv[i + 2];
        if (operation == opFunction) within = &functions[spirv[i + 2]];
        if (within) {
            ++within->own.instructions;
            within->own.reads += operation >= opImageSampleImplicitLod && operation <= opImageRead;
            if (operation == opFunctionCall) within->calls.push_back(spirv[i + 3]);
        }
        if (operation == opFunctionEnd) within = nullptr;
    }
    return withCalls(functions, entry);
}

} // namespace

ShaderWork workOf(const Words& spirv, const Words& constants) {
    static std::map<std::pair<Words, Words>, ShaderWork> known;
    const auto [entry, fresh] = known.try_emplace({spirv, constants});
    if (fresh) entry->second = counted(specialised(spirv, constants));
    return entry->second;
}

} // namespace tests
