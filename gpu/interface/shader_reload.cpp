#include "gpu/interface/shader_reload.h"

#include <map>

namespace seaglass::gpu {

namespace {

/// Filled before main(), in an order that nobody knows.
std::map<const uint32_t*, std::string>& names() {
    static std::map<const uint32_t*, std::string> names;
    return names;
}

ShaderSource& shaderSource() {
    static ShaderSource source;
    return source;
}

} // namespace

ShaderName::ShaderName(const uint32_t* words, const char* name) {
    names()[words] = name;
}

void setShaderSource(ShaderSource source) {
    shaderSource() = std::move(source);
}

bool reloadShader(std::span<const uint32_t> builtIn, std::vector<uint32_t>& out) {
    const auto known = names().find(builtIn.data());
    return known == names().end() || !shaderSource() || shaderSource()(known->second, out);
}

} // namespace seaglass::gpu
