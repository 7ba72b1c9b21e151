// A shader that notes where it does what Vulkan leaves open: SPIR-V with tests put in before such
// instructions.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tests {

/// An instruction that is tested.
struct CheckedPlace {
    std::string violation; ///< that it would be, in words
    std::string function;
    std::string line; ///< file:line, where the shader was built with lines
};

/// Notes on the device: word 0 counts invocations with a violation, then each place has a bit.
struct CheckedShader {
    std::vector<uint32_t> spirv;
    std::string stage;
    std::vector<CheckedPlace> places;

    size_t noteWords() const { return 1 + (places.size() + 31) / 32; }
    static bool noted(std::span<const uint32_t> notes, size_t place) {
        return notes[1 + place / 32] >> place % 32 & 1u;
    }
};

/// Rounds of all loops of one invocation together beyond which each further one is a violation.
constexpr uint32_t mostRounds = 20000;

/// Gives the device address of so many words, which are zero.
using ReserveNotes = std::function<uint64_t(size_t words)>;

/// None where the words are no SPIR-V of one entry point. The shader then wants bufferDeviceAddress, and
/// fragmentStoresAndAtomics or vertexPipelineStoresAndAtomics. Helper invocations note nothing.
std::optional<CheckedShader> checkedShader(std::span<const uint32_t> spirv, const ReserveNotes& reserve);

} // namespace tests
