#include "tests/gpu/rig/swapped_shaders.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gpu/interface/shader_reload.h"

namespace tests {

void swapShaders() {
    const char* const folder = std::getenv("SEAGLASS_SWAPPED_SHADERS");
    if (!folder) return;
    seaglass::gpu::setShaderSource([folder](const std::string& name, std::vector<uint32_t>& words) {
        std::ifstream in(std::filesystem::path(folder) / (name + ".spv"), std::ios::binary | std::ios::ate);
        words.resize(in ? static_cast<size_t>(in.tellg()) / sizeof(uint32_t) : 0);
        in.seekg(0);
        in.read(reinterpret_cast<char*>(words.data()),
                static_cast<std::streamsize>(words.size() * sizeof(uint32_t)));
        return true;
    });
}

} // namespace tests
