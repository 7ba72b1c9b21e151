// The SPIR-V that is built into the libraries, by the names of its files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tests {

struct BuiltShader {
    std::string_view name; ///< such as "surface.vert"
    std::span<const uint32_t> words;
};

std::span<const BuiltShader> builtShaders();

/// Of these words, or of what specialized() leaves of them; "?" where no library has them built in.
std::string builtShaderName(std::span<const uint32_t> words);

} // namespace tests
