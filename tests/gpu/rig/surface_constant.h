// The numbers of the surface's specialisation constants, by their names.
#pragma once

#include <cstddef>
#include <string_view>

namespace tests {

constexpr size_t surfaceConstant(std::string_view wanted) {
#define CONSTANT(number, type, name, usual)                                                                  \
    if (wanted == #name) return number;
#include "shaders/shared/surface_constants.h"
#undef CONSTANT
    return ~size_t{0};
}

constexpr size_t surfaceConstants = 0
#define CONSTANT(number, type, name, usual) +1
#include "shaders/shared/surface_constants.h"
#undef CONSTANT
    ;

} // namespace tests
