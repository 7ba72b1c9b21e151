#include "host/lens/halton.h"

#include <cstddef>

namespace demos {

std::array<double, 2> haltonPx(uint32_t index) {
    std::array<double, 2> at = {-0.5, -0.5};
    for (size_t axis = 0; axis < 2; ++axis) {
        const uint32_t base = axis == 0 ? 2 : 3;
        double digit = 1;
        for (uint32_t i = index + 1; i > 0; i /= base) {
            digit /= base;
            at[axis] += digit * (i % base);
        }
    }
    return at;
}

} // namespace demos
