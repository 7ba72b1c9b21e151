// Inverse Fourier transforms of many lines at once, without a library: for those who link the sea alone.
#pragma once

#include <cstddef>
#include <vector>

namespace seaglass {

/// Four neighbouring lines.
using Float4 = float __attribute__((vector_size(16)));

struct Complex4 {
    Float4 re;
    Float4 im;
};

/// Unnormalised, e^{+2 pi i jk/n}, along the rows of an array of n rows: a point is a row, and each of its
/// elements belongs to lines of its own.
class InverseFourier {
  public:
    /// `points` is a power of two, 16 or more.
    explicit InverseFourier(size_t points);

    /// Transforms `rows`, points * width elements; `scratch` holds as many.
    void transform(Complex4* rows, Complex4* scratch, size_t width) const;

  private:
    size_t points_;
    std::vector<float> cosine_, sine_; ///< of k/points turns, k < points
};

} // namespace seaglass
