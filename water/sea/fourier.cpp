#include "water/sea/fourier.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace seaglass {
namespace {

struct Turn {
    float cosine;
    float sine;
};

Complex4 operator+(const Complex4& a, const Complex4& b) {
    return {a.re + b.re, a.im + b.im};
}
Complex4 operator-(const Complex4& a, const Complex4& b) {
    return {a.re - b.re, a.im - b.im};
}
Complex4 timesI(const Complex4& a) {
    return {-a.im, a.re};
}
Complex4 operator*(const Complex4& a, const Turn& w) {
    return {a.re * w.cosine - a.im * w.sine, a.re * w.sine + a.im * w.cosine};
}

} // namespace

InverseFourier::InverseFourier(size_t points) : points_(points), cosine_(points), sine_(points) {
    for (size_t k = 0; k < points; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
        cosine_[k] = static_cast<float>(std::cos(angle));
        sine_[k] = static_cast<float>(std::sin(angle));
    }
}

// Stockham's autosort in steps of four, and one of two where the points are no power of four.
void InverseFourier::transform(Complex4* rows, Complex4* scratch, size_t width) const {
    Complex4 *from = rows, *to = scratch;
    const auto turn = [this](size_t k) { return Turn{cosine_[k], sine_[k]}; };
    size_t done = 1; // points of the transforms that are finished
    for (; done * 4 <= points_; done *= 4) {
        const size_t quarter = points_ / 4;
        for (size_t j = 0; j < quarter; ++j) {
            const size_t within = j % done, step = within * (quarter / done);
            const Turn w1 = turn(step), w2 = turn(2 * step), w3 = turn(3 * step);
            const Complex4* in = from + j * width;
            Complex4* out = to + ((j - within) * 4 + within) * width;
            for (size_t x = 0; x < width; ++x) {
                const Complex4 a = in[x], b = in[x + quarter * width] * w1;
                const Complex4 c = in[x + 2 * quarter * width] * w2, d = in[x + 3 * quarter * width] * w3;
                const Complex4 ac = a + c, acLess = a - c, bd = b + d, bdLess = timesI(b - d);
                out[x] = ac + bd;
                out[x + done * width] = acLess + bdLess;
                out[x + 2 * done * width] = ac - bd;
                out[x + 3 * done * width] = acLess - bdLess;
            }
        }
        std::swap(from, to);
    }
    if (done < points_) {
        for (size_t j = 0; j < done; ++j) {
            const Turn w = turn(j);
            const Complex4* in = from + j * width;
            Complex4* out = to + j * width;
            for (size_t x = 0; x < width; ++x) {
                const Complex4 a = in[x], b = in[x + done * width] * w;
                out[x] = a + b;
                out[x + done * width] = a - b;
            }
        }
        std::swap(from, to);
    }
    if (from != rows) std::copy_n(from, points_ * width, rows);
}

} // namespace seaglass
