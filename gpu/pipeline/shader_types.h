// GLSL's names for the types of blocks that C++ and shaders share: shaders/shared. All are as wide in C++ as
// std140 lays them out.
#pragma once

#include <cstdint>

#include <glm/mat3x4.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace seaglass {

using uint = uint32_t;
using glm::ivec2;
using glm::ivec4;
using glm::mat3x4;
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec4;

} // namespace seaglass
