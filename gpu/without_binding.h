// A shader of which an image is never read, without what would read it. Vulkan wants a descriptor for all
// that a shader could use, whatever its constants say (VUID-vkCmdDraw-None-08114); this one cannot use it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace seaglass::gpu {

constexpr uint32_t allBindings = ~0u; ///< no binding: a shader stays whole

/// SPIR-V without the variable of this binding, if there is one. Functions that use it end where they begin,
/// as unreachable: constants must see to it that they are not called.
std::vector<uint32_t> withoutBinding(std::span<const uint32_t> spirv, uint32_t binding);

} // namespace seaglass::gpu
