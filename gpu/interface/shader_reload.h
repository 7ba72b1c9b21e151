// Of builds with SEAGLASS_SHADER_RELOAD alone: other words for pipelines than those that were built in. The
// one thing here that is the process's and no context's.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace seaglass::gpu {

/// By what name built-in words are known: a static object beside them.
class ShaderName {
  public:
    ShaderName(const uint32_t* words, const char* name);
};

/// Gives other words for a shader, or none where the built-in ones serve; false where there should be others,
/// and the pipeline that is being made is then none. Called on the thread that calls Seaglass.
using ShaderSource = std::function<bool(const std::string& name, std::vector<uint32_t>& words)>;
/// For pipelines made from here on; null: as built in.
void setShaderSource(ShaderSource source);

/// What the source, if there is one, says of built-in words.
bool reloadShader(std::span<const uint32_t> builtIn, std::vector<uint32_t>& out);

} // namespace seaglass::gpu
