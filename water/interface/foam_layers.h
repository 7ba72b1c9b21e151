// How foam lies on the sea: it drifts with the water at the surface, and the pattern that it breaks up into
// with it, in two layers, which the wind draws out.
#pragma once

#include "water/interface/sea_contents.h"

namespace seaglass {

/// How far a cascade's foam has drifted along u and v, as far as its tile tells, 0..1 [tiles]. The wind
/// drives it, and Stokes drift is in that. In a loop it goes by whole samples, so that foam loops with the
/// sea.
struct FoamDrift {
    double u = 0, v = 0;
};
FoamDrift foamDriftOf(const SeaDesc& sea, const Cascade& cascade, double time);

/// A place p shows what lies at p - w (w.p) - drift of a layer.
struct FoamLayer {
    double u = 0, v = 0;           ///< w: the wind's direction, times sqrt(1 - 1/stretch)
    double driftU = 0, driftV = 0; ///< by now, as far as what repeats tells [m]

    void apply(double& placeU, double& placeV) const {
        const double along = u * placeU + v * placeV;
        placeU -= u * along + driftU;
        placeV -= v * along + driftV;
    }
};

/// Of rafts and lace: twice as long as wide in a gale. `repeat`: after which the layer comes round again [m].
FoamLayer foamLaceOf(const SeaDesc& sea, double time, double repeat);
/// Of the lines along the wind between Langmuir's cells, which show from 12 m/s on (Smith 1992).
FoamLayer foamWindrowsOf(const SeaDesc& sea, double time, double repeat);

} // namespace seaglass
