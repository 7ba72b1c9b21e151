#include "metrics/repetition/repetition.h"

#include <array>
#include <cmath>
#include <vector>

#include "metrics/repetition/fft.h"

namespace demos {

namespace {

/// Legendre's polynomials up to the second, sampled: all but orthogonal, so that each one's share is a sum.
std::array<double, 3> legendre(size_t at, size_t size) {
    const double x = (2 * static_cast<double>(at) + 1) / static_cast<double>(size) - 1;
    return {1, std::sqrt(3.0) * x, std::sqrt(5.0) * (3 * x * x - 1) / 2};
}

std::vector<double> luminances(const PixelView& image) {
    std::vector<double> values(image.pixels());
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = 0.2126 * double{image.rgba[4 * i]} + 0.7152 * double{image.rgba[4 * i + 1]} +
                    0.0722 * double{image.rgba[4 * i + 2]};
    return values;
}

void takeSmoothPart(std::vector<double>& values, size_t size) {
    constexpr size_t orders[][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (const auto& [across, down] : orders) {
        double share = 0;
        for (size_t i = 0; i < values.size(); ++i)
            share += values[i] * legendre(i % size, size)[across] * legendre(i / size, size)[down];
        share /= static_cast<double>(values.size());
        for (size_t i = 0; i < values.size(); ++i)
            values[i] -= share * legendre(i % size, size)[across] * legendre(i / size, size)[down];
    }
}

} // namespace

Repetition repetition(const PixelView& image, double beyond) {
    const size_t size = image.width, padded = 2 * size;
    std::vector<double> values = luminances(image);
    takeSmoothPart(values, size);
    std::vector<std::complex<double>> field(padded * padded);
    for (size_t i = 0; i < values.size(); ++i) field[i / size * padded + i % size] = values[i];
    fft2d(field, padded);
    for (std::complex<double>& f : field) f = std::norm(f);
    fft2d(field, padded); // of what is even: the way back

    Repetition found;
    const double all = field[0].real();
    for (size_t down = 0; down < size && all > 0; ++down)
        for (size_t x = 0; x < padded; ++x) {
            const double right = static_cast<double>(x) - (x < size ? 0.0 : static_cast<double>(padded));
            if (std::hypot(right, static_cast<double>(down)) <= beyond) continue;
            const double value = field[down * padded + x].real() / all;
            if (value > found.most) found = {value, static_cast<int>(right), static_cast<int>(down)};
        }
    return found;
}

} // namespace demos
