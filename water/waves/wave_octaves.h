// A sea's waves by octaves of their length.
#pragma once

#include <array>

#include "seaglass/sea.h"

namespace seaglass {

constexpr int waveOctaves = 24;
constexpr double longestOctave = 512; ///< of the wavelengths told apart [m]; what is longer counts to it

/// The octave of a wavelength, 0 the longest.
int octaveOf(double wavelength);

/// Variance of the sum of the waves in each octave, each times its wavenumber to this power: 0, of the height
/// [m^2].
std::array<double, waveOctaves> varianceByOctave(const Sea& sea, int power);

} // namespace seaglass
