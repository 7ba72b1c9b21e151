// The waves of one cascade: complex amplitudes h0(k) on the lattice k = (m, n) 2 pi / patch, drawn once.
//
// With h(k,t) = h0(k) e^{iwt} + conj(h0(-k)) e^{-iwt} the height is the sum of h(k,t) e^{ik.x} over all k.
// The part h0(k) travels towards -k. E|h0|^2 = S(w) D(theta) (dw/dk)/k dk^2 / 2, so that the height's
// variance is the spectrum's.
#pragma once

#include "water/interface/sea_contents.h"
#include "water/spectrum/wave_systems.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seaglass {

/// The half plane n >= 0 of the lattice; the other half is its conjugate. Rows n = 0..reach, in each columns
/// m = -reach..reach, padded with zeros to a multiple of `lanes`. In row 0 only m > 0 is filled.
struct Modes {
    static constexpr size_t lanes = 8;

    int32_t reach = 0;
    size_t pitch = 0; ///< elements from one row to the next

    std::vector<float> forwardRe, forwardIm;   ///< h0(k) [m]
    std::vector<float> backwardRe, backwardIm; ///< conj(h0(-k)) [m]
    std::vector<uint32_t> frequency;           ///< index n of the quantised frequency, see phase.h
    std::vector<float> inverseK;               ///< 1/|k| [m]
    double expected = 0;                       ///< variance of the height, of all seeds in the mean [m^2]

    size_t at(int32_t m, int32_t n) const {
        return static_cast<size_t>(n) * pitch + static_cast<size_t>(m + reach);
    }
};

/// Of the height, of a mode and its conjugate [m^2].
inline double varianceAt(const Modes& modes, size_t at) {
    const auto square = [](float x) { return static_cast<double>(x) * static_cast<double>(x); };
    return 2 * (square(modes.forwardRe[at]) + square(modes.forwardIm[at]) + square(modes.backwardRe[at]) +
                square(modes.backwardIm[at]));
}

/// Draws the modes of cascade number `index`, and sets its variance. Each mode depends only on the sea's
/// systems, the patch, the seed and (index, m, n): not on the number of samples. May throw bad_alloc.
Modes drawModes(const SeaDesc& desc, const WaveSystems& systems, uint32_t index, Cascade& cascade);

} // namespace seaglass
