// Places of a pixel, as even as any number of them can be.
#pragma once

#include <array>
#include <cstdint>

namespace demos {

/// Within half a pixel; of Halton's sequence to the bases 2 and 3.
std::array<double, 2> haltonPx(uint32_t index);

} // namespace demos
