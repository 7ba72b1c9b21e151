// A shader for given constants, without what they leave out: functions that are not called, and variables
// that nothing reads or writes. Vulkan wants a descriptor for all that a shader could use, whatever its
// constants say (VUID-vkCmdDraw-None-08114), and compilers take long to find out what is left.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace seaglass::gpu {

/// SPIR-V for these values of its specialisation constants, number 0 first; others keep their defaults. It
/// still has to be given them. Blocks that branches on constants never reach stay, empty.
std::vector<uint32_t> specialized(std::span<const uint32_t> spirv, std::span<const uint32_t> constants);

} // namespace seaglass::gpu
