#include "metrics/repetition/fft.h"

#include <numbers>
#include <utility>

namespace demos {

namespace {

using Complex = std::complex<double>;

/// Cooley and Tukey 1965, radix 2: element i at values[i * stride].
void fft(Complex* values, size_t size, size_t stride) {
    for (size_t i = 1, j = 0; i < size; ++i) {
        size_t bit = size / 2;
        for (; j & bit; bit /= 2) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i * stride], values[j * stride]);
    }
    for (size_t length = 2; length <= size; length *= 2) {
        const Complex turn = std::polar(1.0, -2 * std::numbers::pi / static_cast<double>(length));
        for (size_t start = 0; start < size; start += length) {
            Complex factor = 1;
            for (size_t i = start; i < start + length / 2; ++i, factor *= turn) {
                Complex &even = values[i * stride], &odd = values[(i + length / 2) * stride];
                const Complex product = odd * factor;
                odd = even - product;
                even += product;
            }
        }
    }
}

} // namespace

void fft2d(std::vector<Complex>& values, size_t size) {
    for (size_t row = 0; row < size; ++row) fft(values.data() + row * size, size, 1);
    for (size_t column = 0; column < size; ++column) fft(values.data() + column, size, size);
}

} // namespace demos
