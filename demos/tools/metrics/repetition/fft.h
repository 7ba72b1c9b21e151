#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace demos {

/// Forward transform in place, unscaled, of a square of size x size, a power of two.
void fft2d(std::vector<std::complex<double>>& values, size_t size);

} // namespace demos
