// Foam on breaking crests, and the whitecap laws that it is held to. No Vulkan.
//
// A wave breaks where the horizontal displacement of all cascades compresses its surface past a threshold,
// along the wind above all. Foam drifts with the water and fades: it dies after two or three decay times,
// bubbles below after nine. Steps of 1/4 s make it a function of the sea and the time alone, whatever frames
// were drawn, but for hosts that fall behind: simulate().
#pragma once

#include "seaglass/sea.h"

namespace seaglass {

/// How much breaks, and how long it shows.
struct FoamDesc {
    float bias = 0.0f;       ///< off the compression at which waves break, -1..1; 0: as whitecap laws say
    float decayTime = 3.85f; ///< to 1/e in the mean [s], 0.1..20 (Monahan and Zietlow 1969: salt water 3.85)
    float albedo = 0.6f;     ///< diffuse albedo of full foam, 0..1 (Koepke 1984: fresh foam about 0.5)
};

/// Share of the sea that whitecaps cover, 3.84e-6 U^3.41 (Monahan and O'Muircheartaigh 1980); U10 [m/s].
double whitecapsOfMonahan(double windSpeed);
/// 3.18e-5 (U - 3.70)^3, then 4.82e-6 (U + 1.98)^3 (Callaghan, de Leeuw, Cohen and O'Dowd 2008); U10 [m/s].
double whitecapsOfCallaghan(double windSpeed);

/// Share of the sea, from above, that foam covers at `time`, measured on the backend's maps; 0 of a flat sea.
/// Takes tenths of a second: some seventy evaluations. False: out of memory, or `foam` is out of range.
bool whitecapCover(const Sea& sea, const WavesBackend& backend, const FoamDesc& foam, double time,
                   double* cover);

FieldTable fieldsOf(const FoamDesc&); ///< its settings

} // namespace seaglass
