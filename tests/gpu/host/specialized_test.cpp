// Shaders for given constants declare what is used, and stay valid.
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <spirv-tools/libspirv.hpp>

#include "gpu/pipeline/specialized.h"
#include "gpu/pipeline/spirv_bindings.h"
#include "spirv/specialized.comp.h"
#include "tests/gpu/host/shader_work.h"

namespace {

using namespace seaglass;
using Constants = std::vector<uint32_t>;
using Numbers = std::set<uint32_t>;

Numbers bindingsOf(std::span<const uint32_t> words) {
    const std::span<const uint32_t> modules[] = {words};
    const std::optional<gpu::ShaderInterface> interface = gpu::interfaceOf(modules);
    Numbers numbers;
    if (interface)
        for (const gpu::ShaderBinding& binding : interface->bindings) numbers.insert(binding.number);
    return numbers;
}

std::string whyInvalid(const std::vector<uint32_t>& words) {
    std::string why;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* text) { why = text; });
    if (!tools.Validate(words) && why.empty()) why = "?";
    return why;
}

TEST(Specialized, DeclareWhatConstantsLeave) {
    struct Case {
        Constants constants;
        Numbers bindings;
    };
    const Case cases[] = {
        {{}, {0}},
        {{1, 0, 0}, {0, 1, 3}},
        {{0, 1, 0}, {0, 2, 3, 5}},
        {{0, 0, 1}, {0}},
        {{0, 0, 2}, {0, 4}},
        {{1, 1, 0}, {0, 1, 2, 3, 5}},
        {{1}, {0, 1, 3}},
        {{1, 1, 2}, {0, 1, 2, 3, 4, 5}},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::PrintToString(c.constants));
        const std::vector<uint32_t> left = gpu::specialized(specialized_comp, c.constants);
        EXPECT_EQ(bindingsOf(left), c.bindings);
        EXPECT_EQ(whyInvalid(left), "");
        EXPECT_LE(left.size(), std::size(specialized_comp));
    }
}

// What an optimiser makes of both is as much.
TEST(Specialized, DoWhatTheWholeDoes) {
    const std::vector<uint32_t> whole(std::begin(specialized_comp), std::end(specialized_comp));
    for (uint32_t first = 0; first < 2; ++first)
        for (uint32_t second = 0; second < 2; ++second)
            for (uint32_t kind = 0; kind < 3; ++kind) {
                const Constants constants = {first, second, kind};
                SCOPED_TRACE(testing::PrintToString(constants));
                const tests::ShaderWork of = tests::workOf(whole, constants);
                const tests::ShaderWork ofLeft =
                    tests::workOf(gpu::specialized(specialized_comp, constants), constants);
                EXPECT_EQ(ofLeft.instructions, of.instructions);
                EXPECT_EQ(ofLeft.reads, of.reads);
            }
}

TEST(Specialized, AreSmallerTheLessIsUsed) {
    const Constants none = {0, 0, 0}, all = {1, 1, 2};
    EXPECT_LT(gpu::specialized(specialized_comp, none).size(),
              gpu::specialized(specialized_comp, all).size());
}

} // namespace
