// One axis of a separable filter, over rows of floats.
#pragma once

#include <cstddef>
#include <vector>

namespace demos {

/// Rows are as long as a whole number of these: so many values are summed at once.
constexpr size_t valuesAtOnce = 16;

/// Weights of a pixel and its neighbours to one side.
struct Kernel {
    enum class Kind {
        mean,  ///< the other side has the same weights
        slope, ///< their negatives, and the pixel none
        bend ///< the same, and the pixel what makes the sum 0: of an even row there is nothing left, not even
             ///< rounding
    } kind = Kind::mean;
    std::vector<float> weights; ///< of the pixel itself first

    size_t radius() const { return weights.size() - 1; }
};

/// to[i] is the weighed sum of at[-radius][i] .. at[radius][i]: pointers to one row, moved, filter along x;
/// pointers to rows filter along y.
void weigh(const Kernel& kernel, const float* const* at, float* to, size_t width);

} // namespace demos
