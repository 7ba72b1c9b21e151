// Which cascades break, and from which compression on: set so that foam covers what the whitecap laws say.
#pragma once

#include "water/interface/waves_backend.h"

namespace seaglass {

/// The first `count` cascades break, together: foam is the product of what each of them lets through. Where a
/// sum of Gaussians is rare its parts are, most likely, as large as their shares of its variance are: each is
/// asked for that much.
struct Breaking {
    uint32_t count = 0;
    float threshold[maxCascades] = {}; ///< compression of the cascade alone, above which it foams
    float softness[maxCascades] = {};  ///< how far above it foams fully
    float share[maxCascades] = {};     ///< of the variance; they sum to 1
    /// How compressed water is: of -dDx/du, -dDz/dv and -dDx/dv. It is along the wind above all, since crests
    /// stand across it.
    float along[3] = {};
    /// Sum of the compressions, each times what it counts, from which waves break at this moment, give or
    /// take `nowWidth`. Beside the cascades that break the next one does, whose waves break up long crests.
    float now = 0, nowWidth = 1;
    float counts[maxCascades] = {};
    float runs[maxCascades][2] = {}; ///< how fast crests of a cascade run with the wind, along u and v [m/s]
    float hidden = 0;                ///< variance of it, to one of the slopes, both axes together
    float narrower = 0; ///< of what breaks now, share that compression takes, to a variance of slopes

    float compression(float uu, float vv, float uv) const {
        return -(along[0] * uu + along[1] * vv + along[2] * uv);
    }
};

/// Of what breaks at a moment, the share that lies where the foam before it is not white already: of a sea
/// at 15 m/s, such that a picture from any height is as white as the sea.
constexpr float foamBreaksApart = 0.85f;

Breaking breakingOf(const Sea& sea, const FoamDesc& foam);

/// Share of the sea that whitecaps cover, 3.84e-6 U^3.41 (Monahan and O'Muircheartaigh 1980); U10 [m/s].
double whitecapsOfMonahan(double windSpeed);
/// 3.18e-5 (U - 3.70)^3, then 4.82e-6 (U + 1.98)^3 (Callaghan, de Leeuw, Cohen and O'Dowd 2008); U10 [m/s].
double whitecapsOfCallaghan(double windSpeed);

/// Share of the sea, from above, that foam covers at `time`, measured on the backend's maps; 0 of a flat sea.
/// Takes tenths of a second: some seventy evaluations. False: out of memory, or `foam` is out of range.
bool whitecapCover(const Sea& sea, const WavesBackend& backend, const FoamDesc& foam, double time,
                   double* cover);

} // namespace seaglass
