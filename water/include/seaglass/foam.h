// Foam on breaking crests, and the whitecap laws that it is held to. No Vulkan.
//
// A wave breaks where its surface is compressed, along the wind above all: where the horizontal displacement
// of all cascades together passes a threshold. What it leaves behind drifts with the water and fades. Foam is
// stepped at fixed times, a whole multiple of 1/4 s each, and dies after two or three decay times, the
// bubbles below it after nine: it is a function of the sea and the time alone, whatever frames were drawn
// before. But for hosts that fall behind: a call of simulate() more than 2 s after another that had to catch
// up by more takes eight times in place of all between, at even distances.
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// How much breaks, and how long it shows.
struct FoamDesc {
    /// Taken off the compression at which waves break, -1..1: 0 covers what the whitecap laws say for the
    /// wind, more is foamier.
    float bias = 0.0f;
    /// In which whitecaps fade to 1/e in the mean [s], 0.1..20 (Monahan and Zietlow 1969: salt water 3.85).
    float decayTime = 3.85f;
    float albedo = 0.6f; ///< diffuse albedo of full foam, 0..1 (Koepke 1984: fresh foam about 0.5)
};

/// Share of the sea that whitecaps cover, 3.84e-6 U^3.41 (Monahan and O'Muircheartaigh 1980); U10 [m/s].
double whitecapsOfMonahan(double windSpeed);
/// 3.18e-5 (U - 3.70)^3, then 4.82e-6 (U + 1.98)^3 (Callaghan, de Leeuw, Cohen and O'Dowd 2008); U10 [m/s].
double whitecapsOfCallaghan(double windSpeed);

/// Share of the sea, as seen from above, that the foam drawn at `time` covers: measured on the simulated
/// surface, with the backend's maps. 0 for a flat sea. False when out of memory, or when `foam` is out of
/// range. Costs some seventy evaluations of the sea: tenths of a second.
bool whitecapCover(const Sea& sea, const WavesBackend& backend, const FoamDesc& foam, double time,
                   double* cover);

} // namespace seaglass
