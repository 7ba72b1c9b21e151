// What a shader still does once its specialisation constants are what a pipeline says: the driver leaves the
// rest out, so that what is counted is what is paid for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tests {

struct ShaderWork {
    size_t reads = 0; ///< of images: samples, gathers, fetches; one in a loop is one
    size_t instructions = 0;
};

/// `constants` are the words of numbers 0 and on.
ShaderWork workOf(const std::vector<uint32_t>& spirv, const std::vector<uint32_t>& constants);

} // namespace tests
